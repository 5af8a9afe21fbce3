"""Whatever a launch file says, its evaluation ends soon and stays small: cycles, growth, and what multiplies."""

from __future__ import annotations

import resource
import time
from pathlib import Path

import pytest

from tests.evaluate.comparison import Case, case, launch_of, write

ME = '<include file="$(dirname)/main.launch"'
SECONDS = 20
"""Of processor, since the clock says how busy the machine is. Far more than any of these needs on a slow machine (the slowest some 8), far
less than without bounds.
"""


def chain(text: str, length: int, end: str = "[[]]") -> dict[str, str]:
    """Files that each include the next one as ``text`` says (``{0}`` is its number)."""
    return {**{f"f{number}.launch": text.format(number + 1) for number in range(length)}, f"f{length}.launch": end}


def many(text: str, count: int) -> str:
    return "".join(text.format(number) for number in range(count))


NEXT = '<include file="$(dirname)/f{0}.launch"/>'
ARGS = many('<arg name="a{0}" default="1"/>', 20_000)
NODES = many("[[n{0}]]", 5_000)
INNER = '<include file="$(dirname)/i.launch"/>'

ENDLESS: dict[str, tuple[Case, str]] = {
    "a file that includes itself": (case(ME + "/>"), "include-cycle"),
    "in a namespace that grows": (case("[[n]]" + ME + ' ns="a"/>'), "include-cycle"),
    "with an arg that counts": (
        case('<arg name="k" default="0"/>' + ME + '><arg name="k" value="$(eval k + 1)"/></include>'),
        "include-cycle",
    ),
    "with an arg that grows": (case('<arg name="k" default="0"/>' + ME + '><arg name="k" value="$(arg k)1"/></include>'), "include-cycle"),
    "with an arg that doubles": (
        case('<arg name="k" default="0"/>' + ME + '><arg name="k" value="$(arg k)$(arg k)"/></include>'),
        "evaluation-bound",
    ),
    "twice, in two namespaces": (case("[[n]]" + ME + ' ns="a"/>' + ME + ' ns="b"/>'), "include-cycle"),
    "twice, with an arg that counts": (
        case('<arg name="k" default="0"/>' + (ME + '><arg name="k" value="$(eval k + 1)"/></include>') * 2),
        "include-cycle",
    ),
    "twice, with anonymous names": (case("[[$(anon n)]]" + ME + ' ns="a"/>' + ME + ' ns="b"/>'), "include-cycle"),
    "args that double from one to the next": (
        case(
            '<arg name="k0" default="long enough"/>'
            + many('<arg name="m{0}" value=""/>', 1)
            + "".join(f'<arg name="k{number + 1}" value="$(arg k{number})$(arg k{number})"/>' for number in range(60))
        ),
        "evaluation-bound",
    ),
    "a tree of includes, each file twice": (case(NEXT.format(0), files=chain(NEXT * 2, 60)), "evaluation-bound"),
    "a tree of includes, each file twice in a namespace of its own": (
        case(NEXT.format(0), files=chain(NEXT.replace("/>", ' ns="a"/>') + NEXT.replace("/>", ' ns="b"/>'), 60)),
        "evaluation-bound",
    ),
    "a tree of includes with anonymous names": (case(NEXT.format(0), files=chain(NEXT * 2, 60, "[[$(anon n)]]")), "evaluation-bound"),
    "args and nodes": (case(ARGS + many("[[n{0}]]", 20_000)), "evaluation-bound"),
    "args and groups": (case(ARGS + "<group/>" * 20_000), "evaluation-bound"),
    "args and includes that pass them all": (
        case(ARGS + '<include file="$(dirname)/i.launch" pass_all_args="true"/>' * 5_000, files={"i.launch": ""}),
        "evaluation-bound",
    ),
    "remaps and nodes": (case(many('<remap from="a{0}" to="b"/>', 5_000) + NODES), "evaluation-bound"),
    "nodes and remaps": (case(many("[[n{0}]]", 20_000) + many('<remap from="a{0}" to="b"/>', 20_000)), "evaluation-bound"),
    "remaps and nodes of an included file": (
        case(many('<remap from="a{0}" to="b"/>', 5_000) + INNER, files={"i.launch": NODES}),
        "evaluation-bound",
    ),
    "env and nodes of an included file": (
        case(many('<env name="a{0}" value="b"/>', 20_000) + INNER, files={"i.launch": many("[[n{0}]]", 20_000)}),
        "evaluation-bound",
    ),
    "~params and nodes of an included file": (
        case(many('<param name="~a{0}" value="b"/>', 5_000) + INNER, files={"i.launch": NODES}),
        "evaluation-bound",
    ),
    "args that are not declared": (case(many('<param name="p{0}" value="$(arg a{0})"/>', 20_000)), "evaluation-bound"),
    "a long namespace again and again": (case("[[n]]" + ME + f' ns="{"a" * 1_000_000}"/>'), "evaluation-bound"),
}


@pytest.mark.parametrize(("each", "kind"), [pytest.param(*found, id=name) for name, found in ENDLESS.items()])
def test_it_ends(each: Case, kind: str, tmp_path: Path) -> None:
    write(each, tmp_path)
    before, begin = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, time.process_time()
    launch = launch_of(each, tmp_path)
    assert [problem.kind for problem in launch.problems] == [kind]
    assert launch.refused is launch.problems[0]
    assert time.process_time() - begin < SECONDS
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 1 << 20  # KiB


def test_what_is_within_the_bounds(tmp_path: Path) -> None:
    deep = case('<group ns="a">' * 300 + "[[n]]" + "</group>" * 300 + NEXT.format(0), files=chain(NEXT, 200, "[[last]]"))
    write(deep, tmp_path)
    launch = launch_of(deep, tmp_path)
    assert launch.problems == ()
    assert [node.full_name for node in launch.nodes] == ["/a" * 300 + "/n", "/last"]
    wide = case("".join(f'<arg name="a{number}" default="x"/>' for number in range(300)) + many("[[n{0}]]", 1_000))
    write(wide, tmp_path)
    assert (len(launch_of(wide, tmp_path).nodes), launch_of(wide, tmp_path).problems) == (1_000, ())

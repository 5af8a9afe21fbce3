"""Every configuration of a ROS 2 launch file that shows something new."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Set
from itertools import product
from pathlib import Path
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.block import Side
from launchlint.evaluate.configurations import MOST_EVALUATIONS, configurations
from launchlint.evaluate.ros2.arg_flow import Pairs, ros2_launch
from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.session import Session
from tests.evaluate.ros2.launching import Workspace

NODE = '<node pkg="pk" exec="{}"/>'


def shown(directory: Path, main: str, *given: tuple[str, str], **others: str) -> list[tuple[str, list[str]]]:
    """The args of each configuration, and what it starts."""
    workspace = Workspace(directory, main, {f"{name}.launch.xml": text for name, text in others.items()})
    found = configurations(workspace.session(), str(workspace.launch_files / "main.launch.xml"), given, ros2_launch())
    return [
        (" ".join(f"{name}:={value}" for name, value in each.launch.given), [node.executable for node in each.launch.nodes])
        for each in found
    ]


@pytest.mark.parametrize(
    ("main", "expected"),
    [
        (f'<arg name="a" default="x"/>{NODE.format("n")}', [("", ["n"])]),
        (
            '<arg name="sim" default="false"/><node pkg="pk" exec="n" if="$(var sim)"/><node pkg="pk" exec="m" unless="$(var sim)"/>',
            [("", ["m"]), ("sim:=true", ["n"])],
        ),
        (
            '<arg name="sim" default="True"/><let name="real" value="$(not $(var sim))"/><node pkg="pk" exec="n" if="$(var real)"/>',
            [("", []), ("sim:=False", ["n"])],
        ),
        (
            '<arg name="mode" default="a"/><node pkg="pk" exec="n" if="$(eval &quot;\'$(var mode)\' == \'b\'&quot;)"/>',
            [("", []), ("mode:=b", ["n"])],
        ),
        (
            '<arg name="mode" default="a"/><let name="on" value="$(equals $(var mode) b)"/><node pkg="pk" exec="n" if="$(var on)"/>',
            [("", []), ("mode:=b", ["n"])],
        ),
        (
            '<arg name="m" default="a"><choice value="a"/><choice value="b"/></arg><node pkg="pk" exec="n" if="$(equals $(var m) b)"/>',
            [("", []), ("m:=b", ["n"])],
        ),
        (
            '<arg name="a" default="0"/><arg name="b" default="0"/><group if="$(var a)"><node pkg="pk" exec="n" if="$(var b)"/></group>',
            [("", []), ("a:=1", []), ("a:=1 b:=1", ["n"])],
        ),
        ('<arg name="a" default="text"/><node pkg="pk" exec="n" if="$(var a)"/>', [("", [])]),
        ('<node pkg="pk" exec="n" if="false"/>', [("", [])]),
    ],
)
def test_what_shows_something_new(tmp_path: Path, main: str, expected: list[tuple[str, list[str]]]) -> None:
    assert shown(tmp_path, main) == expected


def test_a_comparison_in_an_included_file_counts(tmp_path: Path) -> None:
    main = '<arg name="mode" default="a"/><include file="$(dirname)/b.launch.xml"><arg name="how" value="$(var mode)"/></include>'
    included = '<arg name="how"/><node pkg="pk" exec="n" if="$(equals $(var how) odd)"/>'
    assert shown(tmp_path, main, b=included) == [("", []), ("mode:=odd", ["n"])]


def test_what_is_given_stays(tmp_path: Path) -> None:
    main = '<arg name="sim" default="false"/><node pkg="pk" exec="n" if="$(var sim)"/>'
    assert shown(tmp_path, main, ("sim", "true")) == [("sim:=true", ["n"])]


def test_many_conditions_come_to_an_end(tmp_path: Path) -> None:
    names = [f"a{number}" for number in range(200)]
    main = "".join(f'<arg name="{name}" default="false"/><node pkg="pk" exec="n" if="$(var {name})"/>' for name in names)
    assert len(shown(tmp_path, main)) <= MOST_EVALUATIONS


def counted(directory: Path, main: str, **others: str) -> list[str]:
    """The args of each evaluation that was made, whatever came of it."""
    workspace = Workspace(directory, main, {f"{name}.launch.xml": text for name, text in others.items()})
    way, made = ros2_launch(), []

    def enter(session: Session, file: str, given: Pairs, pinned: frozenset[str], seen: Set[Side] | None) -> Evaluation | None:
        made.append(" ".join(f"{name}:={value}" for name, value in given))
        return way.enter(session, file, given, pinned, seen)

    list(configurations(workspace.session(), str(workspace.launch_files / "main.launch.xml"), (), way._replace(enter=enter)))
    return made


TWICE = '<arg name="on" default="true"/><arg name="a" default="false"/><arg name="b" default="false"/>'
OF_A_AND_B = '<node pkg="pk" exec="n" if="$(var a)"/><node pkg="pk" exec="m" if="$(var b)"/>'


def test_what_did_not_turn_a_condition_is_not_tried_once_more(tmp_path: Path) -> None:
    include = '<group if="$(var on)"><include file="$(dirname)/b.launch.xml"/></group>'
    inner = '<node pkg="pk" exec="inner" if="$(var on)"/>'
    assert counted(tmp_path, TWICE + OF_A_AND_B + include, b=inner) == ["", "a:=true", "b:=true", "on:=false", "a:=true on:=false"]


def test_it_is_where_something_that_it_depends_on_is_different(tmp_path: Path) -> None:
    """Behind ``a:=true`` the group is there without ``on``."""
    group = '<group if="$(eval &quot;$(var on) or $(var a)&quot;)"><node pkg="pk" exec="inner" if="$(var on)"/></group>'
    made = counted(tmp_path, TWICE.replace("true", "True").replace("false", "False") + OF_A_AND_B + group)
    assert made == ["", "a:=True", "b:=True", "on:=False", "a:=True on:=False"]


ARGS = ("p", "q", "r")


def condition(random: Random) -> str:
    """A condition over some of what is set."""
    one, other = random.choice((*ARGS, "s")), random.choice((*ARGS, "s"))
    forms = (
        "$(var {0})",
        "$(not $(var {0}))",
        "$(and $(var {0}) $(var {1}))",
        "$(or $(var {0}) $(var {1}))",
        "$(equals $(var {0}) $(var {1}))",
    )
    return f'{random.choice(("if", "unless"))}="{random.choice(forms).format(one, other)}"'


def tree(random: Random, depth: int = 0) -> str:
    """Nodes, settings and includes, in groups under conditions, some inside others; nothing that is set in a group is known behind it."""
    text = ""
    for _ in range(random.randint(1, 3)):
        if random.random() < 0.2:
            text += f'<let name="s" value="$(var {random.choice(ARGS)})"/>'
        elif depth < 2 and random.random() < 0.6:
            text += f"<group {condition(random)}>{tree(random, depth + 1)}</group>"
        elif random.random() < 0.4:
            passed = f'<let name="{random.choice(ARGS)}" value="$(var {random.choice(ARGS)})"/>' if random.random() < 0.4 else ""
            text += f'<group {condition(random)}><include file="$(dirname)/b.launch.xml">{passed}</include></group>'
        else:
            text += f'<node pkg="pk" exec="n" {condition(random)}/>'
    return text


def launch_file(random: Random) -> tuple[str, str]:
    """An entry file with three boolean args and what it includes."""
    declared = "".join(f'<arg name="{name}" default="{random.choice(("true", "false"))}"/>' for name in ARGS)
    return declared + '<let name="s" value="false"/>' + tree(random), tree(random, 1).replace("<include", "<!--").replace(
        "</include>", "-->"
    )


def sides(found: Iterable[Evaluation]) -> set[tuple[str, int, bool | None]]:
    return {(*branch.element.key, branch.taken) for evaluation in found for branch in evaluation.launch.branches}


@settings(max_examples=100, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(st.builds(launch_file, st.randoms(use_true_random=False)))
def test_what_some_values_of_the_args_reach_is_reached(files: tuple[str, str]) -> None:
    with tempfile.TemporaryDirectory() as name:
        workspace = Workspace(Path(name), files[0], {"b.launch.xml": files[1]})
        session, entry = workspace.session(), str(workspace.launch_files / "main.launch.xml")
        found = list(configurations(session, entry, (), ros2_launch()))
        every = [evaluate(session, entry, tuple(zip(ARGS, each, strict=True))) for each in product(("true", "false"), repeat=len(ARGS))]
        assert sides(found) == sides(every)

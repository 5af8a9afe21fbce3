"""Loops of XML and YAML: ``<for>``, ``<for_each>``, and the values of each turn.

What is expected is what launch 3.7.1 with the loops of 3.8 said of the same files.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.evaluate.ros2.launching import Workspace, loaded, named, refusal

NODE = '<node pkg="pk" exec="e" name="{}"/>'
TWICE = '<for len="2" name="i">{}</for>'

CASES = {
    "a number": (TWICE.format(NODE.format("n$(index i)")), ["n0", "n1"]),
    "an arg": ('<arg name="n" default="3"/><for len="$(var n)" name="i">' + NODE.format("n$(index i)") + "</for>", ["n0", "n1", "n2"]),
    "none": ('<for len="0" name="i">' + NODE.format("n") + '</for><for_each values="">' + NODE.format("n") + "</for_each>", []),
    "not without its condition": ('<for len="2" name="i" if="false">' + NODE.format("n") + "</for>", []),
    "one in another": (
        TWICE.format('<for len="2" name="j">' + NODE.format("n$(index i)$(index j)") + "</for>"),
        ["n00", "n01", "n10", "n11"],
    ),
    "sets of values": ('<for_each values="{name: a};{name: b}">' + NODE.format("$(for-var name)") + "</for_each>", ["a", "b"]),
    "a default": ('<for_each values="{a: x};{b: y}">' + NODE.format("$(for-var a $(for-var b))") + "</for_each>", ["x", "y"]),
    "a default that an inner loop needs not": (
        '<for_each values="{a: x}"><for_each values="{b: y}">' + NODE.format("$(for-var a)$(for-var b d)") + "</for_each></for_each>",
        ["xy"],
    ),
    "a default without a loop": (NODE.format("n$(for-var k z)"), ["nz"]),
    "a default in an included file": ('<include file="$(dirname)/default.launch.xml"/>', ["d", "nz"]),
    "what a turn sets stays": (TWICE.format('<let name="x$(index i)" value="$(index i)"/>') + NODE.format("v$(var x1)"), ["v1"]),
    "an include in each turn": (
        TWICE.format('<include file="$(dirname)/inc.launch.xml"><arg name="a" value="$(index i)"/></include>'),
        ["k0", "k1"],
    ),
    "the directory is put back": (
        '<for len="1" name="i"><include file="$(dirname)/below/one.launch.xml"/></for><include file="$(dirname)/two.launch.xml"/>',
        ["one", "two"],
    ),
}
OTHERS = {
    "inc.launch.xml": '<arg name="a"/>' + NODE.format("k$(var a)"),
    "below/one.launch.xml": NODE.format("one"),
    "two.launch.xml": NODE.format("two"),
    "default.launch.xml": '<for len="1" name="i">' + NODE.format("$(for-var k d)") + "</for>" + NODE.format("n$(for-var k z)"),
}


@pytest.mark.parametrize(("text", "expected"), CASES.values(), ids=CASES)
def test_what_stands_in_a_loop_comes_once_for_each_turn(text: str, expected: list[str], tmp_path: Path) -> None:
    assert named(loaded(Workspace(tmp_path, text, OTHERS).launch(distro="kilted"))) == expected


REFUSED = {
    "no number": ('<for len="x" name="i">' + NODE.format("n") + "</for>", "stops-with-error"),
    "a key that is no text": ('<for_each values="{on: a}">' + NODE.format("n") + "</for_each>", "stops-with-error"),
    "a value that no loop gives": (TWICE.format(NODE.format("n$(index k)")), "stops-with-error"),
    "no name": ('<for len="2">' + NODE.format("n") + "</for>", "lacks-attribute"),
    "no values": ("<for_each>" + NODE.format("n") + "</for_each>", "lacks-attribute"),
    "three words": ('<for_each values="{a: b}">' + NODE.format("$(for-var a 1 2)") + "</for_each>", "substitution-arity"),
}


@pytest.mark.parametrize(("text", "kind"), REFUSED.values(), ids=REFUSED)
def test_what_launch_stops_at(text: str, kind: str, tmp_path: Path) -> None:
    assert refusal(Workspace(tmp_path, text).launch(distro="kilted")).split()[0].startswith(kind)


def test_yaml_has_them_too(tmp_path: Path) -> None:
    text = "launch:\n- for:\n    len: '2'\n    name: i\n    children:\n    - node: {pkg: pk, exec: e, name: n$(index i)}\n"
    workspace = Workspace(tmp_path, '<include file="$(dirname)/loop.launch.yaml"/>', {"loop.launch.yaml": text})
    assert named(loaded(workspace.launch(distro="rolling"))) == ["n0", "n1"]


def test_older_distributions_have_no_loops(tmp_path: Path) -> None:
    assert refusal(Workspace(tmp_path, TWICE.format(NODE.format("n"))).launch(distro="jazzy")).startswith("not-in-distribution")


def test_a_file_that_is_included_in_a_loop_may_see_its_values(tmp_path: Path) -> None:
    others = {"inc.launch.xml": NODE.format("k$(index i)")}
    launch = Workspace(tmp_path, TWICE.format('<include file="$(dirname)/inc.launch.xml"/>'), others).launch(distro="kilted")
    assert launch.refused is None
    assert all("name" in node.unknown for node in launch.nodes)

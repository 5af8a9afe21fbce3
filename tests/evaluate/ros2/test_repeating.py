"""What is taken over from one configuration to the next is what executing it again would give."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.ros2.repeating import Repeats
from launchlint.model import Launch
from tests.evaluate.ros2.launching import Workspace

NODE = '<node pkg="pk" exec="n" name="n"/>'
FILE = "$(find-pkg-share pk)/launch/{}.launch.xml"
INCLUDE = f'<include file="{FILE}"/>'

# Each main file is evaluated with its arg ``a`` as 0, 1 and 0 again; what it includes is ``b``, and ``c`` from there.
# First what does not depend on the arg, then what does, in each way there is.
CASES = {
    "nothing": (f'<arg name="a" default="0"/>{INCLUDE.format("b")}', NODE),
    "a passed arg": (
        f'<arg name="a" default="0"/><include file="{FILE.format("b")}"><arg name="x" value="$(var a)"/></include>',
        '<arg name="x" default="5"/><node pkg="pk" exec="n" args="$(var x)"/>',
    ),
    "an arg of the same name": (
        f'<arg name="a" default="0"/>{INCLUDE.format("b")}',
        '<arg name="a" default="7"/><node pkg="pk" exec="n" args="$(var a)"/>',
    ),
    "what an include left": (
        f'<arg name="a" default="0"/><include file="{FILE.format("c")}"><arg name="x" value="$(var a)"/></include>{INCLUDE.format("b")}',
        '<node pkg="pk" exec="n" args="$(var x)"/>',
    ),
    "a name that is computed": (
        '<arg name="a" default="0"/><let name="v0" value="zero"/><let name="v1" value="one"/>' + INCLUDE.format("b"),
        '<node pkg="pk" exec="n" args="$(var v$(var a))"/>',
    ),
    "a namespace": (
        '<arg name="a" default="0"/><group><push_ros_namespace namespace="n$(var a)"/>' + INCLUDE.format("b") + "</group>",
        NODE,
    ),
    "a namespace that was left": (
        f'<arg name="a" default="0"/><include if="$(var a)" file="{FILE.format("c")}"/>{NODE}{INCLUDE.format("b")}',
        NODE,
    ),
    "the environment": (
        '<arg name="a" default="0"/><set_env name="V" value="$(var a)"/>' + INCLUDE.format("b"),
        '<node pkg="pk" exec="n" args="$(env V)"/>',
    ),
    "remaps": ('<arg name="a" default="0"/><group><set_remap from="x" to="y$(var a)"/>' + INCLUDE.format("b") + "</group>", NODE),
    "a remap that leaks": (
        '<arg name="a" default="0"/><set_remap from="v" to="w"/><group if="$(var a)"><set_remap from="x" to="y"/></group>'
        + INCLUDE.format("b"),
        NODE,
    ),
    "params": ('<arg name="a" default="0"/><group><set_parameter name="x" value="$(var a)"/>' + INCLUDE.format("b") + "</group>", NODE),
    "a prefix": ('<arg name="a" default="0"/><let name="launch-prefix" value="nice$(var a)"/>' + INCLUDE.format("b"), NODE),
    "the directory": (
        f'<arg name="a" default="0"/><group if="$(var a)">{INCLUDE.format("c")}</group>{INCLUDE.format("b")}',
        '<node pkg="pk" exec="$(filename)"/>',
    ),
    "a name that is made once": (
        '<arg name="a" default="0"/><node if="$(var a)" pkg="pk" exec="e" name="$(anon x)"/>' + INCLUDE.format("b"),
        '<node pkg="pk" exec="n" name="$(anon x)"/><node pkg="pk" exec="n" name="$(anon y)"/>',
    ),
    "which names are set": (
        '<arg name="a" default="0"/><let if="$(var a)" name="there" value="1"/>' + INCLUDE.format("b"),
        '<node pkg="pk" exec="n" args="$(var their)"/>',
    ),
    "which names are set, and which are made": (
        '<arg name="a" default="0"/><let if="$(var a)" name="there" value="1"/><let if="$(var a)" name="here" value="1"/>'
        + INCLUDE.format("b"),
        (
            '<group><let name="there" value="2"/><node pkg="pk" exec="n" args="$(var their)"/></group>'
            '<let name="other" value="3"/><node pkg="pk" exec="n" args="$(var their)"/>'
        ),
    ),
    "the directory before an include": (
        (
            f'<arg name="a" default="0"/><group if="$(var a)">{INCLUDE.format("c")}</group><group scoped="false">'
            f'<node pkg="pk" exec="$(filename)"/>{INCLUDE.format("b")}</group>'
        ),
        '<node pkg="pk" exec="$(filename)"/>',
    ),
    "an arg that is not passed": (
        f'<arg name="a" default="0"/><let if="$(var a)" name="x" value="1"/>{INCLUDE.format("b")}{INCLUDE.format("b")}',
        f'<arg name="x"/><group><arg name="x"/></group><node pkg="pk" exec="n" args="$(var x none)"/>{INCLUDE.format("c")}',
    ),
    "components": (
        '<arg name="a" default="0"/><node_container pkg="c" exec="c" name="one" namespace=""/>'
        '<node_container pkg="c" exec="c" name="two" namespace=""/>' + INCLUDE.format("b"),
        (
            '<load_composable_node target="$(if $(var a) /one /two)"><composable_node pkg="pk" plugin="A" name="a"/></load_composable_node>'
            '<load_composable_node target="/one"><composable_node pkg="pk" plugin="p::A" name="b"><param name="x" value="$(var a)"/>'
            '</composable_node><composable_node pkg="pk" plugin="p::A" name="c" if="$(var a)"/></load_composable_node>'
        ),
    ),
    "a condition around": ('<arg name="a" default="0"/><group if="$(not $(var a))">' + INCLUDE.format("b") + "</group>", NODE),
    "a file by its name": (
        f'<arg name="a" default="0"/><let name="f" value="$(if $(var a) b c)"/>{INCLUDE.format("$(var f)")}{INCLUDE.format("$(var f)")}',
        NODE,
    ),
    "an arg that nobody reads": (
        f'<arg name="a" default="0"/><include file="{FILE.format("b")}"><arg name="$(if $(var a) x y)" value="1"/></include>',
        '<arg name="x" default="2"/><node pkg="pk" exec="n" args="$(var x)"/>',
    ),
    "a file that is not there": (
        f'<arg name="a" default="0"/><group if="$(var a)">{INCLUDE.format("none")}</group>{INCLUDE.format("b")}',
        '<node pkg="pk" exec="n" args="$(var x)"/>',
    ),
    "what waits": (
        f'<arg name="a" default="0"/>{INCLUDE.format("b")}',
        f'<group><let name="x" value="1"/><timer period="1.0">{NODE}</timer></group><node pkg="pk" exec="n" on_exit="shutdown"/>',
    ),
    "what is written wrong": (
        f'<arg name="a" default="0"/><group if="$(var a)">{INCLUDE.format("b")}</group>{INCLUDE.format("b")}',
        NODE + "stray",
    ),
    "a default that does not count": (
        '<arg name="a" default="0"/><arg name="x" default="$(var a)"/>' + INCLUDE.format("b"),
        '<arg name="x" default="1"/><node pkg="pk" exec="n" args="$(var x)"/>',
    ),
    "all that is forgotten": (
        '<arg name="a" default="0"/><let if="$(var a)" name="x" value="1"/>' + INCLUDE.format("b"),
        '<reset><keep name="y" value="$(var a)"/></reset><node pkg="pk" exec="n" args="$(var x here) $(var y)"/>',
    ),
    "what a file is asked for": (
        f'<arg name="a" default="0"/><include if="$(var a)" file="{FILE.format("c")}"><arg name="x" value="2"/></include>'
        + INCLUDE.format("b"),
        '<arg name="x" default="1"/><node pkg="pk" exec="n" args="$(var x)"/>',
    ),
}
LAST = '<push_ros_namespace namespace="left"/><node pkg="pk" exec="last"/>'


def workspace(directory: Path, case: str) -> Workspace:
    main, included = CASES[case]
    files = {"b.launch.xml": f"<launch>{included}</launch>", "c.launch.xml": f"<launch>{LAST}</launch>"}
    return Workspace(directory, main, files)


@pytest.mark.parametrize("case", CASES)
def test_the_same_comes_of_it(case: str, tmp_path: Path) -> None:
    made = workspace(tmp_path, case)
    session, file = made.session(), str(made.launch_files / "main.launch.xml")
    repeats = Repeats()
    seen = set()
    for given in ((), (("a", "1"),), (("a", "0"),), (("a", "1"), ("x", "3")), (("a", "1"),)):
        alone = evaluate(session, file, given)
        assert repr(evaluate(session, file, given, repeats=repeats)) == repr(alone)
        seen.add(repr((alone.launch.nodes, alone.launch.problems)))
    assert (len(seen) > 1) is (case not in ("nothing", "what waits"))


def evaluated(made: Workspace, *values: str) -> list[Launch]:
    session, file = made.session(), str(made.launch_files / "main.launch.xml")
    repeats = Repeats()
    return [evaluate(session, file, (("a", value),), repeats=repeats).launch for value in values]


def test_nothing_is_executed_again_that_depends_on_nothing(tmp_path: Path) -> None:
    first, second = evaluated(workspace(tmp_path, "nothing"), "0", "1")
    assert first.nodes[0] is second.nodes[0]


@pytest.mark.parametrize("case", ["which names are set", "the directory"])
def test_what_only_lists_names_or_says_where_it_is_itself_is_not_executed_again(case: str, tmp_path: Path) -> None:
    first, second = evaluated(workspace(tmp_path, case), "0", "1")
    assert first.nodes[-1] is second.nodes[-1]
    assert case == "the directory" or first.problems != second.problems


def test_what_depends_on_the_arg_is_kept_for_each_value(tmp_path: Path) -> None:
    first, other, again = evaluated(workspace(tmp_path, "a passed arg"), "0", "1", "0")
    assert first.nodes[0] is again.nodes[0]
    assert first.nodes[0] is not other.nodes[0]


def test_no_more_is_kept_than_a_few(tmp_path: Path) -> None:
    launches = evaluated(workspace(tmp_path, "a passed arg"), *map(str, range(20)), "0", "19")
    assert launches[0].nodes[0] is not launches[-2].nodes[0]
    assert launches[19].nodes[0] is launches[-1].nodes[0]

"""What functions of launch files in Python came to is taken over from one configuration to the next, but for what they leave behind."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.ros2.repeating import Repeats
from launchlint.model import Launch
from launchlint.report.launched import as_object
from tests.evaluate.ros2.launching import Workspace
from tests.evaluate.ros2.test_programs import HEAD, described, names

MAIN = '<arg name="a" default="0"/><include file="$(find-pkg-share pk)/launch/b.launch.py"/><node pkg="pk" exec="n" name="last"/>'
TWICE = "OpaqueFunction(function=one, condition=IfCondition(LaunchConfiguration('a'))), OpaqueFunction(function=two)"

# What ``b.launch.py`` describes, and what stands before that.
ALIKE = {
    "nothing": ("OpaqueFunction(function=one)", "def one(context):\n    return [node('x')]\n"),
    "lists and objects of its own": (
        "OpaqueFunction(function=one)",
        (
            "class Made:\n    pass\n\ndef one(context):\n    made, of = Made(), {}\n    made.all = []\n    of['n'] = 'x'\n"
            "    made.all.append(node(of['n']))\n    return made.all\n"
        ),
    ),
    "params for all": (
        "GroupAction([OpaqueFunction(function=one), node('y')]), OpaqueFunction(function=one), node('z')",
        "def one(context):\n    return [SetParameter('p', 1), SetRemap('a', 'b'), node('x')]\n",
    ),
    "an event": (
        "OpaqueFunction(function=one)",
        "def one(context):\n    return [node('x'), TimerAction(period=1.0, actions=[node('y')])]\n",
    ),
    "what is not known": (
        "OpaqueFunction(function=one), node('y')",
        "import somewhere\n\ndef one(context):\n    return somewhere.nodes()\n",
    ),
}
DIFFERENT = {
    "the arg": (
        "OpaqueFunction(function=one)",
        "def one(context):\n    return [node('x' + LaunchConfiguration('a').perform(context))]\n",
    ),
    "all configurations": (
        "OpaqueFunction(function=one)",
        "def one(context):\n    return [node('x' + '_'.join(context.launch_configurations.values()))]\n",
    ),
    "a list of the module": (
        TWICE,
        "made = []\ndef one(context):\n    made.append(1)\n\ndef two(context):\n    return [node('n' + str(len(made)))]\n",
    ),
    "a name of the module": (
        TWICE,
        "made = 'x'\ndef one(context):\n    global made\n    made = 'y'\n\ndef two(context):\n    return [node(made)]\n",
    ),
    "a default": (
        "OpaqueFunction(function=two, args=[LaunchConfiguration('a')])",
        (
            "def two(context, a, made=[]):\n    if a.perform(context) == '1':\n        made.append(1)\n"
            "    return [node('n' + str(len(made)))]\n"
        ),
    ),
    "an attribute": (
        TWICE,
        (
            "class M:\n    name = 'x'\n\nmade = M()\ndef one(context):\n    made.name = 'y'\n\ndef two(context):\n"
            "    return [node(made.name)]\n"
        ),
    ),
    "the environment": (
        TWICE,
        "def one(context):\n    os.environ['V'] = 'x'\n\ndef two(context):\n    return [node('n' + os.environ.get('V', ''))]\n",
    ),
    "the command line": (
        "OpaqueFunction(function=one)",
        "import sys\n\ndef one(context):\n    return [node('x' if 'a:=1' in sys.argv else 'y')]\n",
    ),
    "a substitution of its own": (
        "node(Own())",
        (
            "import launch\n\nclass Own(launch.Substitution):\n    def perform(self, c):\n"
            "        return LaunchConfiguration('a').perform(c) + 'x'\n"
        ),
    ),
}


def launches(directory: Path, case: tuple[str, str], repeats: Repeats | None) -> list[Launch]:
    """The launches with different values of the arg, one after the other."""
    items, before = case
    made = Workspace(directory, MAIN, {"b.launch.py": HEAD + described(items, before)})
    session, file = made.session(), str(made.launch_files / "main.launch.xml")
    return [evaluate(session, file, given, repeats=repeats).launch for given in ((), (("a", "1"),), (("a", "0"),), (("a", "1"),))]


def said(launch: Launch, directory: Path) -> str:
    """What is started and told, and what of it is not known, wherever the workspace lies."""
    problems = [(type(problem).__name__, problem.place.key) for problem in launch.problems]
    followed = [(each.source.path, each.state, each.reasons) for each in launch.followed]
    return repr((as_object(launch, "main.launch.xml", None), problems, followed)).replace(str(directory), "WS")


@pytest.mark.parametrize("name", [*ALIKE, *DIFFERENT])
def test_the_same_comes_of_it(name: str, tmp_path: Path) -> None:
    case = {**ALIKE, **DIFFERENT}[name]
    alone = [launches(tmp_path / str(number), case, None)[number] for number in range(4)]
    together = launches(tmp_path / "together", case, Repeats())
    shown = [said(each, tmp_path / str(number)) for number, each in enumerate(alone)]
    assert [said(each, tmp_path / "together") for each in together] == shown
    assert (names(alone[0]) == names(alone[1])) is (name in ALIKE)


@pytest.mark.parametrize("name", ["nothing", "lists and objects of its own", "params for all"])
def test_a_function_that_depends_on_nothing_is_called_once(name: str, tmp_path: Path) -> None:
    first, second, *_ = launches(tmp_path, ALIKE[name], Repeats())
    assert [one is other for one, other in zip(first.nodes, second.nodes, strict=True)][:1] == [True]


def test_a_function_that_reads_what_another_left_is_called_in_each_launch(tmp_path: Path) -> None:
    first, *_, last = launches(tmp_path, DIFFERENT["a list of the module"], Repeats())
    assert first.nodes[0] is not last.nodes[0]

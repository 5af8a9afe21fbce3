"""What launch files in Python make that launch makes actions of only when it runs: loops, and descriptions that come of no file.

What is expected is what launch 3.7.1 with the loops of 3.8 said of the same files.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.model import Launch
from launchlint.report.launched import as_object
from tests.evaluate.ros2.launching import Workspace
from tests.evaluate.ros2.test_programs import HEAD, described, names

FILE = "main.launch.py"


def launched(directory: Path, items: str, before: str = "", distro: str = "kilted") -> Launch:
    text = HEAD + "from launch import LaunchDescriptionSource\n" + described(items, before)
    workspace = Workspace(directory, "", {FILE: text})
    return evaluate(workspace.session(distro), str(workspace.launch_files / FILE), ()).launch


def word(launch: Launch) -> str:
    """The kind of problem for which launch stops; empty where it does not."""
    return "" if launch.refused is None else launch.refused.kind


LOOPS = {
    "once for each number": ("ForLoop('3', function=f)", "i", ["n0", "n1", "n2"]),
    "as int() reads it": ("ForLoop(' 2 ', function=f)", "i", ["n0", "n1"]),
    "never below zero": ("ForLoop('-1', function=f)", "i", []),
    "by name": ("ForLoop('1', function=f, name='x')", "i", ["n0"]),
    "not without its condition": ("ForLoop('3', function=f, condition=IfCondition('false'))", "i", []),
    "a configuration": ("DeclareLaunchArgument('n', default_value='2'), ForLoop(LaunchConfiguration('n'), function=f)", "i", ["n0", "n1"]),
    "sets of values": ("ForEach('{i: a};{i: b}', function=f)", "i", ["na", "nb"]),
    "empty sets are left out": ("ForEach('{i: a};;{i: b}; ;', function=f)", "i", ["na", "nb"]),
    "an empty mapping is none": ("ForEach('{};{i: 7}', function=f)", "i='d'", ["nd", "n7"]),
    "no values": ("ForEach('', function=f)", "i", []),
    "any keywords": ("ForEach('{x: 1, y: z}', function=f)", "i='d', **more", ["nd"]),
}


@pytest.mark.parametrize(("items", "takes", "expected"), LOOPS.values(), ids=LOOPS)
def test_a_function_is_called_for_each_turn(items: str, takes: str, expected: list[str], tmp_path: Path) -> None:
    launch = launched(tmp_path, items, f"def f({takes}):\n    return [node('n' + str(i))]\n")
    assert word(launch) == ""
    assert names(launch) == expected


REFUSED = {
    "no number": "ForLoop('x', function=f)",
    "no mapping": "ForEach('a;b', function=f)",
    "a key that is no text": "ForEach('{1: a}', function=f)",
    "no YAML": "ForEach('{i: [}', function=f)",
}


@pytest.mark.parametrize("item", REFUSED.values(), ids=REFUSED)
def test_launch_stops_at_what_no_loop_can_go_through(item: str, tmp_path: Path) -> None:
    launch = launched(tmp_path, f"{item}, node('after')", "def f(i):\n    return [node('n')]\n")
    assert word(launch) == "stops-with-error"
    assert launch.refused is not None
    assert launch.refused.place.text.strip("'{") in item


def test_the_function_is_called_for_all_turns_before_anything_is_executed(tmp_path: Path) -> None:
    before = (
        "made = []\ndef f(i):\n    made.append(i)\n    return [OpaqueFunction(function=lambda context: [node('n' + str(len(made)))])]\n"
    )
    assert names(launched(tmp_path, "ForLoop('2', function=f)", before)) == ["n2", "n2"]


def test_a_loop_in_a_loop(tmp_path: Path) -> None:
    before = "def g(i):\n    return [node('m' + str(i))]\ndef f(i):\n    return [ForLoop(str(i), function=g)]\n"
    assert names(launched(tmp_path, "ForLoop('3', function=f)", before)) == ["m0", "m0", "m1"]


def test_what_is_too_much_or_not_known_is_said(tmp_path: Path) -> None:
    before = "def f(i):\n    return [node('n')]\n"
    for number, length in enumerate(("'1000000000'", "EnvironmentVariable('NOBODY', default_value=other.x)")):
        launch = launched(tmp_path / str(number), f"ForLoop({length}, function=f)", f"import other\n{before}")
        assert as_object(launch, FILE, None)["complete"] is False, length


@pytest.mark.parametrize("distro", ["humble", "jazzy"])
def test_older_distributions_have_no_loops(distro: str, tmp_path: Path) -> None:
    launch = launched(tmp_path, "ForLoop('3', function=f)", "def f(i):\n    return [node('n')]\n", distro)
    assert names(launch) == []
    assert as_object(launch, FILE, None)["complete"] is False


INNER = "inner = LaunchDescription([DeclareLaunchArgument('a'), node(['n', LaunchConfiguration('a')]), LogInfo(msg=ThisLaunchFile())])\n"


def test_a_description_of_no_file_is_included(tmp_path: Path) -> None:
    items = "IncludeLaunchDescription(LaunchDescriptionSource(inner, '/x/y.py'), launch_arguments=[('a', '1')]), node(ThisLaunchFileDir())"
    launch = launched(tmp_path, items, INNER)
    assert [(each.file, each.arguments) for each in launch.includes] == [("/x/y.py", {"a": "1"})]
    assert names(launch)[0] == "n1"
    assert word(launch) == "invalid-node-name"
    assert launch.nodes[0].file == "/x/y.py"


PASSED = "IncludeLaunchDescription(LaunchDescriptionSource(inner), launch_arguments=[('a', '1')])"
IN_MEMORY = {
    "an arg that is not passed": ("IncludeLaunchDescription(LaunchDescriptionSource(inner))", "include-missing-arg"),
    "set, but not passed": (
        "SetLaunchConfiguration('a', '1'), IncludeLaunchDescription(LaunchDescriptionSource(inner))",
        "include-missing-arg",
    ),
    "passed further inside": (f"IncludeLaunchDescription(LaunchDescriptionSource(LaunchDescription([{PASSED}])))", ""),
    "no source": ("IncludeLaunchDescription(inner)", "not-a-substitution"),
    "nothing in it": ("IncludeLaunchDescription(LaunchDescriptionSource())", "stops-with-error"),
    "one in two sources": (
        "*(IncludeLaunchDescription(LaunchDescriptionSource(inner), launch_arguments=[('a', each)]) for each in '12')",
        "executed-twice",
    ),
}


@pytest.mark.parametrize(("items", "expected"), IN_MEMORY.values(), ids=IN_MEMORY)
def test_what_launch_says_of_a_description_of_no_file(items: str, expected: str, tmp_path: Path) -> None:
    assert word(launched(tmp_path, items, INNER)) == expected

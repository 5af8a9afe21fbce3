"""Launch files in Python as descriptions; and what is not understood as a whole, and why."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Substitution, Text
from launchlint.syntax.ros2.python.reading import read
from launchlint.syntax.ros2.python.recogniser import Outside
from launchlint.syntax.ros2.reading import Reading
from launchlint.workspace.ros2_distributions import Meant

HEAD = """import os
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import IfCondition, UnlessCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import AllSubstitution, AnySubstitution, LaunchConfiguration, PathJoinSubstitution, PythonExpression
from launch_ros.actions import Node, PushRosNamespace, SetParameter
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare
from ament_index_python.packages import get_package_share_directory
"""


def reading(text: str, directory: Path, distro: str = "jazzy") -> Reading:
    outside = Outside(Meant(distro), lambda name: "/ws/arm" if name == "arm" else None, {"HOME": "/home/ada"})
    return read(text.encode(), "x.launch.py", str(directory / "x.launch.py"), outside)


def actions(body: str, directory: Path, distro: str = "jazzy") -> tuple[described.Action, ...]:
    """The actions of a launch file whose function has this body."""
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    found = reading(f"{HEAD}def generate_launch_description():\n{lines}", directory, distro).description.actions
    return tuple(each for each in found if not isinstance(each, described.Unsettled))


def spelled(text: Text | None) -> str:
    """A text as one would write it in XML."""
    if text is None:
        return "-"
    return "".join(each if isinstance(each, str) else _spelled(each) for each in text.pieces)


def _spelled(each: Substitution) -> str:
    return f"$({' '.join([each.name, *map(spelled, each.arguments)])})"


def node(body: str, directory: Path) -> described.Node:
    found = actions(body, directory)[-1]
    assert isinstance(found, described.Node)
    return found


def test_a_node_with_everything(tmp_path: Path) -> None:
    body = (
        "return LaunchDescription([Node(package='p', executable='e', name='n', namespace=['a', LaunchConfiguration('b')],\n"
        "    remappings=[('x', 'y')], arguments=['--z', LaunchConfiguration('c', default='d')], output='screen', respawn=True,\n"
        "    parameters=['f.yaml', {'i': 1, 'd': {'e': [1, 2.5]}, 's': ParameterValue(LaunchConfiguration('g'), value_type=str)}],\n"
        "    condition=IfCondition(LaunchConfiguration('h')))])"
    )
    found = node(body, tmp_path)
    assert (spelled(found.package), spelled(found.executable), spelled(found.name)) == ("p", "e", "n")
    assert spelled(found.namespace) == "a$(var b)"
    assert [(spelled(each.source), spelled(each.target)) for each in found.remaps] == [("x", "y")]
    assert list(map(spelled, found.arguments)) == ["--z", "$(var c d)"]
    assert (spelled(found.process.output), found.process.respawn) == ("screen", True)
    assert found.condition is not None
    assert (found.condition.kind, spelled(found.condition.operands[0])) == ("if", "$(var h)")
    file, values = found.parameters
    assert isinstance(file, described.ParameterFile)
    assert isinstance(values, described.Parameters)
    whole, inner, text = values.entries
    assert whole.value is not None
    assert whole.value.plain == 1
    assert inner.nested[0].value is not None
    assert inner.nested[0].value.plain == (1.0, 2.5)
    assert text.value is not None
    assert (text.value.type, text.value.plain) == ("str", None)


def test_exact_places(tmp_path: Path) -> None:
    found = node("x = 'ä'; y = Node(package='p', executable=x)\nreturn LaunchDescription([y])", tmp_path)
    assert found.place.text == "Node(package='p', executable=x)"


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        ("get_package_share_directory('arm') + '/x'", "$(find-pkg-share arm)/x"),
        ("os.path.join(get_package_share_directory('arm'), 'launch', 'x.py')", "$(find-pkg-share arm)/launch/x.py"),
        ("os.path.join('/a', get_package_share_directory('arm'))", "$(find-pkg-share arm)"),
        ("os.path.basename(os.path.join(get_package_share_directory('arm'), 'x'))", "x"),
        ("os.path.dirname(os.path.join(get_package_share_directory('arm'), 'a{}', 'x'))", "$(find-pkg-share arm)/a{}"),
        ("[FindPackageShare('arm'), '/x']", "$(find-pkg-share arm)/x"),
        ("PathJoinSubstitution(['x', ['y', LaunchConfiguration('z')]])", "$(path-join x y$(var z))"),
        ("PathJoinSubstitution([FindPackageShare('arm')])", "$(path-join $(find-pkg-share arm))"),
        ("PythonExpression(['1 + ', LaunchConfiguration('z')])", "$(eval 1 + $(var z))"),
        ("AnySubstitution('true', LaunchConfiguration('z'))", "$(or $(or $(or false true) $(var z)) false)"),
        ("AllSubstitution(LaunchConfiguration('z'))", "$(and $(and true $(var z)) true)"),
        ("os.environ['HOME'] + os.environ.get('NOT', 'there')", "/home/adathere"),
        ("os.getenv('HOME')", "/home/ada"),
        ("f'{1:02d}' + '%s' % 'a'", "01a"),
    ],
)
def test_texts(expression: str, text: str, tmp_path: Path) -> None:
    found = node(f"return LaunchDescription([Node(package='p', executable={expression})])", tmp_path)
    assert spelled(found.executable) == text


def test_actions_are_added_one_by_one(tmp_path: Path) -> None:
    body = (
        "ld = LaunchDescription()\n"
        "for n in ('a', 'b'):\n"
        "    ld.add_action(SetLaunchConfiguration(n, n + 'x'))\n"
        "inner = [PushRosNamespace('g')]\n"
        "ld.add_action(GroupAction(inner))\n"
        "inner.append(SetParameter('p', 'q'))\n"
        "return ld"
    )
    first, second, group = actions(body, tmp_path)
    assert isinstance(first, described.Let)
    assert isinstance(second, described.Let)
    assert (spelled(first.value), spelled(second.value)) == ("ax", "bx")
    assert isinstance(group, described.Group)
    assert [type(each).__name__ for each in group.actions] == ["PushNamespace", "SetParameter"]


def test_a_list_that_is_changed_after_it_was_given(tmp_path: Path) -> None:
    found = node("a = ['x']\nn = Node(package='p', executable='e', arguments=a)\na.append('y')\nreturn LaunchDescription([n])", tmp_path)
    assert list(map(spelled, found.arguments)) == ["x"]


def test_an_include(tmp_path: Path) -> None:
    body = (
        "return LaunchDescription([IncludeLaunchDescription(PythonLaunchDescriptionSource(\n"
        "    os.path.join(get_package_share_directory('arm'), 'a.launch.py')), launch_arguments={'x': LaunchConfiguration('y')}.items())])"
    )
    (found,) = actions(body, tmp_path)
    assert isinstance(found, described.Include)
    assert spelled(found.file) == "$(find-pkg-share arm)/a.launch.py"
    assert [(spelled(each.name), spelled(each.value)) for each in found.arguments] == [("x", "$(var y)")]


NODE = "Node(package='p', executable='e')"


def kinds(found: tuple[described.Action, ...]) -> list[str]:
    return [type(each).__name__ for each in found]


@pytest.mark.parametrize(
    ("body", "reason"),
    [
        ("return LaunchDescription(somewhere())", "gives is not known"),
        ("os.system('touch mark')\nreturn LaunchDescription(os.walk('.'))", "os.walk is not looked into"),
        ("raise ValueError", "it ends with an error"),
        ("while os.getcwd():\n    pass\nreturn other()", "gives is not known to be"),
        ("ld = LaunchDescription()\nld.add_action(ld)\nreturn ld", "without end"),
        ("return LaunchDescription([5 if os.getcwd() else 6])", "an action that is not known"),
    ],
)
def test_what_is_not_known_is_said(body: str, reason: str, tmp_path: Path) -> None:
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    found = reading(f"{HEAD}def generate_launch_description():\n{lines}", tmp_path)
    assert "Open" in str(found.description.actions) or not found.description.actions
    assert any(re.search(reason, each.reason) for each in found.unresolved), found.unresolved


def test_what_is_given_to_code_that_is_not_followed_may_get_more(tmp_path: Path) -> None:
    found = actions(f"ld = LaunchDescription([{NODE}])\nother.module.extend(ld)\nreturn ld", tmp_path)
    assert kinds(found) == ["Node", "Open"]


def test_what_is_done_under_a_condition_that_is_not_known_may_be_done(tmp_path: Path) -> None:
    found = actions(f"ld = LaunchDescription([{NODE}])\nif os.getcwd():\n    ld.add_action({NODE})\nreturn ld", tmp_path)
    assert kinds(found) == ["Node", "Maybe"]
    assert isinstance(found[1], described.Maybe)
    assert found[1].reason == "os.getcwd()"


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ("executable=os.getcwd()", "$(? what os.getcwd() gives is not known)"),
        ("executable=f'a{os.getcwd()}'", "a$(? what os.getcwd() gives is not known)"),
        ("executable=['a', os.getcwd()]", "a$(? what os.getcwd() gives is not known)"),
        ("executable=PathJoinSubstitution(['a', os.getcwd()])", "$(path-join a $(? what os.getcwd() gives is not known))"),
    ],
)
def test_a_part_of_a_text_that_is_not_known(arguments: str, text: str, tmp_path: Path) -> None:
    found = node(f"return LaunchDescription([Node(package='p', {arguments})])", tmp_path)
    assert spelled(found.executable) == text


def test_lists_of_which_not_all_is_known(tmp_path: Path) -> None:
    found = node(
        "return LaunchDescription([Node(package='p', executable='e', arguments=['a', *os.listdir('.')], remappings=x())])", tmp_path
    )
    assert list(map(spelled, found.arguments)) == ["a", "$(? not all items of the list are known)"]
    assert [spelled(each.source)[:4] for each in found.remaps] == ["$(? "]


def test_a_condition_that_is_not_known(tmp_path: Path) -> None:
    found = node("return LaunchDescription([Node(package='p', executable='e', condition=my_condition())])", tmp_path)
    assert found.condition is not None
    assert spelled(found.condition.operands[0]).startswith("$(? ")


def test_the_environment_that_a_file_sets(tmp_path: Path) -> None:
    found = actions("os.environ['A'] = 'b'\nreturn LaunchDescription()", tmp_path)
    assert isinstance(found[0], described.SetEnvironment)
    assert (spelled(found[0].name), spelled(found[0].value)) == ("A", "b")


def test_one_object_in_two_places_is_one_action(tmp_path: Path) -> None:
    first, second = actions(f"n = {NODE}\nreturn LaunchDescription([n, n])", tmp_path)
    assert first is second


def test_what_a_distribution_does_not_know(tmp_path: Path) -> None:
    body = "from launch.substitutions import EqualsSubstitution\nreturn LaunchDescription([LogInfo(msg=[EqualsSubstitution('a', 'b')])])"
    (found,) = actions(body, tmp_path)
    assert isinstance(found, described.Log)
    assert spelled(found.message) == "$(equals a b)"
    (found,) = actions(body, tmp_path, "humble")
    assert isinstance(found, described.Log)
    assert spelled(found.message).startswith("$(? launch.substitutions.EqualsSubstitution is not looked into")


def test_nothing_is_run(tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    text = f"open({str(mark)!r}, 'w')\nimport subprocess\nsubprocess.run(['touch', {str(mark)!r}])\n"
    text += "def generate_launch_description():\n    pass\n"
    reading(text, tmp_path)
    assert not mark.exists()

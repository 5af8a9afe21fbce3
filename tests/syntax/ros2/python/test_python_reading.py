"""Launch files in Python as descriptions; and what is not understood as a whole, and why."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Substitution, Text
from launchlint.syntax.ros2.python.reading import read
from launchlint.syntax.ros2.python.recogniser import Outside
from launchlint.syntax.ros2.python.texts import NotUnderstood
from launchlint.syntax.ros2.reading import Reading

HEAD = """import os
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import IfCondition, UnlessCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, PythonExpression
from launch_ros.actions import Node, PushRosNamespace, SetParameter
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare
from ament_index_python.packages import get_package_share_directory
"""


def reading(text: str, directory: Path, distro: str = "jazzy") -> Reading:
    outside = Outside(distro, lambda name: name == "arm", {"HOME": "/home/ada"})
    return read(text.encode(), "x.launch.py", str(directory / "x.launch.py"), outside)


def actions(body: str, directory: Path, distro: str = "jazzy") -> tuple[described.Action, ...]:
    """The actions of a launch file whose function has this body."""
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    return reading(f"{HEAD}def generate_launch_description():\n{lines}", directory, distro).description.actions


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


@pytest.mark.parametrize(
    ("body", "reason"),
    [
        ("return LaunchDescription([Node(package='p', executable=str(os.getcwd()))])", "a value that is not known"),
        ("n = Node(package='p', executable='e')\nreturn LaunchDescription([n, n])", "one object that is executed twice"),
        ("return LaunchDescription([OpaqueFunction(function=print)])", "not known"),
        ("x = get_package_share_directory('leg')\nreturn LaunchDescription()", "a package that is not known"),
        ("x = os.environ['NOT']\nreturn LaunchDescription()", "an item that is not known"),
        ("os.environ['A'] = 'b'\nreturn LaunchDescription()", "it changes the environment"),
        ("os.system('touch mark')\nreturn LaunchDescription()", "os.system is not known"),
        ("x = ['b', 'a']\nx.sort()\nreturn LaunchDescription()", r"\.sort\(\) is not followed"),
        ("while os.getcwd():\n    pass\nreturn LaunchDescription()", "a loop of which not all rounds are known"),
        ("if os.getcwd():\n    raise ValueError\nreturn LaunchDescription()", "it may end with an error"),
        ("ld = LaunchDescription()\nld.add_action(ld)\nreturn ld", "one object that is executed twice"),
        ("x = []\nx.append(x)\nreturn LaunchDescription([LogInfo(msg=x)])", "lists in lists without end"),
        ("return LaunchDescription([SetParameter('a', 0xfffffffffffffffffffff)])", "a number that is too large"),
        ("return LaunchDescription([TimerAction(period=1e999, actions=[])])", "a number that is too large"),
        ("raise ValueError", "it ends with an error"),
        ("def f(n):\n    return f(n + 1)\nf(0)\nreturn LaunchDescription()", "too deep to be followed"),
        (
            "ld = LaunchDescription()\nif os.getcwd():\n    ld.add_action(Node(package='p', executable='e'))\nreturn ld",
            "an action that is not known",
        ),
    ],
)
def test_what_is_not_understood(body: str, reason: str, tmp_path: Path) -> None:
    with pytest.raises(NotUnderstood, match=reason):
        actions(body, tmp_path)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("x = f'{\"a\" if 1 else 'b'}'\n", "no Python that can be read here"),
        ("type X = int\n", "no Python that can be read here"),
        ("from other import *\n", "it has no function generate_launch_description"),
    ],
)
def test_files_that_are_not_understood(text: str, reason: str, tmp_path: Path) -> None:
    with pytest.raises(NotUnderstood, match=reason):
        reading(text, tmp_path)


def test_what_a_distribution_does_not_know(tmp_path: Path) -> None:
    body = "from launch.substitutions import EqualsSubstitution\nreturn LaunchDescription([LogInfo(msg=[EqualsSubstitution('a', 'b')])])"
    assert len(actions(body, tmp_path)) == 1
    with pytest.raises(NotUnderstood, match=r"launch\.substitutions\.EqualsSubstitution is not known"):
        actions(body, tmp_path, "humble")


def test_nothing_is_run(tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    text = f"open({str(mark)!r}, 'w')\nimport subprocess\nsubprocess.run(['touch', {str(mark)!r}])\n"
    text += "def generate_launch_description():\n    pass\n"
    with pytest.raises(NotUnderstood):
        reading(text, tmp_path)
    assert not mark.exists()

"""What is offered in ROS 2's YAML and Python: the cursor stands at ``|``."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.ide.completion import completion, context_in
from launchlint.project.workspace import OpenWorkspace
from tests.ide.questions import view_of
from tests.server.workspace import make

YAML = """launch:
- arg:
    name: speed
    default: '1'
- node:
    pkg: turtlesim
    exec: turtlesim_node
    name: turtle
    param:
    - name: rate
      value: 1
    remap:
    - from: a
      to: b
- group:
    - node:
        pkg: turtlesim
        exec: turtle_teleop_key
- let:
    name: speed
    value: '2'
"""
PYTHON = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='1'),
        Node(package='turtlesim', executable='turtlesim_node', name=LaunchConfiguration('speed')),
    ])
"""


@pytest.fixture
def workspace(tmp_path: Path) -> OpenWorkspace:
    opened = OpenWorkspace(str(make(tmp_path / "ws")))
    opened.settle()
    return opened


def offered(workspace: OpenWorkspace, ending: str, text: str) -> dict[str, str]:
    """Label and text of what is offered at ``|``."""
    offset = text.index("|")
    view = view_of(workspace, Path(workspace.root) / "demo2" / "launch" / f"typed{ending}", text.replace("|", ""))
    return {each.label: each.text for each in completion(view, offset)}


@pytest.mark.parametrize(
    ("before", "after", "expected"),
    [
        ("- let:", "- |\n- let:", {"node", "include", "arg", "group", "let"}),
        ("- let:", "- no|\n- let:", {"node"}),
        ("    name: turtle\n", "    name: turtle\n    |\n", {"namespace", "output", "respawn", "ros_args"}),
        ("    pkg: turtlesim\n    exec: turtlesim_node", "    pkg: |\n    exec: turtlesim_node", {"demo2", "turtlesim"}),
        ("exec: turtlesim_node", "exec: turt|", {"turtlesim_node", "turtle_teleop_key", "mimic"}),
        ("    exec: turtlesim_node", "    exec: '|'", {"turtlesim_node"}),
        ("      value: 1", "      |", {"value", "from"}),
        ("    name: turtle\n", "    name: $(var |)\n", {"speed"}),
        ("    name: turtle\n", "    name: $(|\n", {"var", "find-pkg-share"}),
        ("    name: speed\n    value", "    name: |\n    value", {"speed"}),
        ("    name: turtle\n", "    name: turtle\n    output: |\n", {"screen", "log", "both"}),
        ("    - node:\n        pkg: turtlesim", "    - |\n", {"node", "push_ros_namespace"}),
        ("- let:", "- include:\n    file: |\n- let:", {"$(find-pkg-share demo2)/launch/part.launch.yaml"}),
        (
            "- let:",
            "- include:\n    file: $(find-pkg-share demo2)/launch/part.launch.yaml\n    arg:\n    - name: |\n- let:",
            {"speed"},
        ),
    ],
)
def test_yaml(workspace: OpenWorkspace, before: str, after: str, expected: set[str]) -> None:
    assert before in YAML
    assert offered(workspace, ".launch.yaml", YAML.replace(before, after, 1)).keys() >= expected


def test_what_is_put_into_yaml(workspace: OpenWorkspace) -> None:
    found = offered(workspace, ".launch.yaml", "launch:\n- |\n")
    assert found["node"] == "node:\n    exec: $1"
    assert offered(workspace, ".launch.yaml", "launch:\n- node:\n    |\n")["pkg"] == "pkg: "
    given = offered(workspace, ".launch.yaml", YAML.replace("    name: turtle\n", "    |\n    name: turtle\n"))
    assert not given.keys() & {"pkg", "exec", "name"}


@pytest.mark.parametrize(
    ("before", "after", "expected"),
    [
        ("package='turtlesim'", "package='|'", {"demo2", "turtlesim"}),
        ("executable='turtlesim_node'", "executable='turt|'", {"turtlesim_node", "mimic"}),
        ("Node(package", "Node(|, package", {"namespace", "parameters", "remappings", "output", "condition"}),
        ("name=LaunchConfiguration('speed')", "name=LaunchConfiguration('speed'), par|", {"parameters"}),
        ("LaunchConfiguration('speed')", "LaunchConfiguration('|')", {"speed"}),
        ("default_value='1'", "|", {"default_value", "description", "choices"}),
        ("name=LaunchConfiguration('speed')", "output='|'", {"screen", "log"}),
        ("name=LaunchConfiguration('speed')", "name=FindPackageShare('|')", {"demo2"}),
    ],
)
def test_python(workspace: OpenWorkspace, before: str, after: str, expected: set[str]) -> None:
    assert before in PYTHON
    assert offered(workspace, ".launch.py", PYTHON.replace(before, after, 1)).keys() >= expected


@pytest.mark.parametrize("text", ["x = '|'\n", "print(|)\n", "Node([|])\n", "# Node(|\n", "Node(package='a' + '|')\n", "|"])
def test_where_nothing_is_known_nothing_is_offered(workspace: OpenWorkspace, text: str) -> None:
    assert offered(workspace, ".launch.py", PYTHON + text) == {}


def test_every_place_can_be_asked_about(workspace: OpenWorkspace) -> None:
    for ending, text in ((".launch.yaml", YAML), (".launch.py", PYTHON)):
        view = view_of(workspace, Path(workspace.root) / "demo2" / "launch" / f"typed{ending}", text)
        for offset in range(len(text) + 1):
            assert 0 <= context_in(view, offset).span.start <= context_in(view, offset).span.end <= offset

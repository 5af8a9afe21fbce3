"""What sources say of programs of ROS 2: found by what ament installs, apart from those of ROS 1, and read by themselves."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.check.ahead import _started_in_ros2
from launchlint.knowledge.own import OwnSources
from launchlint.model import ROS1, ROS2
from launchlint.workspace.packages import Packages
from tests.cli.running import PACKAGE, run, write

AMENT = """\
<package format="3">
  <name>{name}</name><version>1.0.0</version><description>d</description><maintainer email="a@b.cc">m</maintainer><license>MIT</license>
  <export><build_type>{type}</build_type></export>
</package>
"""
NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import {type}


class Speaks(Node):
    def __init__(self):
        super().__init__('{name}')
        self.{call}


def main():
    rclpy.init()
    rclpy.spin(Speaks())


if __name__ == '__main__':
    main()
"""
TALKER = NODE.format(type="String", name="talker", call="create_publisher(String, 'chatter', 10)")
LISTENER = NODE.format(type="String", name="listener", call="create_subscription(String, 'chatter', print, 10)")
SETUP = """\
from setuptools import find_packages, setup
setup(
    name='demo',
    packages=find_packages(exclude=['test']),
    entry_points={'console_scripts': ['talker = demo.talker:main', 'gone = demo.gone:main']},
)
"""
CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project(mixed)
find_package(ament_cmake REQUIRED)
ament_python_install_package(${PROJECT_NAME})
install(PROGRAMS scripts/listener.py scripts/setup.sh DESTINATION lib/${PROJECT_NAME})
install(PROGRAMS launch/start.launch.py DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo', executable='talker'),
        Node(package='mixed', executable='listener.py'),
        Node(package='mixed', executable='setup.sh'),
    ])
"""
FILES = {
    ".git/HEAD": "ref: refs/heads/main\n",
    "demo/package.xml": AMENT.format(name="demo", type="ament_python"),
    "demo/setup.py": SETUP,
    "demo/setup.cfg": "[install]\ninstall_scripts=$base/lib/demo\n",
    "demo/demo/__init__.py": "",
    "demo/demo/talker.py": TALKER,
    "demo/launch/talk.launch.py": LAUNCH,
    "mixed/package.xml": AMENT.format(name="mixed", type="ament_cmake"),
    "mixed/CMakeLists.txt": CMAKE,
    "mixed/mixed/__init__.py": "",
    "mixed/scripts/listener.py": f"#!/usr/bin/env python3\n{LISTENER}",
    "mixed/scripts/setup.sh": "#!/bin/sh\n",
    "mixed/launch/start.launch.py": LAUNCH,
    "old/package.xml": PACKAGE.format(name="old"),
    "old/scripts/talker.py": "#!/usr/bin/env python3\nimport rospy\nrospy.init_node('talker')\nrospy.Publisher('old', rospy.AnyMsg)\n",
}


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Packages of both middlewares."""
    write(tmp_path / "workspace", FILES)
    (tmp_path / "workspace/old/scripts/talker.py").chmod(0o755)
    return tmp_path / "workspace"


def own(workspace: Path, cache: Path | None = None) -> OwnSources:
    packages = Packages([str(workspace)], {}, explicit=True)
    return OwnSources(packages, str(workspace), None if cache is None else str(cache))


def entries(program: Any, category: str) -> list[tuple[str, str, str]]:
    assert program is not None
    return [(each["name"], each["type"], each["evidence"][0]["at"]) for each in program["variants"]["default"][category]]


def test_an_entry_point_and_a_script(workspace: Path) -> None:
    sources = own(workspace).of(ROS2)
    talker = sources.program("demo", "executables", "talker")
    assert entries(talker, "publishers") == [("chatter", "std_msgs/msg/String", "demo/demo/talker.py:9")]
    assert talker is not None
    assert (talker["class"], talker["variants"]["default"]["node"]) == ("rclpy", "talker")
    assert talker["variants"]["default"]["publishers"][0]["qos"] == {
        "reliability": "reliable", "durability": "volatile", "history": "keep_last", "depth": 10,
    }  # fmt: skip
    listener = sources.program("mixed", "executables", "listener.py")
    assert entries(listener, "subscribers") == [("chatter", "std_msgs/msg/String", "mixed/scripts/listener.py:10")]


@pytest.mark.parametrize(
    ("package", "name", "reason"),
    [
        ("demo", "gone", "the module demo.gone was not found"),
        ("demo", "other", "its package has no source of it"),
        ("mixed", "setup.sh", "it is a script, but not Python"),
        ("mixed", "start.launch.py", "its package has no source of it"),
        ("old", "talker.py", ""),
        ("elsewhere", "x", ""),
    ],
)
def test_what_is_not_read_and_why(workspace: Path, package: str, name: str, reason: str) -> None:
    sources = own(workspace).of(ROS2)
    assert sources.program(package, "executables", name) is None
    assert sources.reason(package, "executables", name) == reason


def test_each_middleware_sees_its_own_packages(workspace: Path) -> None:
    first = own(workspace)
    assert first.has("old")
    assert not first.of(ROS2).has("old")
    assert first.of(ROS2).has("demo")
    assert not first.has("demo")
    assert first.of(ROS2).of(ROS1) is first
    assert [each.middleware for each in first.all] == [ROS1, ROS2]


def test_one_package_for_both(workspace: Path) -> None:
    types = (
        '<build_type condition="$ROS_VERSION == 1">catkin</build_type><build_type condition="$ROS_VERSION == 2">ament_python</build_type>'
    )
    write(workspace, {"demo/package.xml": FILES["demo/package.xml"].replace("<build_type>ament_python</build_type>", types)})
    assert own(workspace).has("demo")
    assert entries(own(workspace).of(ROS2).program("demo", "executables", "talker"), "publishers")


def test_a_package_of_each_middleware_under_one_name(workspace: Path) -> None:
    write(
        workspace, {f"ros1/demo/{path}": text for path, text in (("package.xml", PACKAGE.format(name="demo")), ("scripts/talker.py", ""))}
    )
    sources = own(workspace)
    assert (sources.home("demo"), sources.of(ROS2).home("demo")) != (None, None)
    assert entries(sources.of(ROS2).program("demo", "executables", "talker"), "publishers")


def test_what_was_read_is_kept_until_something_it_hangs_on_changes(workspace: Path, tmp_path: Path) -> None:
    key = ("demo", "executables", "talker")
    own(workspace, tmp_path / "kept").of(ROS2).program(*key)
    assert own(workspace, tmp_path / "kept").of(ROS2).digest(key)
    write(workspace, {"demo/setup.py": SETUP.replace("demo.talker:main", "demo.gone:main")})
    assert not own(workspace, tmp_path / "kept").of(ROS2).digest(key)


def test_check_and_graph_know_the_nodes(workspace: Path) -> None:
    ran = run(workspace, "check", "-v", "demo/launch/talk.launch.py")
    assert "2 of 3 nodes known" in ran.output + ran.errors
    assert "mixed/setup.sh (1 node): it is a script, but not Python" in ran.output + ran.errors
    graph = run(workspace, "graph", "demo/launch/talk.launch.py").output
    assert "(std_msgs/msg/String, reliable, volatile, keep_last 10, read from demo/demo/talker.py:9)" in graph


def test_a_later_run_says_the_same_until_the_source_is_another(workspace: Path) -> None:
    words = ("check", "-v", "demo")
    first = run(workspace, *words)
    assert "2 of 3 nodes known" in first.output + first.errors
    assert run(workspace, *words) == first
    (workspace / "demo/demo/talker.py").unlink()
    again = run(workspace, *words)
    assert "1 of 3 nodes known" in again.output + again.errors


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("<node pkg='a' exec='b'/>", [("a", "executables", "b")]),
        ("Node(executable='b', package='a')", [("a", "executables", "b")]),
        ("- node: {pkg: a, exec: b}", [("a", "executables", "b")]),
        ("ComposableNode(package='a', plugin='a::B')", [("a", "components", "a::B")]),
        ("package='a'" + " " * 500 + "executable='b'", []),
        ("<node pkg='a' type='b'/>", []),
    ],
)
def test_what_a_file_starts_is_seen_ahead(text: str, found: list[tuple[str, str, str]]) -> None:
    assert list(_started_in_ros2(text.encode())) == [(ROS2, key) for key in found]


def test_what_does_not_connect_is_told(workspace: Path) -> None:
    write(
        workspace,
        {
            "demo/demo/talker.py": TALKER.replace("10)", "rclpy.qos.qos_profile_sensor_data)"),
            "mixed/scripts/setup.sh": NODE.format(type="Int32", name="counter", call="create_subscription(Int32, 'chatter', print, 10)"),
        },
    )
    write(workspace, {"mixed/scripts/setup.sh": f"#!/usr/bin/env python3\n{(workspace / 'mixed/scripts/setup.sh').read_text()}"})
    output = run(workspace, "check", "--format", "concise", "demo").output
    assert "LL942" in output
    assert "LL611" in output
    assert "LL942" not in run(workspace, "check", "--no-extract", "--format", "concise", "demo").output

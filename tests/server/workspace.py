"""A small workspace that the tests of the server hold open."""

from __future__ import annotations

from pathlib import Path

PACKAGE = """<package format="2"><name>demo</name><version>1.0.0</version><description>A demo.</description>
<maintainer email="a@example.com">A</maintainer><license>MIT</license><exec_depend>turtlesim</exec_depend></package>
"""
MAIN = """<launch>
  <arg name="sim" default="true"/>
  <arg name="unused" default="1"/>
  <include file="$(find demo)/launch/part.launch" if="$(arg sim)">
    <arg name="rate" value="10"/>
  </include>
  <node name="turtle" pkg="turtlesim" type="turtlesim_node">
    <rosparam command="load" file="$(find demo)/config/turtle.yaml"/>
  </node>
  <node name="turtle" pkg="turtlesim" type="turtlesim_node"/>
</launch>
"""
PART = """<launch>
  <arg name="rate"/>
  <node name="teleop" pkg="turtlesim" type="turtle_teleop_key">
    <param name="rate" value="$(arg rate)"/>
    <remap from="turtle1/cmd_vel" to="cmd_vel"/>
  </node>
</launch>
"""
ROS2_XML = """<launch>
  <arg name="world" default="empty"/>
  <include file="$(find-pkg-share demo2)/launch/part.launch.yaml">
    <arg name="speed" value="$(var world)"/>
  </include>
  <node pkg="turtlesim" exec="turtlesim_node" name="turtle"/>
</launch>
"""
ROS2_YAML = """launch:
- arg:
    name: speed
- node:
    pkg: turtlesim
    exec: turtle_teleop_key
    name: $(var speed)
"""
ROS2_PYTHON = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('name', default_value='turtle'),
        Node(package='turtlesim', executable='turtlesim_node', name=LaunchConfiguration('name')),
    ])
"""
PACKAGE2 = """<package format="3"><name>demo2</name><version>1.0.0</version><description>A demo.</description>
<maintainer email="a@example.com">A</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<exec_depend>turtlesim</exec_depend><export><build_type>ament_cmake</build_type></export></package>
"""
FILES = {
    "demo/package.xml": PACKAGE,
    "demo/launch/main.launch": MAIN,
    "demo/launch/part.launch": PART,
    "demo/config/turtle.yaml": "background_r: 10\nbackground_r: 20\n",
    "demo2/package.xml": PACKAGE2,
    "demo2/launch/world.launch.xml": ROS2_XML,
    "demo2/launch/part.launch.yaml": ROS2_YAML,
    "demo2/launch/turtle.launch.py": ROS2_PYTHON,
}


def make(directory: Path) -> Path:
    """Write the workspace. Returns its directory."""
    directory.mkdir(exist_ok=True)
    (directory / ".git").mkdir()
    for name, text in FILES.items():
        (directory / name).parent.mkdir(exist_ok=True, parents=True)
        (directory / name).write_text(text, encoding="utf-8")
    return directory

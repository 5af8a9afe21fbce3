"""A launch file of ROS 1 lies in a package that is built for ROS 2.

What it does: it looks at launch files whose words are those of roslaunch (`type` of a `<node>`, `$(find …)`, `<rosparam>` …) in a package
that ament alone builds (`<build_type>` in its `package.xml`). A package that is switched between the two is passed over: its build types
have conditions, another manifest (`package_ros1.xml`) lies beside `package.xml`, or its `CMakeLists.txt` names catkin. All such files of
one package are told of at once, and nothing else is said of them.

## Why it matters

`ros2 launch` refuses the file, and nobody who has the package built starts roslaunch. Mostly it was left behind when the package was
ported: it speaks of files, params and programs that are no longer there, and misleads whoever looks for the right one.

## Example

```xml launch/robot.launch
<launch>
  <node pkg="my_robot" type="driver" name="driver" output="screen"/>
  <rosparam command="load" file="$(find my_robot)/config/driver.yaml"/>
</launch>
```

```xml package.xml
<package format="3">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
```

## Use instead

```xml launch/robot.launch
<launch>
  <node pkg="my_robot" exec="driver" name="driver" output="screen">
    <param from="$(find-pkg-share my_robot)/config/driver.yaml"/>
  </node>
</launch>
```

```xml package.xml
<package format="3">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView
from launchlint.workspace.other_ros import built_for_ros2

RULE = Rule("LL115", "left-from-ros1", Severity.WARNING)


def check(view: FileView) -> Iterator[Finding]:
    """Point at the root of a launch file of ROS 1 whose package ament builds (REP 149)."""
    document = view.document
    package = None if document.root is None else built_for_ros2(document.source.file, view.packages)
    if package is None or document.root is None:
        return
    yield RULE.at(
        document.place(document.root.name_span),
        f"this launch file is for ROS 1, and its package {package.name} is built for ROS 2",
        label="for roslaunch",
        notes=("ros2 launch refuses it; nothing else is said of it",),
        help="remove it, or write it for ros2 launch",
        cause=shown(package.manifest_path, root_of(document.source)),
    )

"""A launch file of ROS 1 lies in a package that is built for ROS 2.

What it does: it looks at launch files whose words are those of roslaunch (`type` of a `<node>`, `$(find …)`, `<rosparam>` …) in a package
that ament alone builds (`<build_type>` in its `package.xml`). One such word, or a `<param>` in `<launch>`, is enough in a file that is
called as those of ROS 1 are (`robot.launch`) and has not one word of ROS 2. A package that is switched between the two is passed over: its
build types have conditions, another manifest (`package_ros1.xml`) lies beside `package.xml`, or its `CMakeLists.txt` names catkin, and not
only variables of it (`${catkin_INCLUDE_DIRS}`). All such files of one package are told of at once, and nothing else is said of them. In a
workspace of ROS 2 (its files name distributions of ROS 2 and none of ROS 1, or colcon has built it, and ament builds many of its packages)
the packages of catkin wait for being ported, or were forgotten: that is one information for all of them. It is an information, too, where a
directory is named for ROS 1 (`launch_ros1`), and where a file shows the URDF of a package that is not here, and asks nothing else: a CAD
program's exporter wrote it.

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

import re
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.model import ROS2
from launchlint.plural import listed
from launchlint.rules.judging.joined import joined
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView
from launchlint.source import Place
from launchlint.syntax.dialect import told
from launchlint.workspace.other_ros import built_for_ros2, left_over

_FINDS = late(r"\$\(find ([\w-]{1,200})\)")
_MODEL = late(r"\$\(find [\w-]{1,200}\)/(?:urdf|robots)/([\w-]{1,200})\.(?:urdf|URDF)\b")
_NAMED = late(r"(?<![^/])[^/]{0,255}ros_?1(?![0-9])[^/]{0,255}(?=/)")
_MOST_NAMED = 4
RULE = Rule("LL115", "left-from-ros1", Severity.WARNING)


def check(view: FileView) -> Iterator[Finding]:
    """Point at the root of a launch file of ROS 1 whose package ament builds (REP 149)."""
    document = view.document
    package = None if document.root is None else built_for_ros2(document.source.file, view.packages)
    if document.root is None:
        return
    if package is None:
        waiting = left_over(document.source.file, view.packages)
        if waiting is not None:
            yield _waiting(document.place(document.root.name_span), waiting.name)
        return
    if told(document, ROS2, of_ros2_only=True) == ROS2:
        return  # a launch file of ROS 1 includes it, and is told of that
    kept = _NAMED.search(document.source.path)
    exported = _exported(document.source.text, view)
    yield RULE.at(
        document.place(document.root.name_span),
        f"this launch file is for ROS 1, and its package {package.name} is built for ROS 2",
        severity=None if kept is None and not exported else Severity.INFO,
        label="for roslaunch",
        notes=("ros2 launch refuses it; nothing else is said of it", *_why(kept, exported)),
        help="remove it, or write it for ros2 launch",
        cause=f"ported {'' if kept is None else kept[0]}{exported}",
        about=(package.name,),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """One for all that a port has left, with the names of the packages."""
    packages = list(dict.fromkeys(name for each in findings for name in each.about))
    told = joined(findings)
    if len(packages) < 2:
        return told
    return told._replace(
        message=f"{len(findings)} launch files are for ROS 1, and their packages are built for ROS 2: {listed(packages, _MOST_NAMED)}",
        help="remove them, or write them for ros2 launch",
    )


def _why(kept: re.Match[str] | None, exported: str) -> tuple[str, ...]:
    """What tells that nobody here is to start it."""
    if kept is not None:
        return (f"{kept[0].strip('/')} says so itself",)
    return (
        (f"it shows the model of a package {exported}, which is not here: a CAD program's exporter writes such files",) if exported else ()
    )


def _exported(text: str, view: FileView) -> str:
    """The package, not here, that all of a launch file is about: it shows the URDF of that name, as exporters of models write it."""
    asked = set(_FINDS.findall(text))
    if len(asked) != 1 or view.packages.has(name := asked.pop()):
        return ""
    return name if any(each == name for each in _MODEL.findall(text)) else ""


def _waiting(place: Place, package: str) -> Finding:
    return RULE.at(
        place,
        f"this launch file is for ROS 1, as its package {package} is, and the workspace is one of ROS 2",
        severity=Severity.INFO,
        label="for roslaunch",
        notes=("colcon does not build a package of catkin for ROS 2; nothing else is said of the file",),
        help="port the package, or put a COLCON_IGNORE into it",
        cause="waiting",
    )

"""A node's `type` names no executable of its package.

What it does: where the package lies in the workspace or is installed, it looks for the `type` among the programs that its
`CMakeLists.txt` builds, its scripts, and its installed files. It is an error where the package is installed or the name is one
slip away from a program of it; otherwise a warning. Nothing is said where the list of programs may have gaps, as with packages
below `/usr`, whose programs Debian distributes over several packages of its own.

## Why it matters

roslaunch loads such a file without a word and fails only when it starts the node, after the other nodes are up.

## Example

```xml
<launch>
  <node pkg="my_robot" type="drive_nod" name="drive"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
</package>
```

```cmake CMakeLists.txt
project(my_robot)
find_package(catkin REQUIRED)
catkin_package()
add_executable(drive_node src/drive.cpp)
```

## Use instead

```xml
<launch>
  <node pkg="my_robot" type="drive_node" name="drive"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
</package>
```

```cmake CMakeLists.txt
project(my_robot)
find_package(catkin REQUIRED)
catkin_package()
add_executable(drive_node src/drive.cpp)
```

## Fix

`--unsafe-fixes` writes the executable of the package that the name is one slip away from.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.model import Node
from launchlint.rules.edits import fix, is_literal, set_value, spot
from launchlint.rules.package_contents import contents
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin
from launchlint.spelling import closest, one_slip
from launchlint.workspace.packages import SYSTEM_SHARE

RULE = Rule("LL304", "unknown-executable", Severity.ERROR, roslaunch="reports", fixable="unsafe")

_MOST_NAMED = 6


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield one finding for each node or test whose executable is not there (roslib.packages.find_node)."""
    launch = view.launch
    for node in (*launch.nodes, *launch.tests):
        name = node.executable
        if node.unknown & {"pkg", "type"} or not name.strip() or "/" in name:
            continue
        package = view.packages.get(node.package, launch.entry.file)
        if package is None:
            continue
        known = contents(view.packages).executables(package)
        if name in known.by_name or known.flaw(name) is not None:
            continue
        slip = _slip(name, known.names)
        exhaustive = known.exhaustive and not package.directory.startswith(SYSTEM_SHARE + "/")
        if not exhaustive and slip is None:
            continue
        assumed = any(condition.assumed for condition in node.conditions)
        certain = exhaustive and (known.installed or slip is not None) and not assumed
        near = slip or closest(name, known.names)
        some = ", ".join(known.names[:_MOST_NAMED]) + (" …" if len(known.names) > _MOST_NAMED else "")
        has = f"it has: {some}" if some else "it has no executables at all"
        yield RULE.at(
            Origin(node.attributes.get("type", node.origin.place), node.origin.step),
            f"the package {node.package} has no executable {name}",
            severity=Severity.ERROR if certain else Severity.WARNING,
            label="not found",
            notes=(has, "roslaunch loads the file and fails when it starts this node"),
            help=f"did you mean {near}?" if near else f"correct the type, or add {name} to the CMakeLists.txt or scripts of {node.package}",
            fix=None if slip is None else _fix(node, view, slip),
        )


def _fix(node: Node, view: LaunchView, slip: str) -> Fix | None:
    place = node.attributes.get("type")
    if place is None or not is_literal(place, node.executable):
        return None
    return fix(f"write {slip}", set_value(spot(view, place), slip), safe=False, changes=f"{slip} is started")


def _slip(name: str, names: list[str]) -> str | None:
    """The one executable that ``name`` is a slip for; ``drive1`` and ``drive2`` are neighbours, not slips."""
    stem = name.removesuffix(".py")
    for other in names:
        if other != name and other.removesuffix(".py") == stem:
            return other
    slip = one_slip(name, names)
    if slip is None or "".join(filter(str.isdigit, slip)) != "".join(filter(str.isdigit, name)):
        return None
    return slip

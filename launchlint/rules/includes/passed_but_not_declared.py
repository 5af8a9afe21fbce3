"""An `<include>` passes an arg that the included file neither declares nor reads, nor anything that is executed after it.

What it does: it looks for the name in the included file, in all that this one includes, and in all that comes after the include, since
what is passed stays set. Where a launch file in Python is among what is included, it may read anything, and nothing is said.
What one file passes to several others, none of which knows it, is told once.

## Why it matters

`ros2 launch` takes any name without a word: the included file goes on with its default.

## Example

```xml main.launch.xml
<launch>
  <push_ros_namespace namespace="front"/>
  <include file="$(dirname)/camera.launch.xml">
    <arg name="frame_rat" value="15"/>
  </include>
</launch>
```

```xml camera.launch.xml
<launch>
  <arg name="frame_rate" default="30.0"/>
  <node pkg="usb_cam" exec="usb_cam_node_exe" name="camera">
    <param name="framerate" value="$(var frame_rate)"/>
  </node>
</launch>
```

## Use instead

```xml main.launch.xml
<launch>
  <push_ros_namespace namespace="front"/>
  <include file="$(dirname)/camera.launch.xml">
    <arg name="frame_rate" value="15.0"/>
  </include>
</launch>
```

```xml camera.launch.xml
<launch>
  <arg name="frame_rate" default="30.0"/>
  <node pkg="usb_cam" exec="usb_cam_node_exe" name="camera">
    <param name="framerate" value="$(var frame_rate)"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.ros2.problems import PassedForNothing
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.passed_for_nothing import about, of_one_file, of_several_files, said
from launchlint.rules.rule import Rule
from launchlint.spelling import closest

RULE = Rule("LL913", "passed-but-not-declared", Severity.WARNING)


def tell(problem: PassedForNothing, view: object) -> Iterator[Finding]:
    """Say which arg is passed for nothing (launch.actions.IncludeLaunchDescription sets whatever it is given)."""
    name, file = problem.name, problem.file
    near = closest(name, problem.known)
    if near is None and not problem.certain:
        return
    yield RULE.at(
        problem.origin,
        said([file], [name]),
        label="passed for nothing",
        notes=("ros2 launch sets whatever an include passes, and does not ask whether the file declares it",),
        help=f"did you mean {near}?" if near is not None else "remove it, or declare it there",
        topic=name,
        cause=file if near is None else f"{file} {name}",
        about=about(name, file, near),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """All that is passed to one file for nothing, by the names of the args."""
    return of_one_file(findings)


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for what one file passes to several for nothing."""
    return of_several_files(findings)

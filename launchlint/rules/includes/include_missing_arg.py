"""An `<include>` does not pass an arg that the included file needs.

What it does: it looks for args that the included file declares without a default, reads in this configuration, and does not get.

## Why it matters

roslaunch refuses the whole launch.

## Example

```xml
<launch>
  <include file="$(dirname)/camera.launch"/>
</launch>
```

```xml camera.launch
<launch>
  <arg name="device"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera">
    <param name="video_device" value="$(arg device)"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/camera.launch">
    <arg name="device" value="/dev/video0"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <arg name="device"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera">
    <param name="video_device" value="$(arg device)"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.spelling import closest

RULE = Rule("LL404", "include-missing-arg", Severity.ERROR, roslaunch="refuses")


def tell(problem: Problem, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``include-missing-arg`` (roslaunch.xmlloader._include_tag)."""
    name, file, passed = problem.facts["name"], problem.facts["file"], problem.facts["passed"]
    near = closest(name, passed)
    help = f'add <arg name="{name}" value="…"/> inside the include, or give it a default in {file}'
    yield RULE.at(
        problem.origin,
        f"{file} needs the arg {name}, which is not passed",
        label="included without it",
        related=problem.related,
        notes=(f"roslaunch stops with: included file [{problem.facts['target']}] requires the '{name}' arg to be set",),
        help=f"is {near}, which is passed, meant to be {name}? Else {help}" if near is not None else help,
        topic=name,
    )

"""A value is given to an arg that is fixed.

An `<arg>` with `value` cannot be changed from outside; one with `default` can. An `<include>` that passes a fixed arg
is refused (with `pass_all_args` it is not: then the fixed value silently wins).

## Why it matters

roslaunch refuses the file.

## Example

```xml
<launch>
  <include file="$(dirname)/camera.launch">
    <arg name="rate" value="15"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <arg name="rate" value="30"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera" args="_framerate:=$(arg rate)"/>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/camera.launch">
    <arg name="rate" value="15"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <arg name="rate" default="30"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera" args="_framerate:=$(arg rate)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import ArgOverrideRefused
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule

RULE = Rule("LL212", "arg-override-refused", Severity.ERROR, roslaunch="refuses")


def tell(problem: ArgOverrideRefused, view: object) -> Iterator[Finding]:
    """Point at who gives and who fixes it."""
    name = problem.name
    if problem.by_include:
        message, label = f"the arg {name} cannot be passed: {problem.file} fixes its value", "refused"
        advice = f"remove this, or write default instead of value where {name} is declared"
    else:
        message, label = f"the arg {name} is given on the command line, and its value is fixed here", "fixed"
        advice = f"write default instead of value, or do not give {name}"
    yield RULE.at(
        problem.origin,
        message,
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label=label,
        related=problem.related,
        notes=(f"roslaunch stops with: cannot override arg '{name}', which has already been set",),
        help=advice,
        topic=name,
    )

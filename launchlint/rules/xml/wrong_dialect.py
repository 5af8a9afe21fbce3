"""A tag, attribute or substitution of ROS 2 stands in a ROS 1 launch file.

`exec` and `namespace` of a `<node>`, `<let>`, `<push-ros-namespace>`, `$(var …)` and `$(find-pkg-share …)` belong to
the launch files of ROS 2, which look much the same.

## Why it matters

roslaunch skips the tags and attributes that it does not know, and refuses the substitutions. A node with `exec` in
place of `type` is refused as well.

## Example

```xml
<launch>
  <arg name="map" default="office"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(var map).yaml"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="map" default="office"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule

RULE = Rule("LL112", "wrong-dialect", Severity.ERROR, roslaunch="refuses")


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Give the way of ROS 1; facts: ``tag``, ``what`` (tag, attribute or substitution), ``construct``, ``instead``."""
    facts = problem.facts
    what, construct, instead = facts["what"], facts["construct"], facts["instead"]
    if what == "tag":
        message, note = f"<{construct}> is a tag of ROS 2", "roslaunch (ROS 1) prints a warning and skips it, with all that it contains"
    elif what == "attribute":
        message = f"{construct} is an attribute of ROS 2"
        dropped = "roslaunch (ROS 1) prints a warning and drops it"
        note = f"{dropped}, and then misses the attribute it needs instead" if problem.refused else dropped
    else:
        message, note = f"{construct} is a substitution of ROS 2", "roslaunch (ROS 1) stops with: Unknown substitution command"
    yield RULE.at(
        problem.origin,
        message,
        label="ROS 2",
        notes=(note,),
        help=f"in ROS 1: {instead}" if instead else "ROS 1 has nothing like it: remove it",
    )

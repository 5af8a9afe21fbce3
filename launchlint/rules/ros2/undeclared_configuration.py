"""A launch file reads a launch configuration that it does not declare, and that only the files around it set.

What it does: it looks for each `$(var x)` of an included file that neither this file nor one that it includes declares or sets. It is a
warning where the value was left by another include that came before: then the order of two includes decides. (Where nothing sets it at all,
that is LL201.)

## Why it matters

The file works only when it is included from there: started by itself it stops, `ros2 launch --show-args` does not list what it needs, and
who renames the arg in the including file does not see that it is read here.

## Example

```xml main.launch.xml
<launch>
  <arg name="camera_name" default="front"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="driver"/>
  <include file="$(dirname)/camera.launch.xml"/>
</launch>
```

```xml camera.launch.xml
<launch>
  <node pkg="usb_cam" exec="usb_cam_node_exe" name="$(var camera_name)"/>
</launch>
```

## Use instead

```xml main.launch.xml
<launch>
  <arg name="camera_name" default="front"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="driver"/>
  <include file="$(dirname)/camera.launch.xml">
    <arg name="camera_name" value="$(var camera_name)"/>
  </include>
</launch>
```

```xml camera.launch.xml
<launch>
  <arg name="camera_name"/>
  <node pkg="usb_cam" exec="usb_cam_node_exe" name="$(var camera_name)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.ros2.problems import UndeclaredRead
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.never_declared import all_undeclared, never_declared
from launchlint.rules.rule import Rule
from launchlint.rules.wording import words_at

RULE = Rule("LL914", "undeclared-configuration", Severity.INFO)


def tell(problem: UndeclaredRead, view: object) -> Iterator[Finding]:
    """Say who sets it (launch.substitutions.LaunchConfiguration asks the context, whoever has set it)."""
    name, path, setter = problem.name, problem.place.source.path, problem.setter
    if problem.left:
        message = f"{name} is not declared in {path}: it has a value only because {setter} was executed before"
    else:
        message = f"{name} is not declared in {path}: it has a value only because {setter} sets it"
    yield RULE.at(
        problem.origin,
        message,
        severity=Severity.WARNING if problem.left else None,
        label="not declared here",
        related=problem.related,
        notes=(f"started by itself the file stops with: launch configuration '{name}' does not exist",),
        help=f"declare it: {words_at(problem.origin).declared(name)}, and pass it in the include",
        topic=name,
        shared_cause=never_declared(path),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """All that one file does not declare, by the names."""
    return all_undeclared(findings)

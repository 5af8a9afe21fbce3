"""A robot description that a command prints is given to a node as YAML, not as a text.

What it does: it looks for a param whose value is `$(command …)` of xacro, or of a file with a robot in it, and that does not say
`type="str"`. In a `<set_parameter>`, which has no type, it is always so.

## Why it matters

launch reads the value of a param as YAML unless its type is given. An XML file mostly goes through, until somebody adds a comment with a
colon to it: then `ros2 launch` stops with *Unable to parse the value of parameter robot_description as yaml*; after a blank and a `#` the
rest of a line is lost without a word.

## Example

```xml
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher" name="robot_state_publisher">
    <param name="robot_description" value="$(command 'xacro $(dirname)/robot.urdf.xacro')"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher" name="robot_state_publisher">
    <param name="robot_description" value="$(command 'xacro $(dirname)/robot.urdf.xacro')" type="str"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import CommandReadAsYaml
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule

RULE = Rule("LL907", "string-parsed-as-yaml", Severity.WARNING)


def tell(problem: CommandReadAsYaml, view: object) -> Iterator[Finding]:
    """Say how it stays a text (launch_ros.parameter_descriptions.ParameterValue)."""
    advice = (
        'write type="str" beside the value' if problem.typed else 'give it to the nodes themselves: <param name="…" value="…" type="str"/>'
    )
    if problem.place.source.file.endswith(".py"):
        advice = "write ParameterValue(…, value_type=str) around it"
    yield RULE.at(
        problem.origin,
        f"launch reads what this command prints as YAML before it gives it to the param {problem.name}",
        label="XML, read as YAML",
        notes=("a colon and a blank in a comment of that file are enough for ros2 launch to stop",),
        help=advice,
        topic=problem.name,
        cause=f"{problem.place.source.path} {problem.name}",
    )

"""A robot description that a command prints is given to a node as YAML, not as a text.

What it does: it looks for a param whose value is `$(command …)` of xacro, or of a file with a robot in it, and that does not say
`type="str"`. In a `<set_parameter>`, which has no type, it is always so. It is a warning where the file has a colon with a blank behind it,
or a blank with a `#` behind it; else it is information. All such params of one file are one finding.

## Why it matters

launch reads the value of a param as YAML unless its type is given. An XML file goes through as a text until somebody adds a comment with a
colon to it: then `ros2 launch` stops with *Unable to parse the value of parameter robot_description as yaml*; after a blank and a `#` the
rest of a line is lost without a word.

## Example

```xml robot.launch.xml
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher" name="robot_state_publisher">
    <param name="robot_description" value="$(command 'xacro $(dirname)/robot.urdf.xacro')"/>
  </node>
</launch>
```

```xml robot.urdf.xacro
<robot name="r2" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- measured: to the middle of the wheel -->
  <link name="base_link"/>
</robot>
```

## Use instead

```xml robot.launch.xml
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher" name="robot_state_publisher">
    <param name="robot_description" value="$(command 'xacro $(dirname)/robot.urdf.xacro')" type="str"/>
  </node>
</launch>
```

```xml robot.urdf.xacro
<robot name="r2" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- measured: to the middle of the wheel -->
  <link name="base_link"/>
</robot>
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import CommandReadAsYaml
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.wording import words_at
from launchlint.workspace.looking import content

_COLON = re.compile(rb":(?:[ \t]|$)", re.MULTILINE)
# xacro takes out the comments in front of its own elements (xacro.remove_previous_comments).
_COMMENTS = re.compile(rb"(?:<!--.*?(?:-->|\Z)[ \t\r]*(?:\n[ \t\r]*)?)+(<xacro:)?", re.DOTALL)
RULE = Rule("LL907", "string-parsed-as-yaml", Severity.WARNING)


def tell(problem: CommandReadAsYaml, view: object) -> Iterator[Finding]:
    """Say how it stays a text (launch_ros.parameter_descriptions.ParameterValue)."""
    words = words_at(problem.origin)
    typed = words.written("param", {"name": "…", "value": "…", "type": "str"}, "")
    advice = f"write {words.set_to('type', 'str')} beside the value" if problem.typed else f"give it to the nodes themselves: {typed}"
    if words.language == "python":
        advice = "write ParameterValue(…, value_type=str) around it"
    breaks, named = _breaks(problem.file), problem.file.rpartition("/")[2]
    yield RULE.at(
        problem.origin,
        f"launch reads what this command prints as YAML before it gives it to the param {problem.name}",
        label="XML, read as YAML",
        severity=None if breaks else Severity.INFO,
        notes=(
            f"{named} has {breaks}"
            if breaks
            else "a colon with a blank behind it in a comment of that file is enough for ros2 launch to stop",
        ),
        help=advice,
        topic=problem.name,
        cause=problem.place.source.path,
    )


def _breaks(file: str) -> str:
    """What in a file is something else in YAML than in a text; empty where nothing is, or the file is not known."""
    data = _COMMENTS.sub(lambda match: match[1] or match[0], (content(file) or b"") if file else b"")
    if _COLON.search(data):
        return "a colon with a blank behind it, at which ros2 launch stops unless xacro leaves that part out"
    return "a blank and a # behind it: the rest of that line is lost" if b" #" in data else ""

"""A `<set_parameter>` that rcl refuses: its value is empty, or its name is none.

launch passes it as `-p name:=value` to every node behind it. rcl takes no empty value there, not even a text of no characters, and in the
name only letters, digits, underscores, slashes, and points between them.

## Why it matters

Each node that is started behind it dies at once.

## Example

```xml talk.launch.xml
<launch>
  <set_parameter name="frame" value=""/>
  <node pkg="demo_nodes_cpp" exec="talker"/>
</launch>
```

## Use instead

```xml talk.launch.xml
<launch>
  <set_parameters_from_file filename="$(dirname)/all.yaml"/>
  <node pkg="demo_nodes_cpp" exec="talker"/>
</launch>
```

```yaml all.yaml
/**:
  ros__parameters:
    frame: ""
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import SetParameterDies
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.wording import words_at

RULE = Rule("LL909", "set-parameter-empty", Severity.ERROR)


def tell(problem: SetParameterDies, view: object) -> Iterator[Finding]:
    """Say that every node behind it dies."""
    words = words_at(problem.origin)
    what = "its value is empty" if problem.empty else problem.reason
    yield RULE.at(
        problem.origin,
        f"every node behind this {words.tag('set_parameter')} dies when it starts: {what}",
        label="",
        notes=(f"launch passes -p {problem.name}:={problem.value}, and rcl refuses that",),
        help=f"set the empty text in a parameter file under /**, and name that in {words.tag('set_parameters_from_file')}"
        if problem.empty
        else "",
    )

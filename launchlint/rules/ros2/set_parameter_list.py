"""A list in `<set_parameter>` reaches the ROS 2 nodes behind it as a text.

launch passes the value as `-p name:=value`, and writes a list as Python does: `(1, 2)`, which is a text to rcl. Composable nodes do
get the list.

## Why it matters

A node that declares a list dies with an exception about the wrong type, and one that declares nothing has the text `(1, 2)`.

## Example

```xml talk.launch.xml
<launch>
  <set_parameter name="limits" value="[1, 2]"/>
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
    limits: [1, 2]
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import ListBecomesText
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.wording import words_at

RULE = Rule("LL908", "set-parameter-list", Severity.ERROR)


def tell(problem: ListBecomesText, view: object) -> Iterator[Finding]:
    """Say what becomes of the list."""
    yield RULE.at(
        problem.origin,
        f"nodes get the list {problem.name} as the text {problem.text!r}",
        notes=(f"launch passes -p {problem.name}:={problem.text}, and that is no list to rcl",),
        help=f"put it into a parameter file under /**, and name that in {words_at(problem.origin).tag('set_parameters_from_file')}",
    )

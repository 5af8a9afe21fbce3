"""A parameter file of ROS 2 is one that rcl refuses.

rcl, the library under every node, reads the file when the node starts: node names, then `ros__parameters`, then names with values. It
takes no aliases (`*name`), no missing values, and no lists of mixed types: `[1, 2.0]` are two. What a launch file gives in `<param name>`
becomes such a file, too: in the list `[x, y]` the second item is true to rcl.

## Why it matters

`ros2 launch` does not look into the file, and starts the node, which dies at once.

## Example

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
talker:
  ros__parameters:
    limits: [1, 2.5]
```

## Use instead

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
talker:
  ros__parameters:
    limits: [1.0, 2.5]
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import ParameterDies, ParametersFileDies
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.wording import words_at

RULE = Rule("LL904", "params-file-refused", Severity.ERROR)


def tell(problem: ParametersFileDies | ParameterDies, view: object) -> Iterator[Finding]:
    """Say why, and who dies of it."""
    if isinstance(problem, ParameterDies):
        yield RULE.at(
            problem.origin,
            f"{problem.node} cannot start with this {words_at(problem.origin).tag('param')}: {problem.reason}",
            notes=("launch writes it into a file for the node, texts without quotes where YAML needs none, and rcl refuses that file",),
            help="put the param into a parameter file, with quotes around each text",
        )
        return
    name = problem.file.rpartition("/")[2]
    yield RULE.at(
        problem.origin,
        f"nodes cannot start with the parameter file {name}: {problem.reason}",
        label="here",
        related=problem.related,
        notes=(f"ros2 launch starts {problem.node}, and it dies at once: rcl refuses the file",),
        help=problem.instead,
    )

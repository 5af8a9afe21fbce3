"""A key with wildcards in a parameter file says nothing to a composable node.

launch reads the parameter files of composable nodes itself, and knows only `/**` and the full name of the node. What rcl understands
for any other node, `/**/n`, `/*/n` or `/ns/*`, is a name like any other there.

## Why it matters

The node is loaded without these params, with the defaults of its program, and nobody says so.

## Example

```xml talk.launch.xml
<launch>
  <load_composable_node target="/container">
    <composable_node pkg="demo_nodes_cpp" plugin="demo_nodes_cpp::Talker" name="talker" namespace="front">
      <param from="$(dirname)/talker.yaml"/>
    </composable_node>
  </load_composable_node>
</launch>
```

```yaml talker.yaml
/**/talker:
  ros__parameters:
    rate: 5
```

## Use instead

```xml talk.launch.xml
<launch>
  <load_composable_node target="/container">
    <composable_node pkg="demo_nodes_cpp" plugin="demo_nodes_cpp::Talker" name="talker" namespace="front">
      <param from="$(dirname)/talker.yaml"/>
    </composable_node>
  </load_composable_node>
</launch>
```

```yaml talker.yaml
/front/talker:
  ros__parameters:
    rate: 5
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import ComponentKeyIgnored
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule

RULE = Rule("LL902", "composable-key-ignored", Severity.WARNING)


def tell(problem: ComponentKeyIgnored, view: object) -> Iterator[Finding]:
    """Say what launch would understand."""
    yield RULE.at(
        problem.origin,
        f"the params under {problem.key} do not reach the composable node {problem.node}",
        label="no wildcard to launch",
        related=problem.related,
        notes=("launch reads this file itself: it knows /** and the full name of a composable node, and no other wildcards",),
        help=f"write {problem.node}, or /** for all",
        cause=f"{problem.file} {problem.key}",
    )

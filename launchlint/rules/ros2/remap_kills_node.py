"""A remap of a ROS 2 node is one that rcl refuses.

Both sides are names: letters, digits and single underscores, in parts between slashes, with `/` or `~/` in front. Wildcards, `{node}`,
a slash at the end, a digit at the beginning of a part, and an empty side are refused. It is a warning where only another value of an arg
than its default makes the name.

## Why it matters

launch passes it on as it is, and the node dies when it starts.

## Example

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker">
    <remap from="chatter" to="front-left/chatter"/>
  </node>
</launch>
```

## Use instead

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker">
    <remap from="chatter" to="front_left/chatter"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import RemapDies
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL947", "remap-kills-node", Severity.ERROR)


def tell(problem: RemapDies, view: LaunchView) -> Iterator[Finding]:
    """Say what is wrong, and on which side."""
    shown = problem.source if problem.side == "from" else problem.target
    text = problem.place.text
    written = shown in text if shown else "$(" not in text
    yield RULE.at(
        problem.origin,
        f"{problem.node} dies when it starts: rcl refuses this remap, since {problem.reason}",
        severity=None if written or not view.launch.given else Severity.WARNING,
        label=f"{problem.side}={shown!r}" if shown else f"{problem.side} is empty",
        notes=(f"launch passes -r {problem.source}:={problem.target}, and does not look at it",),
    )

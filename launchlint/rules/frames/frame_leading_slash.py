"""A param names a frame with a `/` before it, and its node hands the name to tf2, which refuses that.

What it does: it looks at the params of which the library knows that the node gives their value to tf2 as it is. tf took the `/` off, and
many nodes do so themselves: they are not told. It is an info where the workspace names only distributions of ROS that are older than
Melodic, whose nodes mostly use tf. All such params of one program are told as one: who keeps the `/` keeps it in each configuration.

## Why it matters

tf2 answers every question about `/map` with *frame_ids cannot start with a '/'*. A costmap waits for ever, a filter drops all its data.
Files that were written for nodes with tf (ROS Kinetic and older) break so with newer ones.

## Example

```xml
<launch>
  <node pkg="move_base" type="move_base" name="move_base">
    <param name="global_costmap/global_frame" value="/map"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="move_base" type="move_base" name="move_base">
    <param name="global_costmap/global_frame" value="map"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.param_values import is_certain
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL623", "frame-leading-slash", Severity.WARNING)
WITH_TF2 = "melodic"
"""The distribution in which the nodes of the navigation stack, the last of the widely used ones, left tf for tf2."""
OLDER = "the workspace names only older distributions of ROS"


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every frame that goes to tf2 as it is (tf2::BufferCore::warnFrameId, validateFrameId)."""
    graph = view.graph
    for instance in graph.instances:
        for frame in instance.frames:
            setting = graph.parameters.setting(frame.parameter) if frame.parameter else None
            if frame.through != "tf2" or not frame.name.startswith("/") or not frame.certain or setting is None or not is_certain(setting):
                continue
            old = view.packages.distributions().are_older_than(WITH_TF2)
            yield RULE.at(
                setting.origin,
                f"{instance.program} gives the frame {frame.name} to tf2, which refuses names that begin with a /",
                severity=Severity.INFO if old else None,
                label=f"write {frame.name.lstrip('/')}",
                notes=(
                    f"it is the value of {frame.parameter}; tf, which older releases of many nodes use, takes the / off",
                    *([OLDER] if old else []),
                ),
                help=f"write {frame.name.lstrip('/')}",
                topic=frame.name,
                cause=f"{RULE.id} {instance.program}",
            )

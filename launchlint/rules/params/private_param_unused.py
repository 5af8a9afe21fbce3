"""A `~param` stands outside a node, and no node follows it in its scope.

Outside a node, `<param name="~rate" …/>` sets the parameter `rate` of every node that comes after it in the same
group or file. It does not act on the nodes above it, nor on those of another group.

## Why it matters

The parameter is never set, and roslaunch does not say so.

## Example

```xml
<launch>
  <node pkg="laser" type="driver" name="front"/>
  <param name="~rate" value="20"/>
</launch>
```

## Use instead

```xml
<launch>
  <param name="~rate" value="20"/>
  <node pkg="laser" type="driver" name="front"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.reach import settings_of
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL506", "private-param-unused", Severity.WARNING)


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """Look at every ``~param`` outside a node."""
    for setting, acts in settings_of(view.launch, "param"):
        if acts:
            yield RULE.fine(setting.origin)
        elif acts is False:
            yield RULE.at(
                setting.origin,
                f"{setting.key} is set for the nodes that follow, and none follows here",
                label="acts on no node",
                related=tuple((place, "stands above it") for place in setting.before[-1:]),
                help="put it above the nodes, or into the <node> that it is meant for",
            )

"""A remap stands in a scope without nodes.

Outside a node, a `<remap>` acts on the nodes that come after it in the same group or file, and it ends with that
group or file: an included file cannot remap for the file that includes it.

## Why it matters

The remap does nothing, and roslaunch does not say so.

## Example

```xml
<launch>
  <group ns="robot">
    <remap from="scan" to="front/scan"/>
  </group>
  <node pkg="rviz" type="rviz" name="rviz"/>
</launch>
```

## Use instead

```xml
<launch>
  <group ns="robot">
    <remap from="scan" to="front/scan"/>
    <node pkg="rviz" type="rviz" name="rviz"/>
  </group>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.reach import settings_of
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL603", "remap-out-of-effect", Severity.WARNING)


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """Look at every remap outside a node that has no nodes around it."""
    for setting, acts in settings_of(view.launch, "remap"):
        if acts:
            yield RULE.fine(setting.origin)
        elif acts is False and not setting.before:
            whole = setting.scope_end >= len(setting.origin.place.source.text.rstrip())
            yield RULE.at(
                setting.origin,
                f"the remap of {setting.key} acts on no node: its {'file' if whole else 'group'} starts none",
                label="acts on no node",
                help="a remap ends with its group or file: put it above the nodes it is meant for, or into their <node>",
            )

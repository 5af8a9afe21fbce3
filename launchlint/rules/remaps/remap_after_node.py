"""A remap stands below the nodes it was meant for.

Outside a node, a `<remap>` acts on the nodes that come after it in the same group or file, and on nothing above it. All
remaps below the same nodes are one finding, and so are those in several files of one directory.

## Why it matters

The remap does nothing, roslaunch does not say so, and the node talks on the topic of its old name.

## Example

```xml
<launch>
  <node pkg="rviz" type="rviz" name="rviz"/>
  <remap from="scan" to="front/scan"/>
</launch>
```

## Use instead

```xml
<launch>
  <remap from="scan" to="front/scan"/>
  <node pkg="rviz" type="rviz" name="rviz"/>
</launch>
```

## Fix

`--unsafe-fixes` moves it above the node, where there is only one in its scope. It acts on that node then.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Fix, Severity
from launchlint.model import ScopedSetting
from launchlint.rules.edits import fix, move_before, spot
from launchlint.rules.judging.joined import alike, joined
from launchlint.rules.judging.reach import settings_of
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL602", "remap-after-node", Severity.WARNING, fixable="unsafe")


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """Look at every remap outside a node that has nodes above it."""
    for setting, acts in settings_of(view.launch, "remap"):
        if acts:
            yield RULE.fine(setting.origin)
        elif acts is False and setting.before:
            count = len(setting.before)
            yield RULE.at(
                setting.origin,
                f"the remap of {setting.key} stands below all nodes of its scope, and acts on none of them",
                label="acts on no node",
                related=((setting.before[-1], "stands above it" if count == 1 else f"the last of {count} above it"),),
                help="put it above the nodes, or into the <node> that it is meant for",
                fix=_fix(setting, view) if count == 1 else None,
                cause=" ".join(map(str, setting.before[-1].key)),
            )


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for the files of one directory: whoever takes a remap to act on what stands above it does so in each of them."""
    for several in alike(findings, lambda each: posixpath.dirname(each.location.path)):
        yield from [joined(several)] if len({each.location.path for each in several}) > 1 else several


def _fix(setting: ScopedSetting, view: LaunchView) -> Fix | None:
    at, node = spot(view, setting.origin.place), spot(view, setting.before[0])
    if at is None or node is None or node.document is not at.document:
        return None
    other = node.element
    while other.parent is not None and other.parent is not at.element.parent:
        other = other.parent
    what = f"move it above the <{other.tag}>"
    return fix(what, move_before(at, other), safe=False, changes=f"{setting.key} of that node is remapped to {setting.value.target}")

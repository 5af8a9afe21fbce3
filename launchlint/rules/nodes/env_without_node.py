"""An `<env>` acts on no node.

What it does: an `<env>` outside nodes sets an environment variable for the nodes and tests that stand below it in its scope: in
the same file or group, and in what is included there. It speaks where there are none in any configuration that was found, and is
silent where an include in the scope cannot be followed, or a condition of unknown value may bring nodes.

## Why it matters

The variable is set for nobody. Usually the line was meant for the nodes above it, or for the including file, where it has no
effect.

## Example

```xml
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
  <env name="ROSCONSOLE_FORMAT" value="${message}"/>
</launch>
```

## Use instead

```xml
<launch>
  <env name="ROSCONSOLE_FORMAT" value="${message}"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.reach import settings_of
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL315", "env-without-node", Severity.WARNING)

_MOST_SHOWN = 3


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """Yield one finding for each scoped ``<env>`` that no node follows (roslaunch.loader.Loader.load_env)."""
    for setting, acts in settings_of(view.launch, "env"):
        if acts:
            yield RULE.fine(setting.origin)
        if acts is not False:
            continue
        above = setting.before
        yield RULE.at(
            setting.origin,
            f"the environment variable {setting.key} is set for no node",
            label="no node follows in this scope",
            related=tuple((place, "this stands above it and does not see it") for place in above[-_MOST_SHOWN:]),
            notes=("<env> acts on what stands below it in the same file or group, and does not leak out of it",),
            help="move it above the nodes it is for, or into them" if above else "move it to where its nodes are, or remove it",
        )

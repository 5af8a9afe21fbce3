"""A remap stands in a scope without nodes.

Outside a node, a `<remap>` acts on the nodes that come after it in the same group or file, and it ends with that
group or file: an included file cannot remap for the file that includes it.

In ROS 2 it is a `<set_remap>` (`SetRemap`) that acts on what comes after it, up to the end of its group, and out of a file into the one
that includes it. It is told where a launch of which everything is known starts nodes, and leaves none out, and no node gets the remap.

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
from launchlint.model import ScopedSetting
from launchlint.rules.judging.reach import settings_of
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView, of_ros2
from launchlint.rules.wording import words_at

RULE = Rule("LL603", "remap-out-of-effect", Severity.WARNING)
_STARTS_NOTHING = frozenset(("arg", "let", "log", "push_ros_namespace", "set_remap", "set_parameter", "set_env", "unset_env", "append_env"))
"""Actions of ROS 2 that start no node; all others may."""


def check(view: LaunchView) -> Iterator[Finding | Fine]:
    """Look at every remap outside a node that has no nodes around it."""
    for setting, acts in settings_of(view.launch, "remap"):
        if of_ros2(view):
            yield from _of_ros2(setting, view)
        elif acts:
            yield RULE.fine(setting.origin)
        elif acts is False and not setting.before:
            whole = setting.scope_end >= len(setting.origin.place.source.text.rstrip())
            yield RULE.at(
                setting.origin,
                f"the remap of {setting.key} acts on no node: its {'file' if whole else 'group'} starts none",
                label="acts on no node",
                help="a remap ends with its group or file: put it above the nodes it is meant for, or into their <node>",
            )


def _of_ros2(setting: ScopedSetting, view: LaunchView) -> Iterator[Finding | Fine]:
    """Whoever is left out by a condition, or may be there, may be who is meant (launch_ros.actions.SetRemap)."""
    launch = view.launch
    left_out = any(branch.taken is not True and branch.tag not in _STARTS_NOTHING for branch in launch.branches)
    unsure = not launch.complete or left_out or any(condition.assumed for condition in setting.conditions)
    if setting.reached or unsure or not setting.key or not launch.nodes:
        yield RULE.fine(setting.origin)
        return
    tag = words_at(setting.origin).tag("set_remap")
    yield RULE.at(
        setting.origin,
        f"{tag} of {setting.key} acts on no node",
        label="acts on no node",
        notes=("it acts on the nodes that come after it, up to the end of its group",),
        help="put it above the nodes it is meant for, in their group, or into the remaps of the node itself",
    )

"""One name is remapped twice for the same nodes.

Of two remaps with the same `from` in one node, or in one scope without a node between them, only the last acts. The
same name written in two ways, such as `scan` and `/scan`, is worse: roslaunch passes both, rospy takes the last one
and roscpp the one that its own order leaves last.

In ROS 2 the first remap of a name acts, not the last, and those of a `set_remap` around the node stand before its own.

## Why it matters

One of the two remaps does nothing, and nobody says so.

## Example

```xml
<launch>
  <node pkg="rviz" type="rviz" name="rviz">
    <remap from="scan" to="front/scan"/>
    <remap from="scan" to="rear/scan"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="rviz" type="rviz" name="rviz">
    <remap from="scan" to="rear/scan"/>
  </node>
</launch>
```

## Fix

`--fix` removes the first of two remaps that say the same, `--unsafe-fixes` also the first of two that do not. The nodes get the same as
before, which is proved before it is done; that the last one was meant is a guess.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import RemapReplaced
from launchlint.finding import Finding, Severity
from launchlint.model import ROS2, Remap
from launchlint.rules.edits import fix, remove_element, spot
from launchlint.rules.judging.resolved_remaps import has_known_name, resolve
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin, Place

RULE = Rule("LL604", "remap-duplicate", Severity.WARNING, fixable="safe")


def check(view: LaunchView) -> Iterator[Finding]:
    """Look into nodes, into scopes, and for two spellings of one name."""
    launch = view.launch
    if view.dialect.name == ROS2:
        yield from _of_ros2(view)
        return
    for problem in launch.noticed(RemapReplaced):
        if problem.always and not problem.assumed:
            first = problem.related[0][0]
            yield _finding(problem.key, problem.origin, first, problem.old, problem.new, view)
    yield from _in_one_scope(view)
    for node in (*launch.nodes, *launch.tests):
        if len(node.remaps) < 2 or not has_known_name(node) or any(condition.assumed for condition in node.conditions):
            continue
        seen: dict[str, Remap] = {}
        for remap in node.remaps:
            name = resolve(node, remap.source)
            earlier = seen.setdefault(name, remap)
            if earlier is not remap and resolve(node, earlier.target) != resolve(node, remap.target):
                yield _two_spellings(name, earlier, remap)


def _of_ros2(view: LaunchView) -> Iterator[Finding]:
    """The first rule that fits counts (rcl_remap_name): that of a set_remap stands before those of the node."""
    for node in view.launch.nodes:
        if len(node.remaps) < 2 or any(condition.assumed for condition in node.conditions):
            continue
        seen: dict[str, Remap] = {}
        for remap in node.remaps:
            first = seen.setdefault(remap.source, remap)
            if first is remap or not remap.source:
                continue
            same, apart = first.target == remap.target, first.origin.place.key != remap.origin.place.key
            yield RULE.at(
                remap.origin,
                f"{remap.source} is remapped to {remap.target} twice"
                if same
                else f"{remap.source} is remapped twice, to {first.target} and to {remap.target}: only the first remap acts",
                severity=Severity.INFO if same else None,
                label="once more" if same else "has no effect" if apart else "two remaps of one name",
                related=((first.origin.place, "the first one"),) if apart else (),
                help="remove one of the two",
                topic=remap.source,
                cause=f"{node.package}/{node.plugin or node.executable} {remap.source} {first.target} {remap.target}",
            )


def _in_one_scope(view: LaunchView) -> Iterator[Finding]:
    """A remap that is replaced before any node has followed."""
    launch = view.launch
    settings = {item.origin.place.key: item for item in launch.settings if item.kind == "remap"}
    for setting in settings.values():
        replaced = setting.replaced
        earlier = None if replaced is None else settings.get(replaced.key)
        if earlier is None or earlier.reached or not set(setting.conditions) <= set(earlier.conditions):
            continue
        if not any(condition.assumed for condition in earlier.conditions):
            yield _finding(setting.key, setting.origin, earlier.origin.place, earlier.value.target, setting.value.target, view)


def _finding(name: str, second: Origin, first: Place, old: str, new: str, view: LaunchView) -> Finding:
    # The later one stays: it is the one that acts, at its place among the others.
    removal = fix("remove the first", remove_element(spot(view, first)), safe=old == new)
    if old == new:
        return RULE.at(
            second,
            f"{name} is remapped to {new} twice",
            severity=Severity.INFO,
            label="once more",
            related=((first, "the first one"),),
            help="remove one of the two",
            fix=removal,
        )
    return RULE.at(
        second,
        f"{name} is remapped twice, to {old} and to {new}: only the last remap acts",
        label="this one acts",
        related=((first, "has no effect"),),
        help=f"remove one of the two; nothing can be remapped to two names, but a node such as topic_tools/relay can copy {new} to {old}",
        fix=removal,
    )


def _two_spellings(name: str, earlier: Remap, remap: Remap) -> Finding:
    return RULE.at(
        remap.origin,
        f"{earlier.source} and {remap.source} are both {name} here, and are remapped to {earlier.target} and to {remap.target}",
        label="the same name",
        related=((earlier.origin.place, "the first one"),),
        notes=("roslaunch passes both: rospy takes the last one, roscpp the one that its own order leaves last",),
        help="remove one of the two",
    )

"""A change disconnects a node: what it was connected to at the base revision, it is no longer.

This rule speaks only where `launchlint check --base REVISION` is given, as in a pull request. It compares the connection graph of each
launch file with that of the base revision and tells which nodes had partners on a topic, service or action and now have none, although the
node itself is still started.

## Why it matters

Who talks to whom is written nowhere: it follows from names, namespaces and remaps. Renaming a group, moving an include or mending a remap
in one place may cut a node off in another one. Nothing fails then, the node just waits.

## Example

At the base revision the planner reaches the wheels on `cmd_vel`. This file puts the planner into a namespace of its own:

```xml
<launch>
  <node pkg="topic_tools" type="relay" name="wheels" args="cmd_vel wheels/cmd"/>
  <group ns="planning">
    <node pkg="topic_tools" type="relay" name="planner" args="plan cmd_vel"/>
  </group>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="topic_tools" type="relay" name="wheels" args="cmd_vel wheels/cmd"/>
  <group ns="planning">
    <node pkg="topic_tools" type="relay" name="planner" args="plan /cmd_vel"/>
  </group>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Endpoint, Instance
from launchlint.graph.difference import Link
from launchlint.rules.rule import Rule
from launchlint.rules.view import BaseView
from launchlint.source import Origin

RULE = Rule("LL620", "lost-connection", Severity.WARNING)

_WORDS = {
    "publisher": ("publishes", "subscriber", "subscribed"),
    "subscriber": ("subscribes", "publisher", "published it"),
    "server": ("serves", "client", "called it"),
    "client": ("calls", "server", "served it"),
    "action server": ("serves", "client", "called it"),
    "action client": ("calls", "server", "served it"),
}


def check(view: BaseView) -> Iterator[Finding]:
    """Tell every node that has lost all partners of a name."""
    instances = {instance.name: instance for graph in reversed(view.graphs) for instance in graph.instances}
    running = {node.name for node in view.difference.after.nodes}
    for link in view.difference.lost:
        instance = instances.get(link.connection.node)
        if instance is not None:
            yield _lost(view, link, instance, running)


def _lost(view: BaseView, link: Link, instance: Instance, running: set[str]) -> Finding:
    now = next(
        (each for each in instance.endpoints if (each.role, each.declared) == (link.connection.role, link.connection.declared)), None
    )
    does, other, did = _WORDS[link.connection.role]
    partners = ", ".join(link.partners) + (f" and {link.total - len(link.partners)} more" if link.total > len(link.partners) else "")
    gone = [partner for partner in link.partners if partner not in running]
    notes = [
        f"at {view.base}, {partners} {did} on {link.name}" if link.kind != "topic" else f"at {view.base}, {partners} {did}: {link.name}"
    ]
    notes.extend(_whereabouts(view, gone))
    if view.difference.uncertain:
        notes.append("a node came in of which nothing is known: it may do what seems lost")
    if now is None:
        message = f"{instance.name} no longer {does} {link.name}: its {other} {partners} is left without it"
    elif now.name != link.name:
        message = f"{instance.name} has lost its {other} {partners}: it now {does} {now.name}, not {link.name}"
    else:
        message = f"{instance.name} has lost its {other} {partners} on {link.name}"
    return RULE.at(
        _place(instance, now),
        message,
        severity=Severity.INFO if view.difference.uncertain else None,
        label="disconnected by this change",
        notes=tuple(notes),
        help="give both ends one name again (launchlint graph diff shows all that changed), or suppress this where it is meant",
        topic=f"{link.connection.role} {link.name}",
    )


def _whereabouts(view: BaseView, gone: list[str]) -> Iterator[str]:
    """What has become of nodes that are no longer there."""
    programs = {node.name: node.program for node in view.difference.nodes_removed}
    for name in gone:
        last = name.rpartition("/")[2]
        moved = [
            node.name for node in view.difference.nodes_added if node.name.rpartition("/")[2] == last and node.program == programs.get(name)
        ]
        yield f"{name} is now {moved[0]}" if len(moved) == 1 else f"{name} is no longer started"


def _place(instance: Instance, now: Endpoint | None) -> Origin:
    if now is not None and now.applied and now.applied[-1].rule.remap is not None:
        return now.applied[-1].rule.remap.origin
    node = instance.node
    return Origin(node.attributes.get("name", node.origin.place), node.origin.step)

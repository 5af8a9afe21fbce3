"""A change disconnects a node: what it was connected to at the base revision, it is no longer.

This rule speaks only where `launchlint check --base REVISION` is given, as in a pull request. It compares the connection graph of each
launch file with that of the base revision and tells which nodes had partners on a topic, service or action and now have none, although the
node itself is still started. It tells of each break once: at the node whose name changed where there is one, else at the node that is
left alone. Where a node came in of which nothing is known, what seems lost may have moved there, and the finding is an info.

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

from collections.abc import Iterator, Mapping

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import OFFERS, ConnectionGraph, Endpoint, Instance
from launchlint.graph.difference import Link, is_default, moved
from launchlint.rules.connections.places import acting_origin, node_origin
from launchlint.rules.rule import Rule
from launchlint.rules.view import BaseView
from launchlint.source import Origin, Place

RULE = Rule("LL620", "lost-connection", Severity.WARNING)

_WORDS = {
    "publisher": ("publishes", "subscriber", "subscribed to"),
    "subscriber": ("subscribes to", "publisher", "published"),
    "server": ("serves", "client", "called"),
    "client": ("calls", "server", "served"),
    "action server": ("serves", "client", "called"),
    "action client": ("calls", "server", "served"),
}
"""What a node of a role does, what its partner is called, and what that did."""

Where = Mapping[str, tuple[Instance, ConnectionGraph]]


def check(view: BaseView) -> Iterator[Finding]:
    """Tell every break once."""
    where = {instance.name: (instance, graph) for graph in reversed(view.graphs) for instance in graph.instances}
    causes = {(link.node, *_channel(link)) for link in view.difference.lost if _moved_itself(link)}
    left: dict[tuple[str, ...], list[Link]] = {}
    for link in view.difference.lost:
        if not _moved_itself(link):
            left.setdefault((*_channel(link), link.role), []).append(link)
    for link in view.difference.lost:
        told_there = len(link.partners) == link.total and all((name, *_channel(link)) in causes for name in link.partners)
        if link.node in where and (_moved_itself(link) or not told_there):
            others = left.get((*_channel(link), _OPPOSITE[link.role]), ()) if _moved_itself(link) else ()
            waiting = [where[other.node][0] for other in others if other.node in where and link.node in other.partners]
            yield _lost(view, link, where, waiting)


_OPPOSITE = {"publisher": "subscriber", "server": "client", "action server": "action client"}
_OPPOSITE.update({uses: offers for offers, uses in _OPPOSITE.items()})


def _channel(link: Link) -> tuple[str, str]:
    return (link.kind, link.name)


def _moved_itself(link: Link) -> bool:
    """Whether the node itself says or hears something else now."""
    return link.after is None or link.after.name != link.name


def _lost(view: BaseView, link: Link, where: Where, waiting: list[Instance]) -> Finding:
    instance, graph = where[link.node]
    does, other, did = _WORDS[link.role]
    partners = ", ".join(link.partners) + (f" and {link.total - len(link.partners)} more" if link.total > len(link.partners) else "")
    default = " where no arg is given" if link.by_default else ""
    now = _endpoint(link, instance)
    if link.after is None:
        message = f"{link.node} no longer {does} {link.name}: its {other} {partners} is left without it{default}"
    elif link.after.name != link.name:
        message = f"{link.node} has lost its {other} {partners}{default}: it now {does} {link.after.name}, not {link.name}"
    else:
        message = f"{link.node} has lost its {other} {partners} on {link.name}{default}"
    related = [(node_origin(each).place, f"{each.name} waits here for {link.name}") for each in waiting]
    notes = [f"at {view.base}, {partners} {did} {link.name}", *_whereabouts(view, link)]
    if not _moved_itself(link):
        related.extend(_partners_now(view, link, where))
    if view.difference.uncertain:
        notes.append("a node came in of which not everything is known: it may do what seems lost")
    found = RULE.at(
        node_origin(instance) if now is None else acting_origin(now, instance),
        message,
        severity=Severity.INFO if view.difference.uncertain else None,
        label="disconnected by this change",
        related=tuple(related),
        notes=tuple(notes),
        help="give both ends one name again (launchlint graph diff shows all that changed), or suppress this where it is meant",
        topic=f"{link.role} {link.name}",
    )
    return found._replace(arguments=graph.launch.given)


def _endpoint(link: Link, instance: Instance) -> Endpoint | None:
    """What the node says or hears now, where it still does."""
    after = link.after
    if after is None:
        return None
    same = (each for each in instance.endpoints if (each.role, each.declared, each.name) == (after.role, after.declared, after.name))
    return next(same, None)


def _whereabouts(view: BaseView, link: Link) -> Iterator[str]:
    """What has become of partners that are no longer there, or not always."""
    running = {node.name: node for node in view.difference.after.nodes if node.name in link.partners}
    now = moved(view.difference)
    for name in link.partners:
        node = running.get(name)
        if node is None:
            yield f"{name} is now {now[name]}" if name in now else f"{name} is no longer started"
        elif not is_default(node, view.difference.after):
            yield f"{name} is started only with {' or '.join(node.only)}"


def _partners_now(view: BaseView, link: Link, where: Where) -> Iterator[tuple[Place, str]]:
    """Where partners that still run got another name."""
    for before, after in view.difference.connections_changed:
        at_other_end = before.kind == link.kind and before.name == link.name and before.offers != (link.role in OFFERS)
        if at_other_end and before.node in link.partners and after.name != link.name and after.node in where:
            instance = where[after.node][0]
            endpoint = next((each for each in instance.endpoints if (each.role, each.name) == (after.role, after.name)), None)
            origin: Origin = node_origin(instance) if endpoint is None else acting_origin(endpoint, instance)
            yield origin.place, f"{after.node} now {_WORDS[after.role][0]} {after.name}"

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

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import OFFERS, Endpoint, Instance
from launchlint.graph.difference import ConnectionChange, Link, is_default, moved
from launchlint.rules.judging.name_places import acting_origin, node_origin
from launchlint.rules.rule import Rule
from launchlint.rules.view import BaseView
from launchlint.source import Place

MOST_WAITING = 3
"""Nodes left alone that are shown with the one that left them."""

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


class _Scene:
    """What is looked up for each lost link."""

    def __init__(self, view: BaseView) -> None:
        changes = view.difference
        self.base = view.base
        self.after = changes.after
        self.uncertain = changes.uncertain
        self.where = {instance.name: (instance, graph) for graph in reversed(view.graphs) for instance in graph.instances}
        self.running = {node.name: node for node in changes.after.nodes}
        self.moved = moved(changes)
        self.changed: dict[tuple[str, str], list[ConnectionChange]] = {}
        for change in changes.connections_changed:
            if change.before.name != change.after.name:
                self.changed.setdefault((change.before.kind, change.before.name), []).append(change)


def check(view: BaseView) -> Iterator[Finding]:
    """Tell every break once."""
    scene = _Scene(view)
    causes = {(link.node, *_channel(link)) for link in view.difference.lost if _moved_itself(link)}
    left: dict[tuple[str, ...], list[Link]] = {}
    for link in view.difference.lost:
        if not _moved_itself(link):
            left.setdefault((*_channel(link), link.role), []).append(link)
    for link in view.difference.lost:
        if link.node not in scene.where:
            continue
        if _moved_itself(link):
            others = left.get((*_channel(link), _OPPOSITE[link.role]), ())[:MOST_WAITING]
            yield _lost(scene, link, [other.node for other in others if link.node in other.partners])
        elif len(link.partners) < link.total or any((name, *_channel(link)) not in causes for name in link.partners):
            yield _lost(scene, link, [])


_OPPOSITE = {"publisher": "subscriber", "server": "client", "action server": "action client"}
_OPPOSITE.update({uses: offers for offers, uses in _OPPOSITE.items()})


def _channel(link: Link) -> tuple[str, str]:
    return (link.kind, link.name)


def _moved_itself(link: Link) -> bool:
    """Whether the node itself says or hears something else now."""
    return link.after is None or link.after.name != link.name


def _lost(scene: _Scene, link: Link, waiting: list[str]) -> Finding:
    instance, graph = scene.where[link.node]
    does, other, did = _WORDS[link.role]
    partners = ", ".join(link.partners) + (f" and {link.total - len(link.partners)} more" if link.total > len(link.partners) else "")
    default = " where no arg is given" if link.by_default else ""
    several = link.total > 1
    others = f"{other}{'s' if several else ''} {partners}"
    now = _endpoint(link, instance)
    if link.after is None:
        message = f"{link.node} no longer {does} {link.name}: its {others} {'are' if several else 'is'} left without it{default}"
    elif link.after.name != link.name:
        message = f"{link.node} has lost its {others}{default}: it now {does} {link.after.name}, not {link.name}"
    else:
        message = f"{link.node} has lost its {others} on {link.name}{default}"
    still = _WORDS[_OPPOSITE[link.role]][0]
    related = [(node_origin(scene.where[each][0]).place, f"{each} still {still} {link.name}") for each in waiting if each in scene.where]
    notes = [f"at {scene.base}, {partners} {did} {link.name}", *_whereabouts(scene, link)]
    if not _moved_itself(link):
        related.extend(_partners_now(scene, link))
    if scene.uncertain:
        notes.append("a node came in of which not everything is known: it may do what seems lost")
    found = RULE.at(
        node_origin(instance) if now is None else acting_origin(now, instance),
        message,
        severity=Severity.INFO if scene.uncertain else None,
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


def _whereabouts(scene: _Scene, link: Link) -> Iterator[str]:
    """What has become of partners that are no longer there, or not always."""
    for name in link.partners:
        node = scene.running.get(name)
        if node is None:
            yield f"{name} is now {scene.moved[name]}" if name in scene.moved else f"{name} is no longer started"
        elif not is_default(node, scene.after):
            yield f"{name} is started only with {' or '.join(node.only)}"


def _partners_now(scene: _Scene, link: Link) -> Iterator[tuple[Place, str]]:
    """Where partners that still run got another name."""
    for before, after in scene.changed.get(_channel(link), ()):
        if before.offers != (link.role in OFFERS) and before.node in link.partners and after.node in scene.where:
            instance = scene.where[after.node][0]
            endpoint = next((each for each in instance.endpoints if (each.role, each.name) == (after.role, after.name)), None)
            origin = node_origin(instance) if endpoint is None else acting_origin(endpoint, instance)
            yield origin.place, f"{after.node} now {_WORDS[after.role][0]} {after.name}"

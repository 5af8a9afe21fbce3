"""What a picture of a topology shows: boxes in boxes, and arrows between them; collapsed until it can be read.

Topics with one publisher or one subscriber are arrows from node to node; others are a box of their own, so that p publishers and s
subscribers make p + s arrows. Namespaces are folded into one box each, the deepest first, until the arrows are few enough.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from launchlint.graph.containment import namespaces_of
from launchlint.graph.difference import Difference
from launchlint.graph.topology import Connection, Topology

BUNDLE = 3
"""From so many names on, an arrow says their number instead."""


class Box(NamedTuple):
    """A node, a namespace (open, or folded with ``members`` nodes in it) or a channel. ``mark`` is added, removed, changed or empty."""

    id: str
    parent: str
    kind: str
    label: str
    detail: str
    members: int = 0
    unknown: bool = False
    conditional: bool = False
    mark: str = ""


class Arrow(NamedTuple):
    """From box to box; ``kind`` is topic, service or action, ``labels`` the names of its channels."""

    source: str
    target: str
    kind: str
    labels: tuple[str, ...]
    conditional: bool = False
    mark: str = ""

    @property
    def label(self) -> str:
        """The names, or how many there are."""
        return ", ".join(self.labels) if len(self.labels) < BUNDLE else f"{len(self.labels)} {self.kind}s"


class Drawing(NamedTuple):
    """``left_out`` says in words what is not shown; empty where everything is."""

    boxes: tuple[Box, ...]
    arrows: tuple[Arrow, ...]
    left_out: str


def draw(topology: Topology, most_arrows: int | None = None, changes: Difference | None = None, *, dangling: bool = False) -> Drawing:
    """The drawing of a topology with at most ``most_arrows`` arrows and boxes; with ``changes`` what is new or gone is marked.

    ``dangling``: channels that nobody else uses are boxes, too.
    """
    marks = _Marks(changes)
    union = topology if changes is None else _union(changes.before, changes.after)
    deepest = max((len(namespaces_of(node)) for node in union.nodes), default=0)
    drawing = Drawing((), (), "")
    for depth in range(deepest, -1, -1):
        drawing = _at_depth(union, depth, deepest, marks, dangling)
        if most_arrows is None or max(len(drawing.arrows), len(drawing.boxes)) <= most_arrows:
            return drawing
    assert most_arrows is not None
    return _cut(drawing, most_arrows)


class _Marks:
    """Which nodes and connections changed."""

    def __init__(self, changes: Difference | None) -> None:
        self.nodes: dict[str, str] = {}
        self.connections: dict[tuple[str, str, str, str], str] = {}
        if changes is None:
            return
        self.nodes.update((node.name, "added") for node in changes.nodes_added)
        self.nodes.update((node.name, "removed") for node in changes.nodes_removed)
        self.nodes.update((change.after.name, "changed") for change in changes.nodes_changed)
        for mark, connections in (
            ("removed", (*changes.connections_removed, *(each.before for each in changes.connections_changed))),
            ("added", (*changes.connections_added, *(each.after for each in changes.connections_changed))),
        ):
            self.connections.update((_key(connection), mark) for connection in connections)

    def of(self, *connections: Connection) -> str:
        """The mark of an arrow between these."""
        found = {self.connections.get(_key(connection), "") for connection in connections} - {""}
        return "removed" if "removed" in found else "added" if found else ""


def _key(connection: Connection) -> tuple[str, str, str, str]:
    return (connection.node, connection.role, connection.kind, connection.name)


def _union(before: Topology, after: Topology) -> Topology:
    """What is in either, the newer one where it is in both."""
    nodes = {node.name: node for node in (*before.nodes, *after.nodes)}
    connections = {_key(connection): connection for connection in (*before.connections, *after.connections)}
    channels = {(channel.kind, channel.name): channel for channel in (*before.channels, *after.channels)}
    return after._replace(
        nodes=tuple(nodes[key] for key in sorted(nodes)),
        connections=tuple(connections[key] for key in sorted(connections)),
        channels=tuple(channels[key] for key in sorted(channels)),
    )


def _at_depth(topology: Topology, depth: int, deepest: int, marks: _Marks, dangling: bool) -> Drawing:
    boxes: dict[str, Box] = {}
    box_of: dict[str, str] = {}
    for node in topology.nodes:
        around = namespaces_of(node)
        parent = ""
        for namespace in around[:depth]:
            key = f"namespace {namespace}"
            boxes.setdefault(key, Box(key, parent, "namespace", namespace, ""))
            parent = key
        if len(around) > depth:
            key = f"folded {around[depth]}"
            known = boxes.get(key) or Box(key, parent, "folded", around[depth], "")
            mark = "changed" if marks.nodes.get(node.name) or known.mark else ""
            boxes[key] = known._replace(members=known.members + 1, mark=mark)
        else:
            key = f"node {node.name}"
            label = node.name.rpartition("/")[2]
            unknown, conditional = node.knowledge == "unknown", bool(node.only or node.conditions)
            boxes[key] = Box(key, parent, "node", label, node.program, 0, unknown, conditional, marks.nodes.get(node.name, ""))
        box_of[node.name] = key
    arrows = _arrows(topology, boxes, box_of, marks, dangling)
    folded = sum(box.members for box in boxes.values())
    left_out = f"{folded} nodes are folded into their namespaces" if depth < deepest else ""
    return Drawing(tuple(boxes[key] for key in sorted(boxes)), arrows, left_out)


def _arrows(topology: Topology, boxes: dict[str, Box], box_of: Mapping[str, str], marks: _Marks, dangling: bool) -> tuple[Arrow, ...]:
    sides: dict[tuple[str, str], tuple[list[Connection], list[Connection]]] = {}
    for connection in topology.connections:
        if connection.node in box_of:
            sides.setdefault((connection.kind, connection.name), ([], []))[not connection.offers].append(connection)
    found: dict[tuple[str, str, str, bool, str], list[str]] = {}

    def arrow(source: str, target: str, kind: str, label: str, *why: Connection) -> None:
        conditional = any(each.only or not each.certain for each in why)
        found.setdefault((source, target, kind, conditional, marks.of(*why)), []).append(label)

    for (kind, name), (offers, uses) in sorted(sides.items()):
        givers, takers = _by_box(offers, box_of), _by_box(uses, box_of)
        if not dangling and (not givers or not takers or (set(givers) == set(takers) and len(givers) == 1)):
            continue
        if len(givers) == 1 or len(takers) == 1:
            for giver, first in givers.items():
                for taker, second in takers.items():
                    if giver != taker:
                        ends = (giver, taker) if kind == "topic" else (taker, giver)
                        arrow(*ends, kind, name, first, second)
            if givers and takers:
                continue
        key = f"{kind} {name}"
        boxes[key] = Box(key, "", kind, name, "", conditional=not givers or not takers)
        for box, why in givers.items():
            arrow(*((box, key) if kind == "topic" else (key, box)), kind, "", why)
        for box, why in takers.items():
            arrow(*((key, box) if kind == "topic" else (box, key)), kind, "", why)
    return tuple(
        Arrow(source, target, kind, tuple(label for label in labels if label), conditional, mark)
        for (source, target, kind, conditional, mark), labels in sorted(found.items())
    )


def _by_box(connections: Iterable[Connection], box_of: Mapping[str, str]) -> dict[str, Connection]:
    """The boxes of these connections, each with one of them."""
    found: dict[str, Connection] = {}
    for connection in connections:
        found.setdefault(box_of[connection.node], connection)
    return found


def _cut(drawing: Drawing, most: int) -> Drawing:
    """The part of a drawing that fits: changed arrows first, then those between the busiest boxes."""
    busy: dict[str, int] = {}
    for arrow in drawing.arrows:
        for end in (arrow.source, arrow.target):
            busy[end] = busy.get(end, 0) + 1
    ranked = sorted(drawing.arrows, key=lambda arrow: (not arrow.mark, -busy[arrow.source] - busy[arrow.target], arrow))
    arrows: list[Arrow] = []
    kept: set[str] = set()
    for arrow in ranked:
        if len(arrows) < most and len(kept | {arrow.source, arrow.target}) <= most:
            arrows.append(arrow)
            kept |= {arrow.source, arrow.target}
    by_id = {box.id: box for box in drawing.boxes}
    for box in drawing.boxes:
        if len(kept) >= most:
            break
        if box.mark:
            kept.add(box.id)
    inside = set(kept)
    for key in kept:
        parent = by_id[key].parent
        while parent:
            inside.add(parent)
            parent = by_id[parent].parent
    boxes = tuple(box for box in drawing.boxes if box.id in inside)
    gone = f"{len(drawing.arrows) - len(arrows)} arrows and {len(drawing.boxes) - len(boxes)} boxes are left out"
    return Drawing(boxes, tuple(sorted(arrows)), f"{drawing.left_out}; {gone}" if drawing.left_out else gone)

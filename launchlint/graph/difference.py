"""What changed between two topologies of one launch file: nodes, channels, connections, and who has lost whom."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from launchlint.graph.topology import Connection, Topology, TopologyChannel, TopologyNode

MOST_PARTNERS = 5
"""Names of partners that are kept for a lost or gained link."""

Key = tuple[str, str, str]


class NodeChange(NamedTuple):
    """A node of one name that is another program, runs in another process, or is known otherwise."""

    before: TopologyNode
    after: TopologyNode


class ChannelChange(NamedTuple):
    """A channel whose types changed."""

    before: TopologyChannel
    after: TopologyChannel


class ConnectionChange(NamedTuple):
    """What one node says or hears under one name of its code, and that is now something else on the graph."""

    before: Connection
    after: Connection


class Link(NamedTuple):
    """A node that had partners on a channel and has none any more (lost), or the reverse (gained).

    ``connection`` is what the node says or hears now, or what it did where that is gone; ``kind`` and ``name`` are the channel on which
    the partners were, ``partners`` their names, at most :data:`MOST_PARTNERS`, ``total`` how many there were.
    """

    connection: Connection
    kind: str
    name: str
    partners: tuple[str, ...]
    total: int


class Difference(NamedTuple):
    """The changes from ``before`` to ``after``. ``uncertain``: a node that nobody knows came in, and may do what seems lost."""

    before: Topology
    after: Topology
    nodes_added: tuple[TopologyNode, ...]
    nodes_removed: tuple[TopologyNode, ...]
    nodes_changed: tuple[NodeChange, ...]
    channels_added: tuple[TopologyChannel, ...]
    channels_removed: tuple[TopologyChannel, ...]
    channels_changed: tuple[ChannelChange, ...]
    connections_added: tuple[Connection, ...]
    connections_removed: tuple[Connection, ...]
    connections_changed: tuple[ConnectionChange, ...]
    lost: tuple[Link, ...]
    gained: tuple[Link, ...]
    uncertain: bool

    @property
    def is_empty(self) -> bool:
        """Whether nothing changed."""
        return not any(self[2:-1])


def difference(before: Topology, after: Topology) -> Difference:
    """What changed. Places, evidence and conditions do not count; linear in the size of both."""
    old_nodes, new_nodes = ({node.name: node for node in each.nodes} for each in (before, after))
    old_channels, new_channels = ({(each.kind, each.name): each for each in graph.channels} for graph in (before, after))
    old, new = _by_name(before), _by_name(after)
    added, removed, changed = _connections(old, new)
    return Difference(
        before,
        after,
        tuple(new_nodes[name] for name in sorted(new_nodes) if name not in old_nodes),
        tuple(old_nodes[name] for name in sorted(old_nodes) if name not in new_nodes),
        tuple(
            NodeChange(old_nodes[name], new_nodes[name])
            for name in sorted(old_nodes)
            if name in new_nodes and _identity(old_nodes[name]) != _identity(new_nodes[name])
        ),
        tuple(new_channels[key] for key in sorted(new_channels) if key not in old_channels),
        tuple(old_channels[key] for key in sorted(old_channels) if key not in new_channels),
        tuple(
            ChannelChange(old_channels[key], new_channels[key])
            for key in sorted(old_channels)
            if key in new_channels and old_channels[key].types != new_channels[key].types
        ),
        added,
        removed,
        changed,
        _links(before, after, new),
        _links(after, before, old),
        _has_new_unknown(before, after),
    )


def _identity(node: TopologyNode) -> tuple[str, ...]:
    return (node.program, node.kind, node.host, node.knowledge)


def _by_name(topology: Topology) -> dict[Key, list[Connection]]:
    """Connections by node, role and the name in the node's code."""
    found: dict[Key, list[Connection]] = {}
    for connection in topology.connections:
        found.setdefault((connection.node, connection.role, connection.declared), []).append(connection)
    return found


def _connections(
    old: Mapping[Key, list[Connection]], new: Mapping[Key, list[Connection]]
) -> tuple[tuple[Connection, ...], tuple[Connection, ...], tuple[ConnectionChange, ...]]:
    added: list[Connection] = []
    removed: list[Connection] = []
    changed: list[ConnectionChange] = []
    for key in sorted({*old, *new}):
        before = {(each.name, each.type): each for each in old.get(key, ())}
        after = {(each.name, each.type): each for each in new.get(key, ())}
        gone = [before[each] for each in sorted(before) if each not in after]
        come = [after[each] for each in sorted(after) if each not in before]
        pairs = min(len(gone), len(come))
        changed.extend(ConnectionChange(*pair) for pair in zip(gone[:pairs], come[:pairs], strict=True))
        removed.extend(gone[pairs:])
        added.extend(come[pairs:])
    return tuple(added), tuple(removed), tuple(changed)


def _links(before: Topology, after: Topology, new: Mapping[Key, list[Connection]]) -> tuple[Link, ...]:
    """Who had partners before, still runs after, and has none any more."""
    sides = _sides(before)
    now = _sides(after)
    hidden = {(each.kind, each.name) for each in before.channels if each.hub or each.plumbing}
    running = {node.name for node in after.nodes}
    lost = []
    for key, connections in _by_name(before).items():
        for connection in connections:
            channel = (connection.kind, connection.name)
            if not connection.certain or connection.action or channel in hidden or connection.node not in running:
                continue
            others = sorted(sides.get((*channel, not connection.offers), set()) - {connection.node})
            if not others:
                continue
            still = new.get(key, ())
            if any(now.get((each.kind, each.name, not each.offers), set()) - {each.node} for each in still):
                continue
            lost.append(Link(still[0] if still else connection, *channel, tuple(others[:MOST_PARTNERS]), len(others)))
    return tuple(sorted(lost))


def _sides(topology: Topology) -> dict[tuple[str, str, bool], set[str]]:
    """Channel and side (offers or uses) → the nodes there."""
    found: dict[tuple[str, str, bool], set[str]] = {}
    for connection in topology.connections:
        found.setdefault((connection.kind, connection.name, connection.offers), set()).add(connection.node)
    return found


def _has_new_unknown(before: Topology, after: Topology) -> bool:
    known = {(node.name, node.program) for node in _unknown(before.nodes)}
    return (before.complete and not after.complete) or any((node.name, node.program) not in known for node in _unknown(after.nodes))


def _unknown(nodes: Iterable[TopologyNode]) -> Iterable[TopologyNode]:
    return (node for node in nodes if node.knowledge == "unknown" or node.open)

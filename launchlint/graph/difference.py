"""What changed between two topologies of one launch file: nodes, channels, connections, and who has lost whom."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from launchlint.graph.connections import HUBS
from launchlint.graph.partners import Partners
from launchlint.graph.topology import Connection, Topology, TopologyChannel, TopologyNode
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.verdict import Verdict

MOST_PARTNERS = 5
"""Names of partners that are kept for a lost or gained link."""

Key = tuple[str, str, str]


class NodeChange(NamedTuple):
    """A node of one name that is another program, runs in another process, is known otherwise, or is (not) started by default any more."""

    before: TopologyNode
    after: TopologyNode


class ChannelChange(NamedTuple):
    """A channel that has other types now; those before and after are known."""

    before: TopologyChannel
    after: TopologyChannel


class ConnectionChange(NamedTuple):
    """What one node says or hears under one name of its code, and that has another name, type or condition now."""

    before: Connection
    after: Connection


class Link(NamedTuple):
    """A node that had partners on a channel and has none any more (lost), or the reverse (gained).

    Args:
        node: its name; it runs before and after.
        role: publisher, subscriber, server, client, action server or action client.
        kind: of the channel on which the partners are (gained) or were (lost).
        name: of that channel.
        partners: their names, at most :data:`MOST_PARTNERS`.
        total: how many there are.
        before: what the node said or heard under this name of its code; None: nothing.
        after: the same, now.
        by_default: it holds for the default configuration only; in some other one nothing changed.
    """

    node: str
    role: str
    kind: str
    name: str
    partners: tuple[str, ...]
    total: int
    before: Connection | None
    after: Connection | None
    by_default: bool = False


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
        return not any(self[2:-1]) and not self.loads_otherwise

    @property
    def loads_otherwise(self) -> bool:
        """Whether roslaunch loads the launch file now and did not, or the reverse, as it stands or with other args."""
        before, after = self.before.verdict, self.after.verdict
        return before is not None and after is not None and _standing(before) != _standing(after)


def _standing(verdict: Verdict) -> tuple[str, bool]:
    return verdict.word, bool(verdict.elsewhere)


def difference(before: Topology, after: Topology) -> Difference:
    """What changed. Places and evidence do not count, nor do params; linear in the size of both."""
    old_channels, new_channels = ({(each.kind, each.name): each for each in graph.channels} for graph in (before, after))
    nodes_added, nodes_removed, node_pairs = _compared(
        _grouped(before.nodes, lambda node: node.name), _grouped(after.nodes, lambda node: node.name), _node_identity(before),
        _node_identity(after),
    )  # fmt: skip
    old, new = _by_name(before), _by_name(after)
    added, removed, pairs = _compared(old, new, _connection_identity(before), _connection_identity(after))
    return Difference(
        before,
        after,
        nodes_added,
        nodes_removed,
        tuple(NodeChange(*pair) for pair in node_pairs),
        tuple(new_channels[key] for key in sorted(new_channels) if key not in old_channels),
        tuple(old_channels[key] for key in sorted(old_channels) if key not in new_channels),
        tuple(
            ChannelChange(old_channels[key], new_channels[key])
            for key in sorted(old_channels)
            if key in new_channels and old_channels[key].types and new_channels[key].types not in ((), old_channels[key].types)
        ),
        added,
        removed,
        tuple(ConnectionChange(*pair) for pair in pairs),
        _links(before, after),
        tuple(link._replace(before=link.after, after=link.before) for link in _links(after, before)),
        _has_new_unknown(before, after),
    )


def moved(changes: Difference) -> Mapping[str, str]:
    """Nodes that have gone, and the new node that each seems to be now: the same program under the same last name, and no other."""
    removed = _grouped(changes.nodes_removed, lambda node: (node.name.rpartition("/")[2], node.program))
    added = _grouped(changes.nodes_added, lambda node: (node.name.rpartition("/")[2], node.program))
    pairs = ((old, added.get(key, [])) for key, old in removed.items())
    return {old[0].name: new[0].name for old, new in pairs if (len(old), len(new)) == (1, 1)}


def is_default(item: TopologyNode | Connection, topology: Topology) -> bool:
    """Whether something is there where the launch file is started without further args."""
    return not item.only or topology.configurations[0] in item.only


def _node_identity(topology: Topology) -> Callable[[TopologyNode], Any]:
    return lambda node: (node.program, node.kind, node.host, node.knowledge, is_default(node, topology))


def _connection_identity(topology: Topology) -> Callable[[Connection], Any]:
    """Name and type, and whether it is there by default whenever its node is: what holds for all of the node is told of the node."""
    running = {node.name for node in topology.nodes if is_default(node, topology)}
    return lambda each: (each.name, each.type, is_default(each, topology) or each.node not in running)


def _by_name(topology: Topology) -> Mapping[Key, list[Connection]]:
    """Connections by node, role and the name in the node's code."""
    return _grouped(topology.connections, lambda each: (each.node, each.role, each.declared))


def _grouped(items: Iterable[Any], key: Callable[[Any], Any]) -> Mapping[Any, list[Any]]:
    found: dict[Any, list[Any]] = {}
    for item in items:
        found.setdefault(key(item), []).append(item)
    return found


def _compared(
    old: Mapping[Any, Sequence[Any]],
    new: Mapping[Any, Sequence[Any]],
    old_identity: Callable[[Any], Any],
    new_identity: Callable[[Any], Any],
) -> tuple[tuple[Any, ...], tuple[Any, ...], tuple[tuple[Any, Any], ...]]:
    """What is new, what is gone, and pairs of what changed: what has one key and is not the same."""
    added: list[Any] = []
    removed: list[Any] = []
    changed: list[tuple[Any, Any]] = []
    for key in sorted({*old, *new}):
        before = {old_identity(each): each for each in old.get(key, ())}
        after = {new_identity(each): each for each in new.get(key, ())}
        gone = [before[each] for each in sorted(before) if each not in after]
        come = [after[each] for each in sorted(after) if each not in before]
        pairs = min(len(gone), len(come))
        changed.extend(zip(gone, come, strict=False))
        removed.extend(gone[pairs:])
        added.extend(come[pairs:])
    return tuple(added), tuple(removed), tuple(changed)


def _links(before: Topology, after: Topology) -> tuple[Link, ...]:
    """Who had partners before, still runs after, and has none any more: in all configurations together, then in the default one."""
    found = {_what(link): link for link in _lost(before, after)}
    if len(after.configurations) > 1:  # with one, who has no partner by default has none at all
        for link in _lost(_default(before), _default(after)):
            found.setdefault(_what(link), link._replace(by_default=True))
    return tuple(found[key] for key in sorted(found))


def _what(link: Link) -> tuple[str, ...]:
    return (link.node, link.role, link.kind, link.name)


def _default(topology: Topology) -> Topology:
    """What is there by default, as if it always were."""
    return topology._replace(
        nodes=tuple(node._replace(only=()) for node in topology.nodes if is_default(node, topology)),
        connections=tuple(each._replace(only=()) for each in topology.connections if is_default(each, topology)),
    )


def _lost(before: Topology, after: Topology) -> Iterator[Link]:
    then = Partners(before._replace(connections=tuple(each for each in before.connections if each.certain)))
    now = Partners(after)
    new = _by_name(after)
    same_name = _grouped(after.connections, lambda each: (each.node, each.role, each.name))
    plumbing = {(each.kind, each.name) for each in before.channels if each.plumbing}
    running = {node.name for node in after.nodes}
    for each in before.connections:
        if not each.certain or each.action or each.name in HUBS or (each.kind, each.name) in plumbing or each.node not in running:
            continue
        partners = then.of(each, MOST_PARTNERS)
        if not partners:
            continue
        still: Sequence[Connection] = new.get((each.node, each.role, each.declared), ())
        here: Sequence[Connection] = same_name.get((each.node, each.role, each.name), ())
        if not any(now.count(connection) for connection in (*still, *here)):
            after_all = still[0] if still else here[0] if here else None
            yield Link(each.node, each.role, each.kind, each.name, tuple(partners), then.count(each), each, after_all)


def _has_new_unknown(before: Topology, after: Topology) -> bool:
    known = {(node.name, node.program) for node in _unknown(before.nodes)}
    return (before.complete and not after.complete) or any((node.name, node.program) not in known for node in _unknown(after.nodes))


def _unknown(nodes: Iterable[TopologyNode]) -> Iterable[TopologyNode]:
    return (node for node in nodes if node.knowledge == "unknown" or any(category != "params" for category, _ in node.open))

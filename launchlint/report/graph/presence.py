"""When the connections of a picture are there: in which configurations, before and after a change; as bits, so that many join at once."""

from __future__ import annotations

from launchlint.graph.difference import Difference
from launchlint.graph.topology import Connection, Topology
from launchlint.named_tuple import NamedTuple

Channel = tuple[str, str]


class Part(NamedTuple):
    """What is drawn: nodes by name are those of ``topology``; ``connections`` with the bits that say when each is there.

    ``marks`` are added, removed and changed nodes; ``alone`` the channels that are drawn although one of their ends is empty; ``unchanged``
    the number of nodes that are left out because nothing about them changed.
    """

    topology: Topology
    connections: tuple[tuple[int, Connection], ...]
    marks: dict[str, str]
    alone: frozenset[Channel]
    unchanged: int


class Presence:
    """The bits: one for each configuration, of one topology or of two."""

    def __init__(self, *sides: Topology) -> None:
        self._bits: list[dict[str, int]] = []
        self._all: list[int] = []
        bit = 1
        for side in sides:
            bits: dict[str, int] = {}
            for configuration in side.configurations:
                bits[configuration] = bit
                bit <<= 1
            self._bits.append(bits)
            self._all.append(sum(bits.values()))

    def of(self, each: Connection, side: int) -> int:
        """When a connection of the first (0) or second (1) topology is there."""
        return sum(self._bits[side].get(configuration, 0) for configuration in each.only) if each.only else self._all[side]

    def is_always(self, when: int) -> bool:
        """Whether that is in every configuration of the sides it is in."""
        return all(not when & every or when & every == every for every in self._all)

    def mark(self, when: int) -> str:
        """Whether that is gone (``removed``) or new (``added``); empty where neither, or where there are not two sides."""
        if all(when & every for every in self._all):
            return ""
        return "removed" if when & self._all[0] else "added"


def whole(topology: Topology, presence: Presence, *, dangling: bool) -> Part:
    """All of a topology."""
    alone = frozenset((each.kind, each.name) for each in topology.connections) if dangling else frozenset()
    return Part(topology, tuple((presence.of(each, 0), each) for each in topology.connections), {}, alone, 0)


def changed(changes: Difference, presence: Presence, *, dangling: bool) -> Part:
    """Of two topologies the nodes and connections that changed, and who is at the other ends of the latter."""
    before, after = changes.before, changes.after
    pairs = [side for pair in changes.connections_changed for side in pair]
    moved = {_identity(each) for each in (*changes.connections_added, *changes.connections_removed, *pairs)}
    marks = _marks(changes)
    touched = {(kind, name, not offers) for _, _, kind, name, offers in moved}
    connections = {
        (side, _identity(each)): (presence.of(each, side), each)
        for side, graph in enumerate((before, after))
        for each in graph.connections
        if _identity(each) in moved or each.node in marks or (each.kind, each.name, each.offers) in touched
    }
    names = marks.keys() | {each.node for _, each in connections.values()}
    everybody = {node.name: node for node in (*before.nodes, *after.nodes)}
    alone = {(each.kind, each.name) for each in pairs if dangling or (each.certain and not each.action)}
    if dangling:
        alone.update((kind, name) for _, _, kind, name, _ in moved)
    return Part(
        after._replace(nodes=tuple(everybody[name] for name in sorted(names))),
        tuple(connections[key] for key in sorted(connections)),
        marks,
        frozenset(alone),
        len(everybody) - len(names),
    )


def _identity(each: Connection) -> tuple[str, str, str, str, bool]:
    return (each.node, each.role, each.kind, each.name, each.offers)


def _marks(changes: Difference) -> dict[str, str]:
    marks = {pair.after.name: "changed" for pair in changes.nodes_changed}
    old, new = ({node.name for node in side.nodes} for side in (changes.before, changes.after))
    marks.update((node.name, "changed" if node.name in old else "added") for node in changes.nodes_added)
    marks.update((node.name, "changed" if node.name in new else "removed") for node in changes.nodes_removed)
    return marks

"""Who is at the other end of a connection, without ever pairing all publishers of a topic with all its subscribers."""

from __future__ import annotations

from bisect import bisect_left

from launchlint.graph.topology import Connection, Topology

Side = tuple[str, str, bool]
"""Kind and name of a channel, and whether it is the side that offers."""


class Partners:
    """The partners of each connection of a topology: other nodes on the other side of its channel, in a configuration that has both."""

    def __init__(self, topology: Topology) -> None:
        self._groups: dict[Side, dict[tuple[str, ...], dict[str, None]]] = {}
        self._names: dict[tuple[Side, tuple[str, ...]], list[str]] = {}
        for each in topology.connections:
            side = (each.kind, each.name, each.offers)
            self._groups.setdefault(side, {}).setdefault(each.only, {})[each.node] = None

    def of(self, connection: Connection, most: int | None = None) -> list[str]:
        """Their full names, sorted; the first ``most`` of them."""
        names = self._other_side(connection)
        first = names if most is None else names[: most + 1]
        return [name for name in first if name != connection.node][:most]

    def count(self, connection: Connection) -> int:
        """How many there are."""
        names = self._other_side(connection)
        at = bisect_left(names, connection.node)
        return len(names) - (at < len(names) and names[at] == connection.node)

    def is_its_own(self, connection: Connection) -> bool:
        """Whether the node is on the other side, too: it hears itself."""
        names = self._other_side(connection)
        return self.count(connection) < len(names)

    def _other_side(self, connection: Connection) -> list[str]:
        key = ((connection.kind, connection.name, not connection.offers), connection.only)
        found = self._names.get(key)
        if found is None:
            names: dict[str, None] = {}
            for only, nodes in self._groups.get(key[0], {}).items():
                if meet(only, connection.only):
                    names.update(nodes)
            found = self._names[key] = sorted(names)
        return found


def meet(first: tuple[str, ...], second: tuple[str, ...]) -> bool:
    """Whether two values of ``only`` have a configuration in common; an empty one stands for all."""
    return not first or not second or not set(first).isdisjoint(second)

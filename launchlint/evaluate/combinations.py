"""Args of an entry file that act on the same things: what any combination of them starts is only known once it was evaluated.

``configurations`` takes every branch once, so that one arg is changed at a time where that is enough. Two args of which no thing depends on
both do not need more: what each of them does is what it does beside the other, too. Where things stand under conditions that depend on
several, all combinations of their values are.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice, product
from math import prod

from launchlint.model import Condition, Launch
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Pairs: TypeAlias = tuple[tuple[str, str], ...]

MOST_OF_GROUP = 64
"""Combinations of the values of one group of args."""
MOST_NODES = 4_000
"""Nodes of all further evaluations of one entry file together."""


class Missing(NamedTuple):
    """Combinations that were not evaluated, and whether there are no more of them."""

    combinations: Sequence[Pairs]
    whole: bool


class Interplay:
    """Collects from the evaluations of one entry file which args act on the same nodes. ``pinned`` are the args that it is given anyway."""

    def __init__(self, pinned: Pairs) -> None:
        self._pinned = len(pinned)
        self._values: dict[str, dict[str, None]] = {}
        self._seen: set[frozenset[tuple[str, str]]] = set()
        self._together: dict[frozenset[str], None] = {}
        self._nodes = 0

    def saw(self, launch: Launch) -> None:
        """Take note of one evaluation."""
        given = launch.given[self._pinned :]
        self._seen.add(frozenset(given))
        self._nodes = max(self._nodes, len(launch.nodes))
        for name, value in given:
            self._values.setdefault(name, {})[value] = None
        steered = {(each.element.source.path, each.element.span.start): each.steered_by for each in launch.branches if each.steered_by}
        steered.update(
            ((each.origin.place.source.path, each.origin.place.span.start), each.steered_by) for each in launch.branches if each.steered_by
        )
        for conditions in dict.fromkeys(node.conditions for node in (*launch.nodes, *launch.tests)):
            self._together[frozenset().union(*_steering(conditions, steered))] = None

    def missing(self) -> Missing:
        """The combinations of args of one group that were not evaluated; all others as they are by default."""
        whole = True
        found: dict[Pairs, None] = {}
        room = MOST_NODES // max(self._nodes, 1)
        for group in self._groups():
            values = [(None, *self._values[name]) for name in group]
            whole = whole and prod(map(len, values)) <= MOST_OF_GROUP
            for chosen in islice(product(*values), MOST_OF_GROUP):
                pairs = tuple((name, value) for name, value in zip(group, chosen, strict=True) if value is not None)
                if frozenset(pairs) not in self._seen:
                    found[pairs] = None
        return Missing(list(found)[:room], whole and len(found) <= room)

    def _groups(self) -> Iterator[list[str]]:
        groups: list[set[str]] = []
        for names in self._together:
            joined = {name for name in names if name in self._values}
            for group in [each for each in groups if each & joined]:
                groups.remove(group)
                joined |= group
            if joined:
                groups.append(joined)
        return (sorted(group) for group in groups if len(group) > 1)


def _steering(conditions: Sequence[Condition], steered: dict[tuple[str, int], frozenset[str]]) -> Iterator[frozenset[str]]:
    for each in conditions:
        yield steered.get((each.place.source.path, each.place.span.start), frozenset())

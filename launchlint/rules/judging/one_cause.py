"""Loose ends that have one cause: a node in the wrong namespace, or one without its remaps, loses all its partners at once."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.loose_ends import LooseEnds, Missed
from launchlint.rules.judging.misplaced import parting_include
from launchlint.rules.judging.near_names import NAMESPACE, SIBLING
from launchlint.rules.view import GraphView

Apart = tuple[tuple[str, ...], tuple[str, ...]]
Hub = tuple[str, Apart]
"""A node, or the place of an include that leads to several (``path:line``), and how the namespaces of its names differ from those of the
names that they were meant for.
"""


class Cause(NamedTuple):
    """What has one cause: the ``first`` loose end, the surest of those of the rule that tells it, and the ``others``; ``hub`` if any."""

    first: Missed
    others: tuple[Missed, ...]
    hub: Hub | None


def causes(view: GraphView) -> Mapping[str, Sequence[Cause]]:
    """The loose ends of the launch, joined by their cause: those that the rule for each of :data:`_ORDER` tells.

    What it has in common with loose ends of other kinds is told once: by the rule for subscribers if it has any, else by the one for
    publishers.
    """
    found = list(_missed(view))
    counts = Counter(hub for missed in found for hub in _hubs(missed))
    groups: dict[object, list[Missed]] = {}
    for missed in found:
        likely = max(_hubs(missed), key=lambda each: (counts[each], is_node(each[0]), each), default=None)
        key: object = likely if likely is not None and counts[likely] > 1 else id(missed)
        groups.setdefault(key, []).append(missed)
    told: dict[str, list[Cause]] = {teller: [] for teller in _ORDER}
    for key, group in groups.items():
        teller = min((_teller(missed) for missed in group), key=_ORDER.index)
        own = [missed for missed in group if _teller(missed) == teller]
        hub = key if isinstance(key, tuple) else None
        first = max(own, key=lambda missed: (missed.level, hub is not None and missed.instance.name == hub[0]))
        level = max(missed.level for missed in group)
        others = tuple(missed for missed in group if missed is not first)
        told[teller].append(Cause(first._replace(level=level), others, hub))
    return told


_ORDER = ("subscriber", "publisher", "client")


def _teller(missed: Missed) -> str:
    role = missed.end.role
    return role if role in _ORDER else "client"


def _missed(view: GraphView) -> Iterator[Missed]:
    """All loose ends that were meant for something; one of two ends that were meant for each other."""
    ends = LooseEnds(view)
    told: set[tuple[str, str]] = set()
    for missed in ends.missed("topic", offers=False):
        told.add((missed.other.name, missed.end.name))
        yield missed
    for missed in ends.missed("topic", offers=True):
        if not missed.loose or (missed.end.name, missed.other.name) not in told:
            yield missed
    for kind in ("service", "action"):
        yield from ends.missed(kind, offers=False)


def _hubs(missed: Missed) -> tuple[Hub, ...]:
    """Both nodes, where nothing but the namespace tells the two names apart, and the include of each that does not lead to the other."""
    if missed.how not in (NAMESPACE, SIBLING):
        return ()
    mine, theirs = missed.end.name.split("/")[1:-1], missed.other.name.split("/")[1:-1]
    while mine and theirs and mine[0] == theirs[0]:
        mine, theirs = mine[1:], theirs[1:]
    while mine and theirs and mine[-1] == theirs[-1]:
        mine, theirs = mine[:-1], theirs[:-1]
    one, other = tuple(mine), tuple(theirs)
    end, instance, partner = missed.end, missed.instance, missed.partner
    mine_in, theirs_in = parting_include(end, instance, partner), parting_include(missed.other, partner, instance)
    found = ((instance.name, (one, other)), (partner.name, (other, one)), (mine_in, (one, other)), (theirs_in, (other, one)))
    return tuple(each for each in found if each[0])


def is_node(hub: str) -> bool:
    """Whether it is a node that the ends have in common, and not an include."""
    return hub.startswith("/")

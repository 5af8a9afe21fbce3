"""A launch file that was divided: the files that were made of it have the same mistakes, each a part of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.finding import Finding, Location


def with_parts(
    groups: Sequence[list[Finding]], name_of: Callable[[Finding], str], kind: Callable[[Finding], tuple[object, ...]]
) -> list[list[Finding]]:
    """``groups`` of told findings that belong together, whose first one speaks; with one about several things those about one of them each.

    These are of the same ``kind``, in lines that say the same, and together about all that the first one is about.
    """
    singles: dict[tuple[object, str], list[list[Finding]]] = {}
    for group in groups:
        if len(group) == 1 and not group[0].about and not group[0].related:
            singles.setdefault((kind(group[0]), _line(group[0].location)), []).append(group)
    parts_of = {id(group): _parts(group[0], singles, name_of, kind) for group in groups} if singles else {}
    taken = {id(part) for parts in parts_of.values() for part in parts}
    return [[*group, *(part[0] for part in parts_of.get(id(group), ()))] for group in groups if id(group) not in taken]


def _parts(
    whole: Finding,
    singles: dict[tuple[object, str], list[list[Finding]]],
    name_of: Callable[[Finding], str],
    kind: Callable[[Finding], tuple[object, ...]],
) -> list[list[Finding]]:
    """Those of ``singles`` that together are about all of ``whole``, taken out; none where something of it is missing."""
    if len(whole.about) < 2:
        return []
    lines = dict.fromkeys(_line(place) for place in (whole.location, *(each.location for each in whole.related)))
    keys = [(kind(whole), line) for line in lines]
    parts = [part for key in keys for part in singles.get(key, ())]
    if {name_of(part[0]) for part in parts} != set(whole.about):
        return []
    for key in keys:
        singles.pop(key, None)
    return parts


def _line(place: Location) -> str:
    """What a line says, without what is between its words."""
    return "".join(place.text.split())

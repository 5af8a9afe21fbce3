"""A file that is included in the wrong namespace: there is nothing to mend in it, and whoever else includes it may do so rightly."""

from __future__ import annotations

from launchlint.finding import Location
from launchlint.graph.connections import Endpoint, Instance
from launchlint.graph.names import clean, kind
from launchlint.rules.judging.loose_ends import Missed
from launchlint.rules.judging.name_places import in_namespace
from launchlint.rules.judging.near_names import NAMESPACE
from launchlint.source import Place


def moved_include(missed: Missed, node: str = "") -> str | None:
    """The include to put into a group so that the two ends meet, for people; None where that is not what parts them.

    ``node`` is the one to be moved, if it is only one of the two.
    """
    if missed.how != NAMESPACE:
        return None
    ends = (missed.end, missed.instance, missed.other, missed.partner), (missed.other, missed.partner, missed.end, missed.instance)
    for end, instance, other, partner in ends:
        place = _parting(instance, partner) if node in ("", instance.name) and _follows(end) else None
        space = None if place is None else _lacking(place, end, instance, other, partner)
        if place is not None and space is not None:
            at = Location.of(place)
            return f"put the include at {at.path}:{at.line} into {in_namespace(instance, space)}, where {partner.name} is"
    return None


def parting_include(end: Endpoint, instance: Instance, partner: Instance) -> str:
    """Where the outermost include stands that leads to ``instance`` only, if ``end`` follows it into a namespace; else empty."""
    place = _parting(instance, partner) if _follows(end) else None
    if place is None:
        return ""
    at = Location.of(place)
    return f"{at.path}:{at.line}"


def _parting(instance: Instance, partner: Instance) -> Place | None:
    """The outermost include that leads to ``instance`` only."""
    theirs = partner.node.origin.chain
    for index, place in enumerate(instance.node.origin.chain):
        if index >= len(theirs) or theirs[index] != place:
            return place
    return None


def _follows(end: Endpoint) -> bool:
    """Whether the name is another one in another namespace."""
    said = end.applied[-1].rule.target if end.applied else end.declared
    return kind(said) != "global"


def _lacking(place: Place, end: Endpoint, instance: Instance, other: Endpoint, partner: Instance) -> str | None:
    """The namespace that, put around the include at ``place``, makes the name of ``end`` that of ``other``, and is that of ``partner``."""
    scope = instance.node.scope
    while scope is not None and (scope.kind != "include" or scope.origin.place != place):
        scope = scope.parent
    if scope is None:
        return None
    outer = "" if scope.parent is None else scope.parent.namespace.rstrip("/")
    rest = end.name.removeprefix(outer)
    if not end.name.startswith(f"{outer}/") or not other.name.startswith(f"{outer}/") or not other.name.endswith(rest):
        return None
    space = other.name[len(outer) : -len(rest)].strip("/")
    inner = instance.node.namespace[len(outer) :]
    return space if space and clean(f"{outer}/{space}/{inner}/") == clean(partner.node.namespace) else None

"""Who may be at the empty end of a topic, service or action, although nobody is known to be there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from launchlint.graph.connections import Channel, ConnectionGraph, Endpoint
from launchlint.named_tuple import NamedTuple

End = tuple[str, str, bool]
"""Kind and name of a channel, and whether the end that offers (publishes, serves) is meant."""


class MayBe(NamedTuple):
    """Somebody of whom not all is known.

    ``node`` is a full name, empty for what is no node, ``unknown`` says whether nothing at all is known of it, ``reason`` why, for people.
    """

    node: str
    unknown: bool
    reason: str


NO_DOUBTS: Mapping[End, tuple[MayBe, ...]] = {}
"""Where nobody asked."""
Partly = Mapping[tuple[str, str], tuple[tuple[str, str], ...]]
"""Full name and place (``path:line:column``) of a node → its names that are known only in part: category, and what is known, with ``*``."""
NOTHING_PARTLY: Partly = {}
"""Where nobody asked."""


def doubts(graphs: Iterable[ConnectionGraph]) -> Mapping[End, tuple[MayBe, ...]]:
    """Each empty end where somebody may be, in any of the configurations; machinery of nodes is left out.

    An end that is not among them is one that nobody in the launch files can be at, as far as can be known.
    """
    found: dict[End, dict[MayBe, None]] = {}
    for graph in graphs:
        unknown = {instance.name for instance in graph.instances if instance.is_unknown}
        for channel in graph.channels.values():
            if bool(channel.offers) == bool(channel.uses) or channel.is_plumbing:
                continue
            ends = channel.offers or channel.uses
            if all(each.action for each in ends):
                continue  # a part of an action, which is asked itself
            for node, reason in _who(graph, channel, ends):
                end = (channel.kind, channel.name, not channel.offers)
                found.setdefault(end, {})[MayBe(node, node in unknown, reason)] = None
    return {end: tuple(who) for end, who in found.items()}


def _who(graph: ConnectionGraph, channel: Channel, ends: list[Endpoint]) -> Iterable[tuple[str, str]]:
    type_ = next((each.type for each in ends if each.type not in ("", "*")), "")
    may = graph.may_use if channel.offers else graph.may_offer
    others = {each.node for each in ends}
    for possible in may(channel.kind, channel.name, type_):
        if others != {possible.node}:  # what a node waits for comes from somebody else
            yield possible.node, possible.reason

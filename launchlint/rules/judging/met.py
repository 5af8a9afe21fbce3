"""Names that meet somebody in one entry file: a part of it that is started alone lacks only what the whole has."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.graph.connections import OFFERS, Endpoint
from launchlint.rules.judging.name_places import acting_origin, owners
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView


def topic_of(end: Endpoint) -> str:
    """What tells a loose end apart from others of its place."""
    return f"{end.node} {end.role} {end.name}"


def met(rule: Rule, view: GraphView, *roles: str) -> Iterator[Fine]:
    """Say of each end of these roles in an included file that another node is at the other end of its name."""
    known = view.once(owners)
    for channel in view.graph.channels.values():
        if not channel.offers or not channel.uses or channel.is_hub or channel.is_plumbing:
            continue
        for end in (*channel.offers, *channel.uses):
            if end.role not in roles or end.action:
                continue
            instance = known[id(end)]
            if instance.node.origin.step is None:
                continue
            if any(each.node != end.node for each in (channel.uses if end.role in OFFERS else channel.offers)):
                yield rule.fine(acting_origin(end, instance), topic_of(end))

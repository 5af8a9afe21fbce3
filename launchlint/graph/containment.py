"""What contains what, for drawing, and what each container shows to the outside: the paper's GroupPublisher and GroupSubscriber."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from launchlint.graph.topology import Topology, TopologyNode
from launchlint.named_tuple import NamedTuple

DEEPEST = 32
"""Levels of nesting that are told apart, counted from outside: what hostile files nest deeper would cost more than anybody wants to see."""


class Port(NamedTuple):
    """A channel that nodes inside a container offer (GroupPublisher) or use (GroupSubscriber).

    ``nodes`` are the nodes inside that do; ``inner`` says whether a counterpart is inside, too, ``outer`` whether one is outside.
    """

    kind: str
    name: str
    offers: bool
    nodes: tuple[str, ...]
    inner: bool
    outer: bool


def scopes(topology: Topology) -> Mapping[str, tuple[str, ...]]:
    """The id of each group and include, and the ids from the outermost one around it down to itself, at most :data:`DEEPEST` of them."""
    parents = {container.id: container.parent for container in topology.containers}
    found: dict[str, tuple[str, ...]] = {"": ()}
    for start in parents:
        inward: list[str] = []
        at = start
        while at not in found:
            inward.append(at)
            at = parents.get(at, "")
        for each in reversed(inward):
            around = found[at]
            found[each] = around if len(around) >= DEEPEST else (*around, each)
            at = each
    return found


def namespaces_of(node: TopologyNode) -> tuple[str, ...]:
    """The namespaces around a node, outermost first: ``/a``, ``/a/b``; none for the global one.

    Of more than :data:`DEEPEST` those in the middle are left out.
    """
    return tuple(_inward(node.namespace))


def _inward(namespace: str) -> Iterator[str]:
    if namespace == "/":
        return
    at = namespace.find("/", 1)
    for _ in range(DEEPEST - 1):
        if at < 0:
            break
        yield namespace[:at]
        at = namespace.find("/", at + 1)
    yield namespace


def ports(topology: Topology, *, by_namespace: bool = False) -> Mapping[str, tuple[Port, ...]]:
    """The ports of each container (id of a group or include, or a namespace), sorted. Plumbing is left out.

    Linear in connections times the depth of nesting, of which no more than :data:`DEEPEST` levels count.
    """
    around = {} if by_namespace else scopes(topology)
    levels: dict[str, tuple[str, ...]] = {}
    for node in topology.nodes:
        more = namespaces_of(node) if by_namespace else around[node.container]
        known = levels.get(node.name)
        levels[node.name] = more if known is None or known == more else tuple(dict.fromkeys((*known, *more)))
    plumbing = {(channel.kind, channel.name) for channel in topology.channels if channel.plumbing}
    inside: dict[str, dict[tuple[str, str, bool], dict[str, None]]] = {}
    total: dict[tuple[str, str, bool], set[str]] = {}
    for connection in topology.connections:
        if (connection.kind, connection.name) in plumbing:
            continue
        key = (connection.kind, connection.name, connection.offers)
        total.setdefault(key, set()).add(connection.node)
        for container in levels.get(connection.node, ()):
            inside.setdefault(container, {}).setdefault(key, {})[connection.node] = None
    return {container: tuple(_listed(inside[container], total)) for container in sorted(inside)}


def _listed(own: Mapping[tuple[str, str, bool], Mapping[str, None]], total: Mapping[tuple[str, str, bool], set[str]]) -> Iterator[Port]:
    for kind, name, offers in sorted(own):
        counterpart = (kind, name, not offers)
        within = len(own.get(counterpart, ()))
        yield Port(kind, name, offers, tuple(sorted(own[kind, name, offers])), within > 0, len(total.get(counterpart, ())) > within)

"""What contains what, for drawing, and what each container shows to the outside: the paper's GroupPublisher and GroupSubscriber."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from launchlint.graph.topology import Topology, TopologyNode


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


def scopes_of(node: TopologyNode) -> tuple[str, ...]:
    """The groups and includes around a node, outermost first."""
    return node.containers


def namespaces_of(node: TopologyNode) -> tuple[str, ...]:
    """The namespaces around a node, outermost first: ``/a``, ``/a/b``; none for the global one."""
    return tuple(_outward(node.namespace))


def _outward(namespace: str) -> Iterator[str]:
    at = namespace.find("/", 1)
    while at > 0:
        yield namespace[:at]
        at = namespace.find("/", at + 1)
    if namespace != "/":
        yield namespace


def ports(topology: Topology, *, by_namespace: bool = False) -> Mapping[str, tuple[Port, ...]]:
    """The ports of each container (id of a group or include, or a namespace), sorted. Plumbing is left out.

    Linear in connections times the depth of nesting.
    """
    around = {node.name: (namespaces_of(node) if by_namespace else scopes_of(node)) for node in topology.nodes}
    plumbing = {(channel.kind, channel.name) for channel in topology.channels if channel.plumbing}
    inside: dict[str, dict[tuple[str, str, bool], list[str]]] = {}
    total: dict[tuple[str, str, bool], int] = {}
    for connection in topology.connections:
        if (connection.kind, connection.name) in plumbing:
            continue
        key = (connection.kind, connection.name, connection.offers)
        total[key] = total.get(key, 0) + 1
        for container in around.get(connection.node, ()):
            inside.setdefault(container, {}).setdefault(key, []).append(connection.node)
    found: dict[str, tuple[Port, ...]] = {}
    for container in sorted(inside):
        own = inside[container]
        listed = []
        for kind, name, offers in sorted(own):
            counterpart = (kind, name, not offers)
            within = len(own.get(counterpart, ()))
            nodes = tuple(sorted(set(own[kind, name, offers])))
            listed.append(Port(kind, name, offers, nodes, within > 0, total.get(counterpart, 0) > within))
        found[container] = tuple(listed)
    return found

"""Looking at a part of a topology."""

from __future__ import annotations

from collections.abc import Iterable
from fnmatch import fnmatchcase

from launchlint.graph.topology import Connection, Container, Topology, TopologyNode, TopologyParam
from launchlint.named_tuple import NamedTuple

KINDS = ("topic", "service", "action", "param")


class Selection(NamedTuple):
    """What to keep. The defaults keep everything.

    Args:
        namespaces: nodes in a namespace that is, or matches (``*``, ``?``), one of these, or below it, with what they talk to.
        nodes: nodes whose full name is, or matches, one of these, with what they talk to.
        channels: only topics, services and actions whose name is, or matches, one of these, and the nodes that have to do with them.
        kinds: only channels of these kinds, and params only if they are among them.
        hubs: keep ``/tf`` and the like.
        plumbing: keep bonds, dynamic_reconfigure and the services of nodelet managers.
        action_topics: keep the topics of an action beside the action itself.
    """

    namespaces: tuple[str, ...] = ()
    nodes: tuple[str, ...] = ()
    channels: tuple[str, ...] = ()
    kinds: tuple[str, ...] = KINDS
    hubs: bool = True
    plumbing: bool = True
    action_topics: bool = True


def select(topology: Topology, selection: Selection) -> Topology:
    """The part of ``topology`` that ``selection`` describes. Nodes without any connection stay unless nodes or channels are asked for."""
    shown = {
        (channel.kind, channel.name)
        for channel in topology.channels
        if channel.kind in selection.kinds
        and (selection.hubs or not channel.hub)
        and (selection.plumbing or not channel.plumbing)
        and (not selection.channels or matches(channel.name, selection.channels))
    }
    connections = [
        connection
        for connection in topology.connections
        if (connection.kind, connection.name) in shown
        and (selection.action_topics or not connection.action or "action" not in selection.kinds)
    ]
    nodes = topology.nodes
    if selection.namespaces or selection.nodes:
        focus = {node.name for node in nodes if _is_focus(node, selection)}
        connections = _around(connections, focus)
        nodes = _kept(nodes, (focus if not selection.channels else set()) | {connection.node for connection in connections})
    elif selection.channels:
        nodes = _kept(nodes, {connection.node for connection in connections})
    used = {(connection.kind, connection.name) for connection in connections}
    names = None if nodes is topology.nodes else {node.name for node in nodes}
    params: Iterable[TopologyParam] = topology.params if "param" in selection.kinds else ()
    if names is not None:
        params = [param._replace(readers=tuple(reader for reader in param.readers if reader in names)) for param in params]
        params = [param for param in params if param.readers]
    return topology._replace(
        nodes=nodes,
        connections=tuple(connections),
        channels=tuple(channel for channel in topology.channels if (channel.kind, channel.name) in used),
        params=tuple(params),
        containers=_containers(topology, nodes),
    )


def unmatched(topologies: Iterable[Topology], selection: Selection) -> list[tuple[str, str, list[str]]]:
    """What was asked for and is nowhere: what it is (namespace, node, topic), as it was given, and the names that there are."""
    namespaces: set[str] = set()
    nodes: set[str] = set()
    channels: set[str] = set()
    for topology in topologies:
        nodes.update(node.name for node in topology.nodes)
        namespaces.update(node.namespace for node in topology.nodes)
        channels.update(channel.name for channel in topology.channels)
    asked = (
        ("namespace", selection.namespaces, namespaces, _is_in),
        ("node", selection.nodes, nodes, _matches),
        ("topic", selection.channels, channels, _matches),
    )
    return [
        (what, pattern, sorted(names))
        for what, patterns, names, holds in asked
        for pattern in patterns
        if not any(holds(name, pattern) for name in names)
    ]


def matches(name: str, patterns: Iterable[str]) -> bool:
    """Whether ``name`` is or matches one of the patterns; one without ``/`` at its start may begin at any level of the tree."""
    return any(_matches(name, pattern) for pattern in patterns)


def _matches(name: str, pattern: str) -> bool:
    return name == pattern or fnmatchcase(name, pattern if pattern.startswith("/") else f"*/{pattern}")


def _is_focus(node: TopologyNode, selection: Selection) -> bool:
    return any(_is_in(node.namespace, namespace) for namespace in selection.namespaces) or matches(node.name, selection.nodes)


def _is_in(namespace: str, pattern: str) -> bool:
    """Whether ``namespace`` is the one that ``pattern`` means, or below it."""
    wanted = f"/{pattern.strip('/')}"
    if wanted == "/" or namespace == wanted or namespace.startswith(f"{wanted}/"):
        return True
    return any(character in wanted for character in "*?[") and (fnmatchcase(namespace, wanted) or fnmatchcase(namespace, f"{wanted}/*"))


def _around(connections: list[Connection], focus: set[str]) -> list[Connection]:
    """The connections of the nodes in focus, and those of others at their other ends."""
    touched = {(connection.kind, connection.name, not connection.offers) for connection in connections if connection.node in focus}
    return [
        connection
        for connection in connections
        if connection.node in focus or (connection.kind, connection.name, connection.offers) in touched
    ]


def _kept(nodes: Iterable[TopologyNode], names: set[str]) -> tuple[TopologyNode, ...]:
    return tuple(node for node in nodes if node.name in names)


def _containers(topology: Topology, nodes: tuple[TopologyNode, ...]) -> tuple[Container, ...]:
    """The groups and includes that hold any of the nodes, directly or not."""
    parents = {container.id: container.parent for container in topology.containers}
    kept: set[str] = set()
    for node in nodes:
        at = node.container
        while at and at not in kept:
            kept.add(at)
            at = parents.get(at, "")
    return tuple(container for container in topology.containers if container.id in kept)

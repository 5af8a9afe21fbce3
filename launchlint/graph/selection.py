"""Looking at a part of a topology."""

from __future__ import annotations

from collections.abc import Iterable
from fnmatch import fnmatchcase
from typing import NamedTuple

from launchlint.graph.topology import Connection, Topology, TopologyNode

KINDS = ("topic", "service", "action")


class Selection(NamedTuple):
    """What to keep. The defaults keep everything.

    Args:
        namespaces: nodes in one of these namespaces, or below it, with what they talk to.
        nodes: nodes whose full name is, or matches (``*``, ``?``), one of these, with what they talk to.
        channels: only topics, services and actions whose name is, or matches, one of these.
        kinds: only channels of these kinds.
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
        and _matches(channel.name, selection.channels)
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
        touched = {(connection.kind, connection.name) for connection in connections if connection.node in focus}
        connections = [connection for connection in connections if (connection.kind, connection.name) in touched]
        nodes = _kept(nodes, focus | _talking(connections))
    elif selection.channels:
        nodes = _kept(nodes, _talking(connections))
    used = {(connection.kind, connection.name) for connection in connections}
    containers = {each for node in nodes for each in node.containers}
    names = {node.name for node in nodes}
    return topology._replace(
        nodes=nodes,
        connections=tuple(connections),
        channels=tuple(channel for channel in topology.channels if (channel.kind, channel.name) in used),
        params=tuple(param for param in topology.params if nodes is topology.nodes or names.intersection(param.readers)),
        containers=tuple(container for container in topology.containers if container.id in containers),
    )


def _is_focus(node: TopologyNode, selection: Selection) -> bool:
    below = any(f"{node.namespace.rstrip('/')}/".startswith(f"{namespace.rstrip('/')}/") for namespace in selection.namespaces)
    return below or (bool(selection.nodes) and _matches(node.name, selection.nodes))


def _matches(name: str, patterns: Iterable[str]) -> bool:
    """Whether ``name`` matches one of the patterns; a pattern without ``/`` at its start may match anywhere in the tree."""
    patterns = tuple(patterns)
    return not patterns or any(
        name == pattern or fnmatchcase(name, pattern if pattern.startswith("/") else f"*/{pattern}") for pattern in patterns
    )


def _talking(connections: Iterable[Connection]) -> set[str]:
    return {connection.node for connection in connections}


def _kept(nodes: Iterable[TopologyNode], names: set[str]) -> tuple[TopologyNode, ...]:
    return tuple(node for node in nodes if node.name in names)

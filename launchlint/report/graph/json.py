"""The connection graph and its changes as JSON: plain objects with the names of their fields."""

from __future__ import annotations

import json

from launchlint.graph.containment import Port, ports
from launchlint.graph.difference import Difference, Link, moved
from launchlint.graph.topology import Connection, Topology, TopologyNode
from launchlint.report.escape import no_surrogates

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


MOST_NODES = 16
"""Names of nodes that are listed of a port: those of outer containers would else repeat all those of inner ones."""


def text(value: Any) -> str:
    """JSON that any strict reader takes, indented, with a newline at its end."""
    out = json.dumps(value, indent=2, allow_nan=False)
    return (json.dumps(_strict(value), indent=2, allow_nan=False) if "\\ud" in out else out) + "\n"


def as_object(topology: Topology) -> dict[str, Any]:
    """All of a topology. Ports are those of groups and includes, by their id; the verdict is as ``check --format json`` has it.

    ``partly`` of a node are its names that are known only in part, with ``*`` for the rest: they are not among channels and connections.
    """
    return {
        "entry": topology.entry,
        "configurations": list(topology.configurations),
        "complete": topology.complete,
        "verdict": _verdict(topology),
        "nodes": [{**_node(node), "partly": _partly(node, topology)} for node in topology.nodes],
        "channels": [channel._asdict() for channel in topology.channels],
        "connections": [_connection(connection) for connection in topology.connections],
        "params": [param._asdict() for param in topology.params],
        "containers": [container._asdict() for container in topology.containers],
        "ports": {container: [_port(port) for port in listed] for container, listed in ports(topology).items()},
    }


def _verdict(topology: Topology) -> dict[str, Any] | None:
    return None if topology.verdict is None else topology.verdict.as_object()


def _connection(connection: Connection) -> dict[str, Any]:
    """All of a connection; of its QoS only where something is known of it."""
    found = {**connection._asdict(), "remaps": [step._asdict() for step in connection.remaps]}
    if not connection.qos:
        del found["qos"]
    return found


def _port(port: Port) -> dict[str, Any]:
    return {
        "kind": port.kind,
        "name": port.name,
        "direction": "out" if port.offers else "in",
        "nodes": port.nodes[:MOST_NODES],
        "count": len(port.nodes),
        "inner": port.inner,
        "outer": port.outer,
    }


def difference_as_object(changes: Difference) -> dict[str, Any]:
    """All that changed."""
    return {
        "entry": changes.after.entry,
        "entry_before": changes.before.entry,
        "configurations": {"before": list(changes.before.configurations), "after": list(changes.after.configurations)},
        "verdict": {"before": _verdict(changes.before), "after": _verdict(changes.after)},
        "uncertain": changes.uncertain,
        "lost": [_link(link) for link in changes.lost],
        "gained": [_link(link) for link in changes.gained],
        "moved": dict(moved(changes)),
        "nodes": {
            "added": [_node(node) for node in changes.nodes_added],
            "removed": [_node(node) for node in changes.nodes_removed],
            "changed": [{"before": _node(each.before), "after": _node(each.after)} for each in changes.nodes_changed],
        },
        "channels": {
            "added": [channel._asdict() for channel in changes.channels_added],
            "removed": [channel._asdict() for channel in changes.channels_removed],
            "changed": [{"before": each.before._asdict(), "after": each.after._asdict()} for each in changes.channels_changed],
        },
        "connections": {
            "added": [_connection(each) for each in changes.connections_added],
            "removed": [_connection(each) for each in changes.connections_removed],
            "changed": [{"before": _connection(each.before), "after": _connection(each.after)} for each in changes.connections_changed],
        },
    }


def _link(link: Link) -> dict[str, Any]:
    return {
        **link._asdict(),
        "before": None if link.before is None else _connection(link.before),
        "after": None if link.after is None else _connection(link.after),
    }


def _node(node: TopologyNode) -> dict[str, Any]:
    return {**node._asdict(), "open": dict(node.open)}


def _partly(node: TopologyNode, topology: Topology) -> list[dict[str, str]]:
    return [{"category": category, "name": pattern} for category, pattern in topology.partly.get((node.name, node.place), ())]


def _strict(value: Any) -> Any:
    """``value`` without lone surrogates, which strict readers refuse."""
    if isinstance(value, str):
        return no_surrogates(value)
    if isinstance(value, dict):
        return {no_surrogates(key): _strict(item) for key, item in value.items()}
    return [_strict(item) for item in value] if isinstance(value, (list, tuple)) else value

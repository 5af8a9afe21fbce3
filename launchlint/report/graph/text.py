"""The connection graph and its changes for people in a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.graph.difference import Difference, Link
from launchlint.graph.topology import Connection, Topology, TopologyNode
from launchlint.report.escape import line_start, visible

MOST_PEERS = 8
"""Names of peers on one line."""

_SIGNS = {
    "publisher": "publishes",
    "subscriber": "subscribes",
    "server": "serves",
    "client": "calls",
    "action server": "serves action",
    "action client": "calls action",
}
_ALONE = {
    "publisher": "publishes, and nobody subscribes",
    "subscriber": "subscribes, and nobody publishes",
    "server": "serves, and nobody calls",
    "client": "calls, and nobody serves",
    "action server": "serves actions that nobody calls",
    "action client": "calls actions that nobody serves",
}


def render(topology: Topology) -> str:
    """One block for each node: what it says and hears, who is at the other end, and what renamed it."""
    sides: dict[tuple[str, str, bool], list[str]] = {}
    mine: dict[str, list[Connection]] = {}
    for connection in topology.connections:
        sides.setdefault((connection.kind, connection.name, connection.offers), []).append(connection.node)
        mine.setdefault(connection.node, []).append(connection)
    lines = [f"{line_start(topology.entry)}: {_counts(topology)}"]
    for node in topology.nodes:
        lines += ["", *_node(node), *_connections(mine.get(node.name, ()), sides)]
    return "\n".join(lines) + "\n"


def _counts(topology: Topology) -> str:
    unknown = sum(node.knowledge == "unknown" for node in topology.nodes)
    nodes = _number(len(topology.nodes), "node") + (f" ({unknown} unknown)" if unknown else "")
    both = _connected(topology)
    configurations = f", {len(topology.configurations)} configurations" if len(topology.configurations) > 1 else ""
    missing = "" if topology.complete else "; an include could not be followed, so there may be more"
    channels = _number(len(topology.channels), "topic, service or action", "topics, services and actions")
    return f"{nodes}, {channels}, {both} of them connected{configurations}{missing}"


def _connected(topology: Topology) -> int:
    offered = {(each.kind, each.name) for each in topology.connections if each.offers}
    return len(offered & {(each.kind, each.name) for each in topology.connections if not each.offers})


def _number(count: int, one: str, many: str = "") -> str:
    return f"{count} {one if count == 1 else many or one + 's'}"


def _node(node: TopologyNode) -> Iterator[str]:
    details = [visible(node.program)]
    if node.kind == "nodelet":
        details.append(f"in {visible(node.host)}" if node.host and node.host != node.name else "in a manager that is not here")
    elif node.kind == "manager":
        details.append("nodelet manager")
    if node.conditions:
        details.append(visible(" ".join(node.conditions)))
    if node.only:
        details.append(f"only with {_only(node.only)}")
    yield f"{visible(node.name)}  {', '.join(details)}  ({visible(node.place)})"
    if node.knowledge == "unknown":
        yield f"    what it does is not known: {visible(node.reason)}"
    for category, reason in node.open:
        yield f"    may have more {category}: {visible(reason)}"


def _only(only: Iterable[str]) -> str:
    return visible(" or ".join(each or "the default args" for each in only))


def _connections(connections: Iterable[Connection], sides: dict[tuple[str, str, bool], list[str]]) -> Iterator[str]:
    alone: dict[str, list[str]] = {}
    for connection in connections:
        peers = sides.get((connection.kind, connection.name, not connection.offers), [])
        perhaps = "" if connection.certain else "perhaps "
        only = f" (only with {_only(connection.only)})" if connection.only else ""
        if not peers and not connection.remaps:
            alone.setdefault(f"{perhaps}{_ALONE[connection.role]}", []).append(visible(connection.name) + only)
            continue
        shown = ", ".join(visible(peer) for peer in peers[:MOST_PEERS]) or "nobody"
        more = f" and {len(peers) - MOST_PEERS} more" if len(peers) > MOST_PEERS else ""
        type_ = f" ({visible(connection.type)})" if connection.type else ""
        arrow = "→" if connection.offers else "←"
        yield f"    {perhaps}{_SIGNS[connection.role]} {visible(connection.name)}{type_} {arrow} {shown}{more}{only}"
        for step in connection.remaps:
            where = visible(step.place) if step.place else "its args"
            yield f"        {visible(step.source)} is remapped to {visible(step.target)} ({where})"
    for what, names in alone.items():
        yield f"    {what}: {', '.join(names)}"


def render_difference(changes: Difference) -> str:
    """What changed, the lost links first; empty where nothing did."""
    if changes.is_empty:
        return ""
    lines = [f"{line_start(changes.after.entry)}:"]
    lines += [f"  lost: {_link(link)}" for link in changes.lost]
    lines += [f"  gained: {_link(link)}" for link in changes.gained]
    if changes.lost and changes.uncertain:
        lines.append("  (a node that is not known came in: it may do what seems lost)")
    lines += [f"  - node {visible(node.name)} ({visible(node.program)})" for node in changes.nodes_removed]
    lines += [f"  + node {visible(node.name)} ({visible(node.program)})" for node in changes.nodes_added]
    for node in changes.nodes_changed:
        lines.append(f"  ~ node {visible(node.after.name)}: {_changed_node(node.before, node.after)}")
    lines += [f"  - {channel.kind} {visible(channel.name)}" for channel in changes.channels_removed]
    lines += [f"  + {channel.kind} {visible(channel.name)}" for channel in changes.channels_added]
    for channel in changes.channels_changed:
        before, after = (" and ".join(each.types) or "unknown type" for each in channel)
        lines.append(f"  ~ {channel.after.kind} {visible(channel.after.name)}: {visible(before)} → {visible(after)}")
    for change in changes.connections_changed:
        lines.append(f"  ~ {_side(change.before)} → {_end(change.before, change.after)}")
    lines += [f"  - {_side(connection)}" for connection in changes.connections_removed]
    lines += [f"  + {_side(connection)}" for connection in changes.connections_added]
    return "\n".join(lines) + "\n"


def _link(link: Link) -> str:
    more = f" and {link.total - len(link.partners)} more" if link.total > len(link.partners) else ""
    partners = ", ".join(visible(each) for each in link.partners) + more
    arrow = "→" if link.connection.offers else "←"
    return f"{visible(link.connection.node)} {_SIGNS[link.connection.role]} {visible(link.name)} {arrow} {partners}"


def _side(connection: Connection) -> str:
    return f"{visible(connection.node)} {_SIGNS[connection.role]} {visible(connection.name)}"


def _end(before: Connection, after: Connection) -> str:
    return visible(after.name) if after.name != before.name else f"type {visible(after.type or 'unknown')}"


def _changed_node(before: TopologyNode, after: TopologyNode) -> str:
    for what, old, new in (("program", before.program, after.program), ("process", before.host, after.host)):
        if old != new:
            return f"{what} {visible(old or 'unknown')} → {visible(new or 'unknown')}"
    return f"{before.knowledge} → {after.knowledge}"

"""The topology as a networkx multigraph, for other programs and for algorithms that networkx has.

Vertices are ``("node", name)``, ``("topic", name)``, ``("service", …)``, ``("action", …)`` and ``("param", …)``. Edges point the way the
data goes: publisher → topic → subscriber, client → service → server, param → reader. The attributes of an edge say why it exists, its key
is its own.
"""

from __future__ import annotations

from itertools import count

from launchlint.graph.topology import Connection, Topology

TYPE_CHECKING = False
if TYPE_CHECKING:
    import networkx

    Key = tuple[str, str]


def multigraph(topology: Topology) -> networkx.MultiDiGraph[Key]:
    """The multigraph of a topology. Every attribute is a string, number or truth value."""
    import networkx

    graph: networkx.MultiDiGraph[Key] = networkx.MultiDiGraph(entry=topology.entry)
    for node in topology.nodes:
        graph.add_node(
            ("node", node.name), kind="node", name=node.name, program=node.program, knowledge=node.knowledge, host=node.host,
            namespace=node.namespace, place=node.place, conditions=" and ".join(node.conditions), only=" | ".join(node.only),
        )  # fmt: skip
    for channel in topology.channels:
        graph.add_node(
            (channel.kind, channel.name), kind=channel.kind, name=channel.name, type=" ".join(channel.types), hub=channel.hub,
            plumbing=channel.plumbing,
        )  # fmt: skip
    for number, connection in enumerate(topology.connections):
        here, there = ("node", connection.node), (connection.kind, connection.name)
        towards = connection.offers == (connection.kind == "topic")  # a service's data comes from its clients
        source, target = (here, there) if towards else (there, here)
        graph.add_edge(source, target, key=f"connection{number}", **_why(connection))
    numbers = count()
    for param in topology.params:
        graph.add_node(("param", param.name), kind="param", name=param.name, value=param.value, place=param.place)
        for reader in param.readers:
            graph.add_edge(("param", param.name), ("node", reader), key=f"param{next(numbers)}", role="reader")
    return graph


def _why(connection: Connection) -> dict[str, str | bool]:
    return {
        "role": connection.role,
        "declared": connection.declared,
        "spelling": connection.spelling,
        "unremapped": connection.unremapped,
        "remaps": " ".join(f"{step.source}:={step.target} ({step.place or 'args'})" for step in connection.remaps),
        "type": connection.type,
        "certain": connection.certain,
        "when": connection.when,
        "action": connection.action,
        "only": " | ".join(connection.only),
        **({"qos": connection.qos} if connection.qos else {}),
    }

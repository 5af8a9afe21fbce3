"""The topology as a networkx graph."""

from __future__ import annotations

from hypothesis import given

from launchlint.graph.multigraph import multigraph
from launchlint.graph.topology import Topology, TopologyParam
from tests.graph import tiny


def test_edges_point_the_way_the_data_goes() -> None:
    topology = tiny.topology("/a > /x", "/b < /x", "/a serves /s", "/b calls /s", "/a does /go", "/b asks /go")
    graph = multigraph(topology._replace(params=(TopologyParam("/a/rate", "5", "demo.launch:2:1", ("/a",), ()),)))
    assert {(source, target, attributes["role"]) for source, target, attributes in graph.edges(data=True)} == {
        (("node", "/a"), ("topic", "/x"), "publisher"),
        (("node", "/b"), ("service", "/s"), "client"),
        (("node", "/b"), ("action", "/go"), "action client"),
        (("action", "/go"), ("node", "/a"), "action server"),
        (("service", "/s"), ("node", "/a"), "server"),
        (("topic", "/x"), ("node", "/b"), "subscriber"),
        (("param", "/a/rate"), ("node", "/a"), "reader"),
    }


def test_attributes_say_why() -> None:
    graph = multigraph(tiny.topology("/a > out=/x? @sim:=true", configurations=("", "sim:=true")))
    assert dict(graph.nodes[("topic", "/x")]) == {"kind": "topic", "name": "/x", "type": "", "hub": False, "plumbing": False}
    (attributes,) = (attributes for _, _, attributes in graph.edges(data=True))
    assert attributes == {
        "role": "publisher",
        "declared": "out",
        "spelling": "global",
        "unremapped": "/x",
        "remaps": "",
        "type": "",
        "certain": False,
        "when": "start",
        "action": "",
        "only": "sim:=true",
    }


@given(tiny.topologies())
def test_every_connection_is_an_edge_of_its_own(topology: Topology) -> None:
    graph = multigraph(topology)
    assert graph.number_of_edges() == len(topology.connections)
    assert len({key for _, _, key in graph.edges(keys=True)}) == len(topology.connections)
    assert {name for kind, name in graph if kind == "node"} == {node.name for node in topology.nodes}

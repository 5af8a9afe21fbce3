"""What groups, includes and namespaces show to the outside."""

from __future__ import annotations

import time
from pathlib import Path

from hypothesis import given, settings

from launchlint.graph.containment import DEEPEST, Port, namespaces_of, ports, scopes
from launchlint.graph.topology import Topology
from launchlint.graph.topology import topology as record
from tests.graph import sample, tiny

PACKAGES = {
    "d": {
        "executables": {
            "camera": sample.program(publishers=[{"name": "image"}]),
            "detector": sample.program(subscribers=[{"name": "image"}], publishers=[{"name": "/objects"}]),
            "viewer": sample.program(subscribers=[{"name": "/objects"}]),
        }
    }
}


def test_a_group_hides_what_only_its_own_nodes_use(tmp_path: Path) -> None:
    text = (
        '<group ns="left"><node pkg="d" type="camera" name="camera"/><node pkg="d" type="detector" name="detector"/></group>'
        '<node pkg="d" type="viewer" name="viewer"/>'
    )
    topology = record([sample.graph(tmp_path, text, PACKAGES)])
    (group,) = topology.containers
    assert (group.kind, group.label, group.parent) == ("group", "/left", "")
    assert dict(ports(topology)) == {
        group.id: (
            Port("topic", "/left/image", False, ("/left/detector",), inner=True, outer=False),
            Port("topic", "/left/image", True, ("/left/camera",), inner=True, outer=False),
            Port("topic", "/objects", True, ("/left/detector",), inner=False, outer=True),
        )
    }


def test_an_include_is_a_container_named_by_its_file_around_its_groups(tmp_path: Path) -> None:
    inner = '<group><node pkg="d" type="camera" name="camera"/></group>'
    text = '<include file="$(find pkg)/camera.launch" ns="left"/><include file="$(find pkg)/camera.launch" ns="right"/>'
    topology = record([sample.graph(tmp_path, text, PACKAGES, {"camera.launch": inner})])
    assert sorted((each.namespace, each.kind, each.label) for each in topology.containers) == [
        ("/left", "group", ""),
        ("/left", "include", "pkg/camera.launch"),
        ("/right", "group", ""),
        ("/right", "include", "pkg/camera.launch"),
    ]
    around = scopes(topology)
    labels = {each.id: each.kind for each in topology.containers}
    assert {each.name: [labels[id_] for id_ in around[each.container]] for each in topology.nodes} == {
        "/left/camera": ["include", "group"],
        "/right/camera": ["include", "group"],
    }
    assert {key: [(port.name, port.nodes) for port in found] for key, found in ports(topology, by_namespace=True).items()} == {
        "/left": [("/left/image", ("/left/camera",))],
        "/right": [("/right/image", ("/right/camera",))],
    }


def naive(topology: Topology, container: str) -> set[tuple[str, str, bool, tuple[str, ...], bool, bool]]:
    """The ports of a namespace by looking at every node for every channel."""
    inside = {each.name for each in topology.nodes if container in namespaces_of(each)}
    found = set()
    for kind, name in {(each.kind, each.name) for each in topology.connections}:
        for offers in (True, False):
            mine = {each.node for each in topology.connections if (each.kind, each.name, each.offers) == (kind, name, offers)}
            theirs = {each.node for each in topology.connections if (each.kind, each.name, each.offers) == (kind, name, not offers)}
            if mine & inside:
                found.add((kind, name, offers, tuple(sorted(mine & inside)), bool(theirs & inside), bool(theirs - inside)))
    return found


@given(tiny.topologies())
def test_ports_are_those_of_the_plain_definition(topology: Topology) -> None:
    computed = ports(topology, by_namespace=True)
    for namespace in {each for node in topology.nodes for each in namespaces_of(node)}:
        listed = computed.get(namespace, ())
        assert {tuple(port) for port in listed} == naive(topology, namespace)
        assert list(listed) == sorted(listed)


def test_plumbing_makes_no_ports() -> None:
    topology = tiny.topology("/a/m > /bond", "/b/n < /bond", plumbing=["/bond"])
    assert dict(ports(topology, by_namespace=True)) == {}


def test_namespaces_are_listed_from_the_outside() -> None:
    assert namespaces_of(tiny.node("/a/b/c/m")) == ("/a", "/a/b", "/a/b/c")
    assert namespaces_of(tiny.node("/m")) == ()


def test_of_very_deep_namespaces_the_middle_is_left_out() -> None:
    deep = "/n" * 1000
    found = namespaces_of(tiny.node(f"{deep}/m"))
    assert (len(found), found[:2], found[-1]) == (DEEPEST, ("/n", "/n/n"), deep)


@settings(deadline=None)
@given(tiny.topologies())
def test_every_scope_ends_with_itself(topology: Topology) -> None:
    assert dict(scopes(topology)) == {"": ()}


def test_a_thousand_levels_cost_no_more_than_so_many_containers(tmp_path: Path) -> None:
    text = '<group ns="n">' * 150 + '<node pkg="d" type="camera" name="c"/>' * 1 + "</group>" * 150
    topology = record([sample.graph(tmp_path, text, PACKAGES)])
    assert (len(topology.nodes), len(topology.containers)) == (1, 150)
    copies = topology._replace(nodes=tuple(topology.nodes[0]._replace(name=f"/m{number}") for number in range(5000)))
    started = time.process_time()
    assert len(ports(copies)) == 0
    assert max(map(len, scopes(copies).values())) == DEEPEST
    assert time.process_time() - started < 2

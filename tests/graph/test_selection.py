"""Looking at a part of a topology."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given

from launchlint.graph.selection import Selection, select, unmatched
from launchlint.graph.topology import Container, Topology, TopologyParam
from launchlint.graph.topology import topology as record
from tests.graph import sample, tiny

ROBOT = tiny.topology(
    "/arm/driver > /joints",
    "/arm/planner < /joints",
    "/base/driver > /odom",
    "/base/planner < /odom",
    "/logger < /joints",
    "/logger < /odom",
    "/base/planner calls /arm/stop",
    "/arm/driver serves /arm/stop",
    "/lonely > /nothing",
)


def shown(topology: Topology, **selection: object) -> dict[str, list[str]]:
    """Node → what is left of it."""
    part = select(topology, Selection(**selection))  # type: ignore[arg-type]  # the caller names fields of a selection
    found: dict[str, list[str]] = {node.name: [] for node in part.nodes}
    for each in part.connections:
        found[each.node].append(f"{each.role} {each.name}")
    return found


@given(tiny.topologies())
def test_the_default_keeps_everything(topology: Topology) -> None:
    assert select(topology, Selection()) == topology


@pytest.mark.parametrize("name", ["/arm/driver", "arm/driver", "/arm/d*", "*m/driver"])
def test_a_node_with_what_it_talks_to(name: str) -> None:
    assert shown(ROBOT, nodes=(name,)) == {
        "/arm/driver": ["publisher /joints", "server /arm/stop"],
        "/arm/planner": ["subscriber /joints"],
        "/base/planner": ["client /arm/stop"],
        "/logger": ["subscriber /joints"],
    }


def test_those_who_hear_the_same_do_not_talk_to_each_other() -> None:
    assert shown(ROBOT, nodes=("/logger",)) == {
        "/arm/driver": ["publisher /joints"],
        "/base/driver": ["publisher /odom"],
        "/logger": ["subscriber /joints", "subscriber /odom"],
    }


@pytest.mark.parametrize("namespace", ["/arm", "arm", "/arm/", "ar?", "/a*"])
def test_a_namespace_with_what_it_talks_to(namespace: str) -> None:
    assert list(shown(ROBOT, namespaces=(namespace,))) == ["/arm/driver", "/arm/planner", "/base/planner", "/logger"]


def test_the_global_namespace_is_everything() -> None:
    assert shown(ROBOT, namespaces=("/",)) == shown(ROBOT)


def test_namespaces_are_whole_words_and_include_those_below() -> None:
    topology = tiny.topology("/a/b/m > /x", "/ab/n > /y")
    assert list(shown(topology, namespaces=("/a",))) == ["/a/b/m"]


@pytest.mark.parametrize("name", ["/odom", "odom", "*dom"])
def test_a_topic_with_all_who_have_to_do_with_it(name: str) -> None:
    assert shown(ROBOT, channels=(name,)) == {
        "/base/driver": ["publisher /odom"],
        "/base/planner": ["subscriber /odom"],
        "/logger": ["subscriber /odom"],
    }


def test_node_and_topic_together_narrow() -> None:
    assert shown(ROBOT, channels=("/odom",), nodes=("/logger", "/lonely")) == {
        "/base/driver": ["publisher /odom"],
        "/logger": ["subscriber /odom"],
    }


def test_kinds() -> None:
    assert {each.kind for each in select(ROBOT, Selection(kinds=("service",))).channels} == {"service"}
    assert len(select(ROBOT, Selection(kinds=("service",))).nodes) == len(ROBOT.nodes)


def test_hubs_plumbing_and_action_topics_can_be_left_out() -> None:
    topology = tiny.topology("/a > /tf", "/a > /bond", "/a does /go", "/a > /go/result", hubs=["/tf"], plumbing=["/bond"])
    inside = topology._replace(
        connections=tuple(each._replace(action="/go" if "result" in each.name else "") for each in topology.connections)
    )
    assert shown(inside, hubs=False, plumbing=False, action_topics=False) == {"/a": ["action server /go"]}
    assert shown(inside, hubs=False, plumbing=False) == {"/a": ["action server /go", "publisher /go/result"]}
    assert shown(inside, kinds=("topic",), hubs=False, plumbing=False, action_topics=False) == {"/a": ["publisher /go/result"]}


def test_params_go_with_their_readers() -> None:
    params = (TopologyParam("/both", "1", "", ("/arm/driver", "/lonely"), ()), TopologyParam("/unread", "2", "", (), ()))
    topology = ROBOT._replace(params=params)
    assert [each.name for each in select(topology, Selection()).params] == ["/both", "/unread"]
    assert select(topology, Selection(nodes=("/lonely",))).params == (TopologyParam("/both", "1", "", ("/lonely",), ()),)
    assert select(topology, Selection(kinds=("topic",))).params == ()


def test_containers_go_with_their_nodes_and_all_around_them() -> None:
    containers = [
        Container("1", "include", "", "/", "", ""),
        Container("2", "group", "", "/", "", "1"),
        Container("3", "group", "", "/", "", ""),
    ]
    topology = tiny.topology(nodes=[tiny.node("/m", container="2"), tiny.node("/n", container="3")], containers=containers)
    assert [each.id for each in select(topology, Selection(nodes=("/m",))).containers] == ["1", "2"]


def test_what_is_asked_for_and_is_not_there() -> None:
    asked = Selection(namespaces=("/arm", "/leg"), nodes=("logger", "loger"), channels=("/odom*", "/foo"))
    assert [(what, pattern) for what, pattern, _ in unmatched([ROBOT], asked)] == [
        ("namespace", "/leg"),
        ("node", "loger"),
        ("topic", "/foo"),
    ]


@given(tiny.topologies())
def test_a_part_of_a_part_is_that_part(topology: Topology) -> None:
    for selection in (
        Selection(nodes=("/a/m",)),
        Selection(channels=("/x",)),
        Selection(namespaces=("/a/b",)),
        Selection(kinds=("topic",)),
    ):
        once = select(topology, selection)
        assert select(once, selection) == once
        assert set(once.connections) <= set(topology.connections)


def test_names_are_never_regular_expressions(tmp_path: Path) -> None:
    topology = record([sample.graph(tmp_path, "", {})])
    assert select(topology, Selection(nodes=("[", "(a+)+$" * 100))).nodes == ()

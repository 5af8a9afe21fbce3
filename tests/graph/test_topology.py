"""The record of a connection graph: what it says of each node, name and param, and several configurations joined."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from launchlint.check.entry import EntryChecker
from launchlint.check.graphs import graphs_of
from launchlint.check.options import EntryRequest, Options
from launchlint.graph.topology import Connection, RemapStep, Topology
from launchlint.graph.topology import topology as record
from tests.graph import sample

PACKAGES = {
    "d": {
        "executables": {
            "talker": sample.program(
                publishers=[{"name": "chatter", "type": "std_msgs/String", "evidence": [{"by": "manual", "at": "talker.py:3"}]}],
                params=[{"name": "~rate"}],
            ),
            "listener": sample.program(subscribers=[{"name": "chatter"}], services=[{"name": "~reset", "type": "std_srvs/Empty"}]),
            "maybe": sample.program(publishers=[{"name": "chatter", "condition": {"text": "if (debug)"}}], open={"services": "plugins"}),
        }
    }
}


def joined(directory: Path, launch: str, packages: Any = None) -> Topology:
    """All configurations of a launch file, joined."""
    sample.graph(directory, launch, packages or PACKAGES)  # writes the files
    file = directory / "pkg" / "main.launch"
    options = Options(frozenset(), (str(directory),), True, sample.ENVIRONMENT, str(directory), library=(str(directory / "library.json"),))
    return record(graphs_of(EntryChecker(options), EntryRequest(str(file), str(file))))


def test_what_is_said_of_a_connection(tmp_path: Path) -> None:
    text = '<node pkg="d" type="talker" name="t" ns="a"><remap from="chatter" to="/talk"/></node>'
    (found,) = record([sample.graph(tmp_path, text, PACKAGES)]).connections
    assert found == Connection(
        node="/a/t",
        role="publisher",
        kind="topic",
        name="/talk",
        declared="chatter",
        spelling="relative",
        unremapped="/a/chatter",
        remaps=(RemapStep("/a/chatter", "/talk", "pkg/main.launch:1:53"),),
        type="std_msgs/String",
        certain=True,
        when="start",
        process="/a/t",
        action="",
        evidence=("manual: talker.py:3",),
        only=(),
    )


def test_what_is_said_of_nodes_channels_and_params(tmp_path: Path) -> None:
    text = (
        '<node pkg="d" type="talker" name="t"><param name="rate" value="5"/></node>'
        '<node pkg="d" type="maybe" name="m" ns="a" if="true"/><node pkg="x" type="y" name="stranger"/>'
        '<param name="list" type="yaml" value="[1, two]"/><param name="on" value="true"/>'
    )
    found = record([sample.graph(tmp_path, text, PACKAGES)])
    assert [(each.name, each.program, each.knowledge, each.reason, each.open, each.conditions) for each in found.nodes] == [
        ("/a/m", "d/maybe", "known", "", (("services", "plugins"),), ('if="true"',)),
        ("/stranger", "x/y", "unknown", "no library knows x/y", (), ()),
        ("/t", "d/talker", "known", "", (), ()),
    ]
    assert [tuple(each) for each in found.channels] == [
        ("topic", "/a/chatter", (), False, False),
        ("topic", "/chatter", ("std_msgs/String",), False, False),
    ]
    assert [(each.name, each.value, each.readers) for each in found.params] == [
        ("/list", "[1, 'two']", ()),
        ("/on", "true", ()),
        ("/t/rate", "5", ("/t",)),
    ]
    assert [(each.node, each.certain) for each in found.connections] == [("/a/m", False), ("/t", True)]


def test_long_values_of_params_are_cut(tmp_path: Path) -> None:
    text = f'<param name="long" value="{"x" * 1000}"/><param name="many" type="yaml" value="[{"1, " * 1000}1]"/>'
    long, many = record([sample.graph(tmp_path, text, PACKAGES)]).params
    assert long.value == "x" * 199 + "…"
    assert (many.value[:9], many.value[-1], len(many.value)) == ("[1, 1, 1,", "…", 200)


def test_configurations_are_joined_and_marked(tmp_path: Path) -> None:
    text = (
        '<arg name="sim" default="false"/><node pkg="d" type="talker" name="t"/>'
        '<node pkg="d" type="listener" name="l" if="$(arg sim)"/>'
        '<node pkg="d" type="listener" name="l2" unless="$(arg sim)"><remap from="chatter" to="other"/></node>'
    )
    found = joined(tmp_path, text)
    assert found.configurations == ("", "sim:=true")
    assert [(each.name, each.only) for each in found.nodes] == [("/l", ("sim:=true",)), ("/l2", ("",)), ("/t", ())]
    assert [(each.node, each.role, each.name, each.only) for each in found.connections] == [
        ("/l", "server", "/l/reset", ("sim:=true",)),
        ("/l", "subscriber", "/chatter", ("sim:=true",)),
        ("/l2", "server", "/l2/reset", ("",)),
        ("/l2", "subscriber", "/other", ("",)),
        ("/t", "publisher", "/chatter", ()),
    ]


def test_alternatives_of_one_name_stay_two_nodes(tmp_path: Path) -> None:
    text = (
        '<arg name="sim" default="false"/><node pkg="d" type="talker" name="base" if="$(arg sim)"/>'
        '<node pkg="d" type="maybe" name="base" unless="$(arg sim)"/>'
    )
    found = joined(tmp_path, text)
    assert [(each.name, each.program, each.only) for each in found.nodes] == [
        ("/base", "d/maybe", ("",)),
        ("/base", "d/talker", ("sim:=true",)),
    ]


def test_a_node_that_only_differs_in_its_surroundings_is_one(tmp_path: Path) -> None:
    """Its manager is there in one configuration only; the node itself is the same in both."""
    nodelet = {
        "executables": {"nodelet": {"class": "roscpp", "variants": {"manager": {"match": {"arg": 1, "is": "manager"}}, "default": {}}}}
    }
    text = (
        '<arg name="sim" default="false"/><node pkg="nodelet" type="nodelet" name="manager" args="manager" if="$(arg sim)"/>'
        '<node pkg="nodelet" type="nodelet" name="flip" args="load d/Flip manager"/>'
    )
    packages = {"d": {"nodelets": {"d/Flip": {"class": "nodelet", "variants": {"default": {"publishers": [{"name": "out"}]}}}}}}
    found = joined(tmp_path, text, {**packages, "nodelet": nodelet})
    assert [(each.name, each.only) for each in found.nodes] == [("/flip", ()), ("/manager", ("sim:=true",))]
    assert [(each.node, each.only) for each in found.connections if each.name == "/out"] == [("/flip", ())]


def test_what_is_uncertain_in_one_configuration_is_uncertain(tmp_path: Path) -> None:
    packages = {"d": {"executables": {"n": sample.program(publishers=[{"name": "x", "condition": {"param": "~on"}}])}}}
    text = (
        '<arg name="from" default="true"/><node pkg="d" type="n" name="n"><param name="on" value="true" if="$(arg from)"/>'
        '<param name="on" command="cat on" unless="$(arg from)"/></node>'
    )
    (found,) = joined(tmp_path, text, packages).connections
    assert (found.name, found.certain, found.only) == ("/x", False, ())


def test_one_to_many_is_no_hub(tmp_path: Path) -> None:
    many = "".join(f'<node pkg="d" type="listener" name="l{number}"/>' for number in range(70))
    one = '<node pkg="d" type="talker" name="t"/>'
    assert [each.hub for each in record([sample.graph(tmp_path, one + many, PACKAGES)]).channels if each.kind == "topic"] == [False]
    more = "".join(f'<node pkg="d" type="talker" name="t{number}"/>' for number in range(8))
    assert [each.hub for each in record([sample.graph(tmp_path, more + many, PACKAGES)]).channels if each.kind == "topic"] == [True]


def test_a_launch_file_that_starts_nothing(tmp_path: Path) -> None:
    found = record([sample.graph(tmp_path, "", PACKAGES)])
    assert found == Topology("pkg/main.launch", ("",), True, (), (), (), (), ())

"""The connection graph of ROS 2 launch files: names as rcl makes them, params of each node, components, and no word of ROS 1 libraries."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.graph.connect import connect
from launchlint.graph.connections import ConnectionGraph
from launchlint.graph.names_rcl import RclNamer
from launchlint.graph.topology import topology
from launchlint.library.file import open_library
from launchlint.library.lookup import Library
from launchlint.model import Remap
from launchlint.source import Origin, Place, Source, Span
from tests.evaluate.ros2.launching import Workspace
from tests.graph.sample import STRING, channels, edges, library, program

ANYWHERE = Origin(Place(Source("a.launch.xml", ""), Span(0, 0)))


def talker(**more: Any) -> dict[str, Any]:
    said = {"by": "manual", "at": "a"}
    return program("other", publishers=[{"name": "chatter", "type": STRING, "evidence": [said]}], **more)


def graph(directory: Path, launch: str, programs: Mapping[str, Any]) -> ConnectionGraph:
    workspace = Workspace(directory, launch)
    found = evaluate(workspace.session(), str(workspace.launch_files / "main.launch.xml")).launch
    return connect(found, library(directory, {"pk": {"executables": dict(programs)}}))


def namer(*remaps: tuple[str, str], node: str = "/ns/n") -> RclNamer:
    return RclNamer("/ns/", node, [Remap(source, target, ANYWHERE) for source, target in remaps])


@pytest.mark.parametrize(
    ("remaps", "name", "topic"),
    [
        ((), "a", "/ns/a"),
        ((), "~/a", "/ns/n/a"),
        ((), "~a", "/ns/n/a"),
        ((), "/a", "/a"),
        ((("a", "b"),), "a", "/ns/b"),
        ((("a", "b"), ("a", "c")), "a", "/ns/b"),
        ((("a", "b"), ("b", "c")), "a", "/ns/b"),
        ((("/ns/a", "~/b"),), "a", "/ns/n/b"),
        ((("rosservice://a", "b"),), "a", "/ns/a"),
        ((("other:a", "b"),), "a", "/ns/a"),
        ((("n:a", "b"),), "a", "/ns/b"),
        ((("a-b", "c"),), "a", "/ns/a"),
    ],
)
def test_names_are_those_of_rcl(remaps: tuple[tuple[str, str], ...], name: str, topic: str) -> None:
    assert namer(*remaps).topic(name).name == topic


def test_topics_and_services_apart() -> None:
    names = namer(("rosservice://a", "b"))
    assert (names.topic("a").name, names.resolve("a").name) == ("/ns/a", "/ns/b")
    assert [each.rule.remap is not None for each in names.resolve("a").applied] == [True]


def test_nodes_that_launch_gives_no_name_are_called_by_their_program(tmp_path: Path) -> None:
    found = graph(
        tmp_path,
        '<node pkg="pk" exec="talker"><remap from="chatter" to="/talk"/></node><node pkg="pk" exec="talker"/>',
        {"talker": talker(subscribers=[{"name": "~in", "type": STRING, "evidence": [{"by": "manual", "at": "a"}]}])},
    )
    assert edges(found) == [
        "/(talker) publisher /talk",
        "/(talker) subscriber /(talker)/in",
        "/(talker 2) publisher /chatter",
        "/(talker 2) subscriber /(talker 2)/in",
    ]


@pytest.mark.parametrize(
    ("own", "given", "topic"),
    [
        ("surface", "", "/surface/chatter"),
        ("/surface", "", "/surface/chatter"),
        ("surface", ' namespace="a"', "/a/chatter"),
        ("", "", "/chatter"),
    ],
)
def test_the_namespace_that_a_node_gives_itself(tmp_path: Path, own: str, given: str, topic: str) -> None:
    workspace = Workspace(tmp_path, f'<node pkg="pk" exec="talker" name="t"{given}/>')
    published = [{"name": "chatter", "type": "std_msgs/msg/String", "evidence": [{"by": "manual", "at": "a"}]}]
    said = {"namespace": own} if own else {}
    package = {"middleware": "ros2", "executables": {"talker": program("other", publishers=published, **said)}}
    file = tmp_path / "library.json"
    file.write_text(json.dumps({"format": "launchlint-library", "version": 2, "packages": {"pk": package}}))
    launch = evaluate(workspace.session(), str(workspace.launch_files / "main.launch.xml")).launch
    found = connect(launch, Library([open_library(str(file))], bundled=False))
    assert [edge.rpartition(" ")[2] for edge in edges(found)] == [topic]


def test_nodes_meet_in_channels_and_actions_are_not_topics(tmp_path: Path) -> None:
    said = [{"by": "manual", "at": "a"}]
    listener = program("other", subscribers=[{"name": "chatter", "type": STRING, "evidence": said}])
    action = {"name": "go", "type": "a/Go", "role": "server", "evidence": said}
    found = graph(
        tmp_path,
        '<node pkg="pk" exec="talker" name="t" namespace="a"/><node pkg="pk" exec="listener" name="l" namespace="a"/>',
        {"talker": talker(actions=[action]), "listener": listener},
    )
    assert channels(found) == ["action /a/go: /a/t > ", "topic /a/chatter: /a/t > /a/l"]


def test_what_is_shipped_and_read_of_ros1_says_nothing(tmp_path: Path) -> None:
    workspace = Workspace(tmp_path, '<node pkg="usb_cam" exec="usb_cam_node" name="c"/>')
    (tmp_path / "usb_cam").mkdir()
    (tmp_path / "usb_cam/package.xml").write_text("<package><name>usb_cam</name></package>")
    shipped = Library()
    assert shipped.executable("usb_cam", "usb_cam_node") is not None
    found = connect(evaluate(workspace.session(), str(workspace.launch_files / "main.launch.xml")).launch, shipped)
    assert [(each.name, each.knowledge, each.reason) for each in found.instances] == [
        ("/c", "unknown", "no library knows usb_cam/usb_cam_node")
    ]


def test_components_and_their_containers(tmp_path: Path) -> None:
    container = '<node_container pkg="pk" exec="box" name="box" namespace="/a">{}</node_container>'
    component = '<composable_node pkg="pk" plugin="pk::Part" name="part"/>'
    found = graph(
        tmp_path,
        container.format(component)
        + f'<load_composable_node target="/elsewhere">{component.replace("part", "other")}</load_composable_node>',
        {},
    )
    assert [(each.name, each.kind, each.program, each.host) for each in found.instances] == [
        ("/a/box", "container", "pk/box", "/a/box"),
        ("/part", "component", "pk::Part", "/a/box"),
        ("/other", "component", "pk::Part", ""),
    ]


def test_params_are_those_of_each_node(tmp_path: Path) -> None:
    node = (
        '<node pkg="pk" exec="talker" name="{}"><param name="rate" value="{}"/><param name="a"><param name="b" value="x"/></param></node>'
    )
    found = graph(tmp_path, node.format("one", 1) + node.format("two", 2.5), {})
    parameters = found.parameters
    assert [parameters.value(name) for name in ("/one:rate", "/two:rate", "/one:a.b", "/one:c")] == [1, 2.5, "x", None]
    assert parameters.read("~rate", found.instances[1].namer) == 2.5
    assert parameters.read("a/b", found.instances[0].namer) == "x"
    assert [(each.name, each.value, each.readers) for each in topology([found]).params] == [
        ("/one:a.b", "x", ("/one",)),
        ("/one:rate", "1", ("/one",)),
        ("/two:a.b", "x", ("/two",)),
        ("/two:rate", "2.5", ("/two",)),
    ]

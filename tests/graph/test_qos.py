"""Quality of service in the graph of ROS 2: as the library says, as params say, and who does not connect."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.graph.connect import connect
from launchlint.graph.connections import ConnectionGraph
from launchlint.graph.qos import Clash, clashes, qos_text
from launchlint.graph.topology import topology
from launchlint.library.file import open_library
from launchlint.library.lookup import Library
from launchlint.report.graph.json import as_object
from tests.evaluate.ros2.launching import Workspace
from tests.graph.sample import channels, edges
from tests.library.samples import ros2_library, written

STRING = "std_msgs/msg/String"
TEN = {"reliability": "reliable", "durability": "volatile", "history": "keep_last", "depth": 10}
SENSOR = {"reliability": "best_effort", "durability": "volatile", "history": "keep_last", "depth": 5}


def variant(**interface: Any) -> dict[str, Any]:
    return {"class": "rclcpp", "variants": {"default": interface}}


def graph(directory: Path, launch: str, programs: dict[str, Any], components: dict[str, Any] | None = None) -> ConnectionGraph:
    """The graph of a launch file with a library of format 2 for the package pk."""
    directory = directory / str(len(list(directory.iterdir())))
    directory.mkdir()
    workspace = Workspace(directory, launch)
    found = evaluate(workspace.session(), str(workspace.launch_files / "main.launch.xml")).launch
    document = ros2_library(pk={"executables": programs, "components": components or {}})
    return connect(found, Library([open_library(written(directory / "library.json", document))], bundled=False))


def talker(qos: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"talker": variant(publishers=[{"name": "chatter", "type": STRING, "qos": qos, **more}])}


def offered(found: ConnectionGraph) -> dict[str, Any]:
    return dict(found.instances[0].endpoints[0].qos)


def test_what_the_library_says(tmp_path: Path) -> None:
    found = graph(tmp_path, '<node pkg="pk" exec="talker" name="t"/>', talker(TEN))
    assert offered(found) == TEN
    (connection,) = topology([found]).connections
    assert connection.qos == "reliable, volatile, keep_last 10"
    (said,) = as_object(topology([found]))["connections"]
    assert said["qos"] == "reliable, volatile, keep_last 10"


def test_nothing_is_said_where_nothing_is_known(tmp_path: Path) -> None:
    found = graph(tmp_path, '<node pkg="pk" exec="talker" name="t"/>', talker({}))
    (said,) = as_object(topology([found]))["connections"]
    assert "qos" not in said


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("", {"reliability": "reliable", "depth": 7}),
        ('<param name="qos" value="best_effort"/><param name="queue" value="3"/>', {"reliability": "best_effort", "depth": 3}),
        ('<param name="qos" value="SYSTEM_DEFAULT"/>', {"depth": 7}),
        ('<param name="queue" value="x" type="str"/>', {"reliability": "reliable"}),
    ],
)
def test_params_say_what_templates_stand_for(tmp_path: Path, given: str, expected: dict[str, Any]) -> None:
    said = {"reliability": "{param:~qos|reliable}", "depth": "{param:~queue|7}"}
    assert offered(graph(tmp_path, f'<node pkg="pk" exec="talker" name="t">{given}</node>', talker(said))) == expected


OVERRIDE = '<param name="qos_overrides.{}" value="{}"/>'


@pytest.mark.parametrize(
    ("overrides", "name", "value", "expected"),
    [
        (True, "/chat.publisher.reliability", "best_effort", TEN | {"reliability": "best_effort"}),
        (True, "/chat.publisher.depth", "2", TEN | {"depth": 2}),
        (False, "/chat.publisher.reliability", "best_effort", TEN),
        (True, "/chatter.publisher.reliability", "best_effort", TEN),
        (True, "/chat.subscription.reliability", "best_effort", TEN),
        (True, "/chat.publisher.durability", "transient_local", {key: TEN[key] for key in TEN if key != "durability"}),
        (True, "/chat.publisher_id.reliability", "best_effort", {key: TEN[key] for key in TEN if key != "reliability"}),
        (True, "/chat.publisher.reliability", "system_default", {key: TEN[key] for key in TEN if key != "reliability"}),
    ],
)
def test_params_override_it_under_the_name_on_the_graph(tmp_path: Path, overrides: bool, name: str, value: str, expected: Any) -> None:
    launch = f'<node pkg="pk" exec="talker" name="t"><remap from="chatter" to="chat"/>{OVERRIDE.format(name, value)}</node>'
    assert offered(graph(tmp_path, launch, talker(TEN, overrides=overrides))) == expected


def test_params_that_are_not_known_may_override_everything(tmp_path: Path) -> None:
    launch = '<node pkg="pk" exec="talker" name="t"><param from="$(env NOT_SET)/a.yaml"/></node>'
    assert offered(graph(tmp_path, launch, talker(TEN, overrides=True))) == {}
    assert offered(graph(tmp_path, launch, talker(TEN))) == TEN


@pytest.mark.parametrize(
    ("offer", "request_", "expected"),
    [
        (TEN, TEN, ()),
        (TEN, SENSOR, ()),
        (SENSOR, TEN, (Clash("reliability", "best_effort", "reliable"),)),
        (TEN, {"durability": "transient_local"}, (Clash("durability", "volatile", "transient_local"),)),
        ({"durability": "transient_local"}, TEN, ()),
        ({"reliability": "best_effort"}, {}, ()),
        ({}, {"reliability": "reliable"}, ()),
        ({"deadline": 2}, {"deadline": 1}, (Clash("deadline", 2, 1),)),
        ({"deadline": 1}, {"deadline": 2}, ()),
        ({"deadline": "infinite"}, {"deadline": 2}, (Clash("deadline", "infinite", 2),)),
        ({"deadline": 0}, {"deadline": 2}, (Clash("deadline", 0, 2),)),
        ({"deadline": 1}, {"deadline": "infinite"}, ()),
        ({}, {"deadline": 2}, ()),
        ({"liveliness": "automatic"}, {"liveliness": "manual_by_topic"}, (Clash("liveliness", "automatic", "manual_by_topic"),)),
        ({"lease": 3}, {"lease": 1}, (Clash("lease", 3, 1),)),
        ({"history": "keep_last", "depth": 1, "lifespan": 1}, {"history": "keep_all", "depth": 9, "lifespan": 5}, ()),
    ],
)
def test_an_offer_must_be_as_strong_as_the_request(offer: Any, request_: Any, expected: Any) -> None:
    assert clashes(offer, request_) == expected


def test_in_words() -> None:
    assert qos_text({"depth": 3, "durability": "volatile", "deadline": 0.5}) == "volatile, depth 3, deadline 0.5"


def test_a_node_without_name_calls_itself(tmp_path: Path) -> None:
    programs = {
        "talker": variant(node="talker", namespace="/robot", publishers=[{"name": "~state", "type": STRING}, {"name": "a"}]),
        "said": variant(node="{arg:1|quiet}"),
    }
    launch = '<node pkg="pk" exec="talker"/><node pkg="pk" exec="talker" namespace="x"/><node pkg="pk" exec="said" args="{}"/>'
    found = graph(tmp_path, launch.format("loud"), programs)
    assert edges(found) == [
        "/robot/talker publisher /robot/a",
        "/robot/talker publisher /robot/talker/state",
        "/x/talker publisher /x/a",
        "/x/talker publisher /x/talker/state",
    ]
    assert [each.name for each in found.instances][2] == "/loud"
    assert [each.name for each in graph(tmp_path, launch.format("not-a-name"), programs).instances][2] == "/(said)"


def test_several_nodes_of_one_process(tmp_path: Path) -> None:
    entries = [{"name": "~a"}, {"name": "~b", "node": "second"}, {"name": "c", "node": "{any}"}, {"name": "~d", "node": "{any}"}]
    programs = {"two": variant(node="first", publishers=entries)}
    found = graph(tmp_path, '<node pkg="pk" exec="two"/>', programs)
    assert edges(found) == ["/first publisher /first/a", "/first publisher /second/b"]
    assert [each.pattern for each in found.instances[0].doubts] == ["*/c", "*/d"]
    assert sorted(edges(graph(tmp_path, '<node pkg="pk" exec="two" name="n"/>', programs))) == [
        "/n publisher /c",
        "/n publisher /n/a",
        "/n publisher /n/b",
        "/n publisher /n/d",
    ]


def test_components_are_looked_up_by_package_and_class(tmp_path: Path) -> None:
    components = {"pk::Part": {"class": "component", "variants": {"default": {"node": "part", "lifecycle": True, "undeclared": True}}}}
    launch = (
        '<node_container pkg="pk" exec="box" name="box" namespace="">{}</node_container>'
        '<load_composable_node target="/box"><composable_node pkg="other" plugin="pk::Part" name="other"/></load_composable_node>'
    )
    found = graph(tmp_path, launch.format('<composable_node pkg="pk" plugin="pk::Part" name="part"/>'), {}, components)
    box, part, other = found.instances
    assert (part.name, part.kind, part.host, part.knowledge, part.lifecycle, part.undeclared) == (
        "/part",
        "component",
        "/box",
        "known",
        True,
        True,
    )
    assert (other.name, other.knowledge, box.knowledge) == ("/other", "unknown", "unknown")


def test_images_have_the_types_of_ros_2(tmp_path: Path) -> None:
    image = {"name": "image", "type": "sensor_msgs/msg/Image", "transport": "image"}
    found = graph(tmp_path, '<node pkg="pk" exec="cam" name="c"/>', {"cam": variant(publishers=[image])})
    assert {each.name: each.type for each in found.instances[0].endpoints if each.name.endswith("compressed")} == {
        "/image/compressed": "sensor_msgs/msg/CompressedImage"
    }


def test_a_param_with_dots_is_read(tmp_path: Path) -> None:
    programs = {"node": variant(params=[{"name": "~FollowPath.max_speed", "type": "double", "declared": True}])}
    found = graph(tmp_path, '<node pkg="pk" exec="node" name="n"/>', programs)
    assert [each.name for each in found.instances[0].readings] == ["/n:FollowPath.max_speed"]


def test_libraries_of_version_1_say_types_in_words_of_ros_2(tmp_path: Path) -> None:
    workspace = Workspace(tmp_path, '<node pkg="pk" exec="talker" name="t"/>')
    found = evaluate(workspace.session(), str(workspace.launch_files / "main.launch.xml")).launch
    program = {"class": "other", "variants": {"default": {"publishers": [{"name": "a", "type": "std_msgs/String"}]}}}
    document = {"format": "launchlint-library", "version": 1, "packages": {"pk": {"executables": {"talker": program}}}}
    made = connect(found, Library([open_library(written(tmp_path / "lib.json", document))], bundled=False))
    assert [each.type for each in made.instances[0].endpoints] == [STRING]
    assert channels(made) == ["topic /a: /t > "]

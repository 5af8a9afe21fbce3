"""Version 2 of the format: packages of ROS 2 beside those of ROS 1, and version 1 as it was."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from launchlint.errors import LibraryError
from launchlint.library.difference import difference
from launchlint.library.file import examine, open_library
from launchlint.library.inspection import inspect
from launchlint.library.lookup import Library, open_libraries
from launchlint.library.merge import Clash, merge_files, merge_libraries
from launchlint.library.schema import json_schema
from launchlint.library.shipped import Bundled
from launchlint.library.validate import faults
from launchlint.library.write import canonical
from launchlint.model import ROS1, ROS2
from tests.library.samples import evidence, executable, library, ros2_library, written

QOS = {
    "reliability": "reliable",
    "durability": "{param:~durability|volatile}",
    "history": "keep_last",
    "depth": "{param:~depth|10}",
    "deadline": 0.5,
    "lifespan": "infinite",
    "liveliness": "manual_by_topic",
    "lease": 2,
}
EVERYTHING = ros2_library(
    demo={
        "complete": ["executables", "components"],
        "components": {"demo::Talker": {"class": "component", "variants": {"default": {"node": "talker", "namespace": "/robot"}}}},
        "executables": {
            "container": {"class": "container", "like": "other/container"},
            "node": {
                "class": "rclcpp",
                "variants": {
                    "default": {
                        "node": "{arg:1|filter}",
                        "lifecycle": True,
                        "undeclared": True,
                        "publishers": [
                            {
                                "name": "~state",
                                "type": "std_msgs/msg/String",
                                "qos": QOS,
                                "overrides": True,
                                "node": "second",
                                "exists": "active",
                                "when": "message",
                                "evidence": evidence("static"),
                            }
                        ],
                        "subscribers": [{"name": "in", "type": "*", "transport": "image", "qos": {"depth": 0}}],
                        "services": [{"name": "~reset", "type": "std_srvs/srv/Empty", "exists": "configured"}],
                        "clients": [{"name": "{param:~service|x}", "type": "std_srvs/srv/Empty"}],
                        "actions": [{"name": "go", "role": "server", "type": "demo/action/Go"}],
                        "params": [
                            {
                                "name": "~FollowPath.max_speed",
                                "type": "double",
                                "dynamic": False,
                                "declared": True,
                                "read_only": True,
                                "default": 1.5,
                                "min": 0.0,
                                "max": 3.0,
                                "step": 0.5,
                                "description": "m/s",
                            },
                            {"name": "~{param:~plugin|x}.mode", "type": "string", "one_of": ["a", "b"]},
                        ],
                        "open": {"publishers": "plugins"},
                    }
                },
            },
        },
    }
)
EVERYTHING["packages"]["old"] = {"executables": {"node": {"class": "roscpp", "variants": {"default": {"publishers": [{"name": "a"}]}}}}}


def told(document: Any) -> list[str]:
    """What breaks the format, without the places."""
    return [fault.message for fault in faults(document)]


def publisher(**keys: Any) -> list[str]:
    return told(ros2_library(demo={"executables": {"node": executable(publishers=[{"name": "a", **keys}]) | {"class": "rclcpp"}}}))


def test_everything_that_can_be_said_passes_validator_and_schema() -> None:
    assert told(EVERYTHING) == []
    for schema in (json_schema(), json_schema(2)):
        Draft202012Validator.check_schema(schema)
        assert [error.message for error in Draft202012Validator(schema).iter_errors(EVERYTHING)] == []
    assert not Draft202012Validator(json_schema(1)).is_valid(EVERYTHING)
    assert Draft202012Validator(json_schema(1)).is_valid(library(demo={"nodelets": {"a/B": executable()}}))


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ({"type": "std_msgs/String"}, '"std_msgs/String" is no type: in ROS 2 it is written package/msg/Type (srv, action)'),
        (
            {"qos": {"reliability": "best"}},
            '"best" is not one of reliable, best_effort, system_default, best_available',
        ),
        ({"qos": {"reliability": "{param:~x"}}, '"{param:~x" is no template: '),
        ({"qos": {"depth": 1.5}}, "this must be a whole number, at least 0 or a template, and is 1.5"),
        ({"qos": {"depth": True}}, "this must be a whole number, at least 0 or a template, and is true"),
        ({"qos": {"deadline": -1}}, 'this must be a number, at least 0 or "infinite" or "best_available" or a template, and is -1'),
        (
            {"qos": {"deadline": "never"}},
            'this must be a number, at least 0 or "infinite" or "best_available" or a template, and is "never"',
        ),
        ({"qos": {"deadlin": 1}}, 'a QoS profile has no key "deadlin": did you mean deadline?'),
        ({"latched": True}, 'that is said of packages of ROS 1; here `qos` has "durability": "transient_local"'),
        ({"queue": 10}, "that is said of packages of ROS 1; here `qos` has a `depth`"),
        ({"node": "/a"}, '"/a" is no node\'s name: letters, digits and _, no digit first'),
        ({"exists": "alive"}, '"alive" is not one of constructed, configured, active'),
    ],
)
def test_a_slip_is_told(keys: dict[str, Any], message: str) -> None:
    (found,) = publisher(**keys)
    assert message in found
    document = ros2_library(demo={"executables": {"node": {"variants": {"default": {"publishers": [{"name": "a", **keys}]}}}}})
    if "is no " not in message:
        assert not Draft202012Validator(json_schema()).is_valid(document)


def test_what_is_of_the_other_middleware_is_told() -> None:
    of_ros2 = 'that is said of packages of ROS 2: "version": 2, and "middleware": "ros2" in the package'
    assert told(library(demo={"components": {}})) == [f'a package has no key "components": {of_ros2}']
    assert told(library(demo={"middleware": "ros2"})) == [f'a package has no key "middleware": {of_ros2}']
    assert told(library(demo={"executables": {"a": executable(publishers=[{"name": "a", "qos": {}}])}})) == [
        f'a publisher has no key "qos": {of_ros2}'
    ]
    version_2 = {**library(demo={"components": {}}), "version": 2}
    assert told(version_2) == [f'a package of ROS 1 has no key "components": {of_ros2}']
    assert told(ros2_library(demo={"nodelets": {}})) == [
        'a package of ROS 2 has no key "nodelets": that is said of packages of ROS 1; here there are `components`'
    ]
    assert told(ros2_library(demo={"middleware": "ros3"})) == ['"ros3" is not one of ros1, ros2']
    assert told(ros2_library(demo={"executables": {"a": {"class": "roscpp"}}})) == [
        '"roscpp" is not one of rclcpp, rclpy, component, container, none, other; did you mean rclcpp?'
    ]


@pytest.mark.parametrize("name", ["rate", "/rate", "~", "~a b", "~/rate"])
def test_a_param_is_a_nodes_own(name: str) -> None:
    document = ros2_library(demo={"executables": {"a": executable(params=[{"name": name}]) | {"class": "rclpy"}}})
    assert [each.partition(": ")[0] for each in told(document)] == [f'"{name}" is no param']


def test_what_has_no_effect_is_told() -> None:
    program = executable(
        publishers=[{"name": "a", "exists": "active"}, {"name": "/rosout"}, {"name": "b", "node": "x"}, {"name": "b"}],
        services=[{"name": "~get_parameters"}, {"name": "go/goal"}],
        actions=[{"name": "go", "role": "server"}],
        params=[{"name": "~use_sim_time"}, {"name": "~{param:~a|b-c}.d"}],
    )
    document = ros2_library(demo={"executables": {"a": {**program, "class": "rclcpp"}}, "components": {"d::A": {"like": "d::B"}}})
    lines = inspect(json.dumps(document).encode(), "x")[1]
    assert [line.partition(": ")[2] for line in lines] == [
        'only nodes with a lifecycle are configured and activated: the variant lacks "lifecycle": true',
        "every node has /rosout: leave it out",
        "every node has ~get_parameters: leave it out",
        "every node has ~use_sim_time: leave it out",
        'there is no component "d::B" of the package demo here or in the bundled library',
    ]


def test_the_canonical_text_keeps_everything() -> None:
    text = canonical(EVERYTHING)
    assert json.loads(text) == EVERYTHING
    assert canonical(json.loads(text)) == text
    assert '{"name": "~state", "type": "std_msgs/msg/String", "qos": {"reliability": "reliable", ' in text


def test_libraries_of_both_versions_are_joined() -> None:
    old = library(old={"executables": {"other": executable()}})
    merged = merge_libraries([EVERYTHING, old])
    assert (merged["version"], sorted(merged["packages"]["old"]["executables"])) == (2, ["node", "other"])
    assert merged["packages"]["demo"]["middleware"] == "ros2"
    assert merge_libraries([old, old])["version"] == 1
    with pytest.raises(Clash, match="demo is a package of ROS 1 in one and of ROS 2 in another"):
        merge_libraries([EVERYTHING, library(demo={})])


def test_a_clash_names_the_files(tmp_path: Path) -> None:
    one, other = written(tmp_path / "a.json", EVERYTHING), written(tmp_path / "b.json", library(demo={}))
    with pytest.raises(LibraryError, match=r"a\.json, .*b\.json: these libraries cannot be joined: demo is a package of ROS 1"):
        merge_files([one, other])


def test_policies_are_joined_one_by_one() -> None:
    def said(by: str, **keys: Any) -> dict[str, Any]:
        return ros2_library(demo={"executables": {"a": executable(publishers=[{"name": "x", **keys, "evidence": evidence(by)}])}})

    merged = merge_libraries([said("static", qos={"depth": 5, "history": "keep_last"}), said("dynamic", qos={"depth": 1})])
    (entry,) = merged["packages"]["demo"]["executables"]["a"]["variants"]["default"]["publishers"]
    assert entry["qos"] == {"depth": 1, "history": "keep_last"}
    apart = merge_libraries([said("static", node="second"), said("dynamic")])
    assert len(apart["packages"]["demo"]["executables"]["a"]["variants"]["default"]["publishers"]) == 2


def test_an_executable_may_be_like_a_component(tmp_path: Path) -> None:
    component = {"class": "component", "variants": {"default": {"node": "listener"}}}
    executables = {"listener": {"like": "demo::Listener"}, "same": {"like": "demo/listener"}, "round": {"like": "demo/round"}}
    document = ros2_library(demo={"executables": executables, "components": {"demo::Listener": component, "demo::Too": {"like": "same"}}})
    assert [line.partition(": ")[2] for line in inspect(json.dumps(document).encode(), "x")[1]] == [
        '`like` leads in a circle: "round" → "round"'
    ]
    known = open_libraries([written(tmp_path / "lib.json", document)], bundled=False).ros2
    programs = [known.executable("demo", "listener"), known.executable("demo", "same"), known.component("demo", "demo::Too")]
    assert [each.variants[0].node for each in programs if each is not None] == ["listener"] * 3
    assert known.executable("demo", "round") is None


def test_changes_are_told() -> None:
    changed = json.loads(json.dumps(EVERYTHING))
    variant = changed["packages"]["demo"]["executables"]["node"]["variants"]["default"]
    variant["node"] = "other"
    variant["publishers"][0]["qos"]["reliability"] = "best_effort"
    del changed["packages"]["demo"]["components"]["demo::Talker"]
    assert [(each.kind, each.what, each.name) for each in difference(EVERYTHING, changed)] == [
        ("changed", "variant", "default"),
        ("changed", "publisher", "~state"),
        ("removed", "component", "demo::Talker"),
    ]


OLD = library(
    demo={
        "complete": ["nodelets"],
        "executables": {
            "node": executable(
                publishers=[{"name": "a", "type": "std_msgs/String", "latched": True, "queue": 1, "md5": "0" * 32}],
                actions=[{"name": "go", "role": "client", "type": "demo/GoAction"}],
                services=[{"name": "s", "type": "std_srvs/Empty"}],
                params=[{"name": "~n", "type": "int"}, {"name": "~l", "type": "list"}],
                frames=[{"name": "odom", "role": "child"}],
            )
        },
        "nodelets": {"demo/A": executable(), "demo/B": {"like": "demo/A"}},
    }
)


@pytest.fixture
def libraries(tmp_path: Path) -> Library:
    """One of version 1, and over it one of version 2."""
    new = ros2_library(robot={"executables": {"node": {"class": "rclcpp", "variants": {"default": {"node": "robot"}}}}})
    new["packages"]["robot1"] = {"middleware": "ros1", "executables": {"node": executable()}}
    return open_libraries([written(tmp_path / "old.json", OLD), written(tmp_path / "new.json", new)], bundled=False)


def test_each_middleware_sees_its_packages(libraries: Library) -> None:
    assert libraries.packages() == ("demo", "robot1")
    assert libraries.ros2.packages() == ("demo", "robot")
    assert libraries.of(ROS2).packages() == ("robot",)
    assert libraries.executable("robot", "node") is None
    assert libraries.ros2.executable("robot1", "node") is None
    found = libraries.ros2.executable("robot", "node")
    assert found is not None
    assert (found.client, found.variants[0].node) == ("rclcpp", "robot")


def test_version_1_serves_both_in_the_words_of_each(libraries: Library) -> None:
    one, other = libraries.executable("demo", "node"), libraries.ros2.executable("demo", "node")
    assert one is not None
    assert other is not None
    assert [each.type for each in one.variants[0].declarations[:3]] == ["std_msgs/String", "std_srvs/Empty", "demo/GoAction"]
    assert [each.type for each in other.variants[0].declarations[:3]] == ["std_msgs/msg/String", "std_srvs/srv/Empty", "demo/action/Go"]
    assert [each.declared.type for each in other.variants[0].declarations[3:] if each.declared is not None] == ["integer", ""]
    assert [each.name for each in other.variants[0].frames] == ["odom"]
    assert libraries.nodelet("demo/B") is not None
    assert libraries.ros2.nodelet("demo/B") is not None
    assert libraries.ros2.component("demo", "demo/A") is not None
    assert libraries.ros2.has_all_nodelets("demo")


def test_an_index_knows_the_version(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("launchlint.library.file.INDEX_PAYS", 0)
    path, cache = written(tmp_path / "lib.json", EVERYTHING), str(tmp_path / "cache")
    for _ in range(2):
        file = open_library(path, cache)
        assert (file.package("demo", ROS1), file.package("old", ROS2)) == (None, None)
        assert file.package("demo", ROS2) == EVERYTHING["packages"]["demo"]
        assert (file.package_of_class("demo::Talker", ROS2), file.package_of_class("demo::Talker", ROS1)) == ("demo", None)
    path = written(tmp_path / "lib.json", OLD)
    for _ in range(2):
        file = open_library(path, cache)
        assert file.package("demo", ROS2, borrowed=False) is None
        assert file.package("demo", ROS2) is not None
        assert file.package_of_class("demo/A", ROS2) == "demo"


def test_packages_of_both_stand_side_by_side_on_the_shelf(tmp_path: Path) -> None:
    (tmp_path / "ros2").mkdir()
    written(tmp_path / "demo.json", library(demo={"executables": {"old": executable()}}))
    new = ros2_library(demo={"executables": {"new": executable() | {"class": "rclpy"}}, "components": {"demo::A": {}, "far::B": {}}})
    written(tmp_path / "ros2" / "demo.json", new)
    written(tmp_path / "ros2" / "index.json", {"components": {"far::B": "demo"}})
    one, other = Bundled(directory=str(tmp_path)), Bundled(ROS2, str(tmp_path / "ros2"))
    assert (list((one.package("demo") or {})["executables"]), list((other.package("demo") or {})["executables"])) == (["old"], ["new"])
    assert (other.names(), [other.package_of_class(each) for each in ("demo::A", "far::B", "far::C")]) == (
        ("demo",),
        ["demo", "demo", None],
    )


def test_the_shelf_of_ros_2_is_in_order() -> None:
    assert Bundled(ROS2).package_of_class("nobody::Knows") is None
    for name in Bundled(ROS2).names():
        package = Bundled(ROS2).package(name)
        assert package is not None
        assert package["middleware"] == "ros2"
        assert told({"format": "launchlint-library", "version": 2, "packages": {name: package}}) == []


def test_a_version_that_is_no_number_is_told() -> None:
    text = '{"format": "launchlint-library", "version": "2", "packages": {}}'
    assert examine(text.encode(), "x")[1] == ['x:1:45: this must be a whole number, at least 1, and is "2"']

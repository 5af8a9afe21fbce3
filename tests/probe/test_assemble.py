"""Records → library → what people read, side by side."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launchlint.library.file import examine
from launchlint.library.inspection import inspect_file
from launchlint.library.write import canonical
from launchlint.probe.assemble import assemble
from launchlint.probe.configuration import ProbeConfiguration
from launchlint.probe.record import LaunchRecord, NodeRecord, Note, Problem
from launchlint.probe.run import Outcome
from launchlint.probe.sources import Tree
from launchlint.probe.summary import is_worth_a_failure, summary

STRING = {"std_msgs/String": {"md5": "992ce8a1687cec8c8bd883ec73ca41d1", "text": "string data"}}
TREE = Tree("robot-0a1b2c3d", "https://github.com/team/robot.git", "main", "0a1b2c3d4e5f67890a1b2c3d4e5f67890a1b2c3d", "", "")

CONFIGURATION = ProbeConfiguration(
    nodes={
        "robot/driver": {
            "args": "{}",
            "params": {"~port": "/dev/null"},
            "variants": {"fast": {"params": {"~rate": 100}}, "x": {"match": {"arg": 2}, "args": "a b"}},
        },
    },
)


def node(
    name: str,
    status: str = "ok",
    interface: dict[str, Any] | None = None,
    *problems: Problem,
    program: str = "roscpp",
    variant: str = "default",
    traits: dict[str, Any] | None = None,
) -> NodeRecord:
    label = name if program in ("nodelet", "component") else f"robot/{name}"
    return NodeRecord(
        label,
        "robot",
        name,
        program,
        variant,
        f"hash of {label} {variant}",
        "0123456789abcdef",
        status,
        interface or {},
        traits or {},
        STRING,
        problems,
        1.0,
        0,
        "",
    )


RECORDS = [
    node("driver", "failed"),
    node("driver", "ok", {"subscribers": [{"name": "{arg:1}", "type": "std_msgs/String"}]}),
    node(
        "driver",
        "ok",
        {"publishers": [{"name": "fast", "type": "std_msgs/String", "md5": "992ce8a1687cec8c8bd883ec73ca41d1"}]},
        variant="fast",
    ),
    node("driver", "failed", None, Problem("ended", "it ended by itself with status 3"), variant="x"),
    node("waiter", "ok", {"clients": [{"name": "map"}]}, Problem("waits-for-service", "map"), program="rospy"),
    node("broken", "failed", {"publishers": [{"name": "before"}]}, Problem("module-missing", "No module named 'x'"), program="rospy"),
    node("tool", "not-a-node", program="none"),
    node(
        "robot/Filter", "ok", {"params": [{"name": "~gain", "type": "double", "default": 1.0, "min": 0.0, "max": 2.0}]}, program="nodelet"
    ),
    LaunchRecord(
        "robot/a.launch",
        "robot",
        "a.launch",
        {"x": "1"},
        "h1",
        "ok",
        ({"name": "driver", "publishers": [{"name": "fast"}]},),
        ("volume",),
        (),
        2.0,
        0,
        "",
    ),
]
NOTES = [
    Note("environment", {"distro": "debian", "base": "Debian GNU/Linux 12"}),
    Note("package", {"package": "robot", "status": "found", "version": "1.0.0"}),
    Note("package", {"package": "rowbot", "status": "missing", "version": ""}),
    Note(
        "build",
        {"package": "robot", "result": "partial", "errors": ["a.cpp:1: error: no"], "log": ["make: a.o", "make: *** [a.o] Error 1"]},
    ),
    Note("dependency", {"name": "qt6", "needed_by": ["robot"], "detail": "apt has no package for it"}),
    Note("unknown", {"label": "robot/dirver"}),
]


def test_library(snapshot: Callable[[str, str], None]) -> None:
    document = assemble(CONFIGURATION, RECORDS, NOTES, [TREE], {"robot": TREE.name}, local=False)
    text = canonical(document)
    assert examine(text.encode(), "library.json")[1] == []
    snapshot("library.json", text)


QOS = {"reliability": "reliable", "durability": "volatile", "history": "keep_last", "depth": 10}
OF_ROS2 = [
    node(
        "driver",
        "ok",
        {
            "publishers": [{"name": "scan", "type": "sensor_msgs/msg/LaserScan", "qos": QOS, "exists": "configured"}],
            "params": [{"name": "~rate", "type": "integer", "default": 10, "declared": True, "node": "clock"}],
        },
        program="rclcpp",
        traits={"node": "driver", "namespace": "/lidar", "lifecycle": True},
    ),
    node("odd", "ok", {}, Problem("params-unanswered", "it said nothing of its params"), program="rclpy", traits={"undeclared": True}),
    node("stuck", "ok", {}, Problem("not-configured", "it was told to configure and refused that"), program="rclpy"),
    node("robot::Filter", "ok", {"services": [{"name": "~reset", "type": "std_srvs/srv/Empty"}]}, program="component"),
    node("robot::Lost", "failed", {}, Problem("not-loaded", "it could not be loaded: no such class"), program="component"),
]
NOTES_OF_ROS2 = [Note("environment", {"distro": "jazzy", "base": "Ubuntu 24.04", "middleware": "ros2"}), NOTES[1]]


def test_library_of_ros2(snapshot: Callable[[str, str], None]) -> None:
    document = assemble(CONFIGURATION, OF_ROS2, NOTES_OF_ROS2, [TREE], {"robot": TREE.name}, local=False)
    text = canonical(document)
    assert examine(text.encode(), "library.json")[1] == []
    snapshot("library_ros2.json", text)


def test_summary_of_ros2() -> None:
    assert "\n".join(summary(outcome(OF_ROS2, NOTES_OF_ROS2), "library.json")) == (
        "library.json: 3 executables and 1 component recorded, 1 could not be run, 0 programs are no nodes\n"
        "could not be run:\n"
        "  component not loaded: 1\n"
        "    robot::Lost: it could not be loaded: no such class\n"
        "recorded, but there may be more to them:\n"
        "  not configured: 1 (give it the params that it wants by `params`)\n"
        "    robot/stuck: it was told to configure and refused that\n"
        "  nothing said of its params: 1\n"
        "    robot/odd: it said nothing of its params"
    )


def test_what_is_written_has_nothing_without_effect(tmp_path: Any) -> None:
    file = tmp_path / "library.json"
    file.write_text(canonical(assemble(CONFIGURATION, RECORDS, NOTES, [TREE], {"robot": TREE.name}, local=False)))
    assert inspect_file(str(file))[1] == []


def test_the_order_of_records_does_not_matter() -> None:
    def text(records: list[Any]) -> str:
        return canonical(assemble(CONFIGURATION, records, NOTES, [TREE], {"robot": TREE.name}, local=False))

    assert text(RECORDS[1:]) == text(RECORDS[:0:-1])


def outcome(records: list[Any], notes: list[Note], **changes: Any) -> Outcome:
    return Outcome(records, notes, [TREE], {}, 0, (0, ""), "")._replace(**changes)


def test_summary() -> None:
    lines = summary(outcome(RECORDS[1:], NOTES, left=1, refused=(3, "it is no JSON"), lost="time was up"), "library.json")
    assert "\n".join(lines) == (
        "library.json: 2 executables and 1 nodelet recorded, 1 could not be run, 1 program is no node\n"
        "1 of 1 launch file recorded\n"
        "could not be run:\n"
        "  ended by itself: 1\n"
        "    robot/driver: it ended by itself with status 3\n"
        "  Python module missing: 1 (install it by `apt` or `pip`)\n"
        "    robot/broken: No module named 'x'\n"
        "recorded, but there may be more to them:\n"
        "  service waited for, of a type that is not installed: 1 (install its package by `apt`)\n"
        "    robot/waiter: map\n"
        "there is no package rowbot: correct `packages`, or install it by `apt`\n"
        "robot: built in part: a.cpp:1: error: no\n"
        "    make: a.o\n"
        "    make: *** [a.o] Error 1\n"
        "robot: the dependency qt6 was not installed: apt has no package for it\n"
        "no probed package has robot/dirver, which `nodes` or `programs` names\n"
        "3 lines of the container's output were no records and were left out: it is no JSON\n"
        "1 process could not be ended\n"
        "not everything was probed: time was up; --resume goes on"
    )


def test_when_the_exit_status_says_that_something_is_missing() -> None:
    good, bad = node("a"), node("b", "failed")
    assert not is_worth_a_failure(outcome([good, bad], []))
    assert not is_worth_a_failure(outcome([], []))
    assert is_worth_a_failure(outcome([bad], []))
    assert is_worth_a_failure(outcome([good], [NOTES[2]]))
    assert is_worth_a_failure(outcome([good], [NOTES[5]]))
    built = Note("build", {"package": "a", "result": "ok", "errors": [], "log": []})
    assert not is_worth_a_failure(outcome([good], [built]))
    assert is_worth_a_failure(outcome([good], [Note("build", {**built.facts, "result": "failed"})]))
    assert is_worth_a_failure(outcome([good], [], lost="x"))
    assert is_worth_a_failure(outcome([good], [], left=1))

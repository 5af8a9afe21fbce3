"""What the probe says of nodes of ROS 2: with the observer's recorded words everywhere, and with real nodes where there is a ROS 2."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pytest

from launchlint.probe.record import NodeRecord, parse
from tests.probe.odd_nodes import processes_with
from tests.probe.ros2_nodes import HERE, RECORDED, VARIABLE, environment, install, installation, job, replayed, run, stand_in

LIMIT = 12

EXPECTED: dict[str, tuple[str, dict[str, Any], list[str], list[str]]] = {
    "acts.py": (
        "ok",
        {"node": "acts"},
        ["actions count server example_interfaces/action/Fibonacci", "actions ~plan client example_interfaces/action/Fibonacci"],
        [],
    ),
    "crashes.py": (
        "ok",
        {"node": "crashes"},
        ["publishers last_words std_msgs/msg/String reliable volatile 10"],
        ["exception: IndexError: list index out of range", "ended: it ended by itself with status 1", "params-unanswered: it said nothing"],
    ),
    "ignores_signals.py": (
        "ok",
        {"node": "ignores_signals"},
        ["publishers stubborn std_msgs/msg/String reliable volatile 10"],
        [],
    ),
    "kills_its_observer.py": (
        "ok",
        {"node": "kills_its_observer"},
        ["publishers gun std_msgs/msg/String reliable volatile 10"],
        ["observer-ended: what watches it was ended", "params-unanswered: it said nothing"],
    ),
    "mute.py": (
        "ok",
        {"node": "mute"},
        ["publishers noise std_msgs/msg/String reliable volatile 10"],
        ["params-unanswered: it said nothing of its params when it was asked"],
    ),
    "never_begins.py": ("failed", {}, [], ["busy: it was still computing", "silent: it never showed up among the nodes"]),
    "own_namespace.py": (
        "ok",
        {"node": "scout", "namespace": "/team"},
        ["publishers found std_msgs/msg/String reliable volatile 10"],
        [],
    ),
    "prints_without_end.py": (
        "ok",
        {"node": "prints_without_end"},
        ["publishers garbage std_msgs/msg/String reliable volatile 10"],
        ["too-much-output: it printed without end", "params-unanswered: it said nothing"],
    ),
    "random_names.py": (
        "ok",
        {"node": "random_names"},
        [
            "publishers session_{any}/status std_msgs/msg/String reliable volatile 10",
            "publishers steady std_msgs/msg/String reliable volatile 10",
        ],
        [],
    ),
    "refuses_to_configure.py": (
        "ok",
        {"node": "refuses", "lifecycle": True},
        [],
        ["not-configured: it was told to configure and refused that"],
    ),
    "several.py": (
        "ok",
        {"node": "one"},
        [
            "params ~limit integer 4 @two",
            "publishers words std_msgs/msg/String reliable volatile 10",
            "services ~stop std_srvs/srv/Empty @two",
            "subscribers words std_msgs/msg/String reliable volatile 10 @two",
        ],
        [],
    ),
    "stateful.py": (
        "ok",
        {"node": "stateful", "lifecycle": True},
        [
            "params ~port string /dev/null",
            "params ~rate integer 10 exists configured",
            "publishers readings std_msgs/msg/String reliable volatile 10 exists configured",
            "subscribers commands std_msgs/msg/String reliable volatile 10 exists active",
        ],
        [],
    ),
    "takes_any.py": ("ok", {"node": "takes_any", "undeclared": True}, ["params ~known double 1.0"], []),
    "talks.py": (
        "ok",
        {"node": "talks"},
        [
            "clients dock/open std_srvs/srv/Trigger",
            "params ~arm.joints string_array ['one', 'two'] read_only",
            "params ~count integer 3 1..9",
            "params ~speed double 1.5 0.0..10.0 step 0.5 'metres a second'",
            "params ~whatever bool True dynamic",
            "publishers /status std_msgs/msg/String reliable volatile 10",
            "publishers chatter std_msgs/msg/String reliable volatile 7",
            "publishers {node}_debug std_msgs/msg/String reliable volatile 10",
            "publishers ~state std_msgs/msg/String reliable transient_local 1",
            "services ~reset std_srvs/srv/Trigger",
            "subscribers orders std_msgs/msg/String best_effort volatile 5",
        ],
        [],
    ),
    "waits_for_message.py": (
        "ok",
        {"node": "waits_for_message"},
        [
            "publishers answer std_msgs/msg/String reliable volatile 10 when message",
            "subscribers first std_msgs/msg/String reliable volatile 10",
        ],
        [],
    ),
    "waits_for_service.py": (
        "ok",
        {"node": "waits_for_service"},
        ["clients map/load std_srvs/srv/Trigger", "publishers loaded std_msgs/msg/String reliable volatile 10"],
        [],
    ),
    "wants_even_numbers.py": ("ok", {"node": "wants_even_numbers", "undeclared": True}, [], []),
    "wants_args.py": (
        "ok",
        {"node": "wants_args"},
        [
            "params ~topic string",
            "publishers {arg:1} std_msgs/msg/String reliable volatile 10",
            "subscribers {param:~topic} std_msgs/msg/String reliable volatile 10",
        ],
        [],
    ),
}


def told(category: str, entry: dict[str, Any]) -> str:
    words = [category, entry["name"], entry.get("role", ""), entry.get("type", "")]
    qos = entry.get("qos", {})
    words += [str(qos[key]) for key in ("reliability", "durability", "depth") if key in qos]
    words += [str(entry["default"])] if "default" in entry else []
    words += [f"{entry['min']}..{entry['max']}"] if "min" in entry else []
    words += [f"step {entry['step']}"] if "step" in entry else []
    words += [repr(entry["description"])] if "description" in entry else []
    words += [key for key in ("read_only", "dynamic") if entry.get(key)]
    words += [f"{key} {entry[key]}" for key in ("exists", "when") if key in entry]
    words += [f"@{entry['node']}"] if "node" in entry else []
    return " ".join(word for word in words if word)


def check(record: dict[str, Any]) -> None:
    status, traits, names, problems = EXPECTED[record["name"]]
    found = sorted(told(category, entry) for category, entries in record["interface"].items() for entry in entries)
    said = [f"{problem['code']}: {problem['detail']}" for problem in record["problems"]]
    assert (record["status"], record.get("traits", {}), found) == (status, traits, names)
    assert len(said) == len(problems), said
    assert all(whole.startswith(begin) for whole, begin in zip(said, problems, strict=True)), said
    assert record["program"] == "rclpy"
    assert record["left"] == []


@pytest.mark.parametrize("name", RECORDED)
def test_recorded(name: str, tmp_path: Path) -> None:
    record = replayed(tmp_path, name)
    check(record)
    known = parse(json.dumps(record))
    assert isinstance(known, NodeRecord)
    assert "odd-names" not in [problem.code for problem in known.problems]


@pytest.fixture(scope="module")
def live(tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, Any]]:
    place = installation()
    if place is None:
        pytest.skip(f"there is no ROS 2 here (name one by {VARIABLE})")
    prefix = install(tmp_path_factory.mktemp("ros2"), sorted(path.name for path in (HERE / "nodes_ros2").glob("*.py")))
    found = run(job(prefix, jobs=3), environment(place), timeout=900)
    assert found[-1] == {"kind": "end", "left": 0}
    assert processes_with(str(prefix)) == []
    return {record["name"]: record for record in found if record["kind"] == "node"}


@pytest.mark.ros2
@pytest.mark.parametrize("name", EXPECTED)
def test_live(name: str, live: dict[str, dict[str, Any]]) -> None:
    check(live[name])


@pytest.mark.ros2
def test_names_without_end_are_open(live: dict[str, dict[str, Any]]) -> None:
    record = live["names_without_end.py"]
    codes = {problem["code"] for problem in record["problems"]}
    assert codes & {"too-many-names", "never-quiet"}
    assert record["seconds"] < 3 * (LIMIT + 10)


def test_a_node_that_is_never_seen_is_not_taken_for_something_else(tmp_path: Path) -> None:
    """A program that rclpy is imported by may be slow: that it was silent does not make it a program without names."""
    (tmp_path / "empty.jsonl").write_text("")
    prefix = install(tmp_path / "prefix", ["talks.py"], stand_in=True)
    observer = stand_in(tmp_path, tmp_path / "empty.jsonl", "replay")
    variables = {**os.environ, "AMENT_PREFIX_PATH": str(prefix)}
    (record,) = [each for each in run(job(prefix, "talks.py", limit=2), variables, observer) if each["kind"] == "node"]
    assert (record["status"], record["problems"]) == ("failed", [{"code": "silent", "detail": "it never showed up among the nodes"}])


@pytest.mark.ros2
def test_what_ends_before_it_is_seen_is_not_taken_for_something_else(live: dict[str, dict[str, Any]]) -> None:
    record = live["ends_at_once.py"]
    assert record["status"] != "not-a-node"
    assert [problem["detail"] for problem in record["problems"] if problem["code"] == "ended"] == ["it ended by itself with status 0"]

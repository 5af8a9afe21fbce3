"""Nodes that are hard to probe: each ends in its time, with the right diagnosis, and nothing of it is left running."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from tests.probe.odd_nodes import PACKAGE, PROGRAM, install, processes_with, run

LIMIT = 8.0
STOPPING = 5.0
"""Seconds that it takes at most to end what does not want to end."""

# Program → status, what it registers (category and name), and what is wrong with it.
BOUNDS = {"memory": 300 << 20, "disk": 64 << 20, "processes": 12}

# Program → status, what it has (category and name; ``@`` says upon what it appeared), and what is wrong with it.
EXPECTED: Mapping[str, tuple[str, list[str], list[str]]] = {
    "busy_loop.py": ("failed", [], ["busy", "silent"]),
    "crashes_late.py": (
        "ok",
        ["publishers doomed", "subscribers first"],
        ["ended: it was ended by signal 11 when it was sent empty messages"],
    ),
    "crashes_politely.py": ("ok", ["publishers before"], ["exception: IndexError: list index out of range"]),
    "daemon.py": ("ok", ["publishers from_the_dark"], []),
    "endless_names.py": ("failed", [], ["too-many-names"]),
    "endless_output.py": ("failed", [], ["too-much-output"]),
    "ends_after_advertising.py": ("ok", ["publishers brief"], ["ended: it ended by itself with status 0"]),
    "few_digits.py": ("ok", ["publishers cell_{any}/state", "publishers log_{any}", "publishers {any}_pose"], []),
    "fills_tmp.py": (
        "ok",
        ["publishers filling"],
        ["exception: OSError: [Errno 27] File too large", "ended: it ended by itself with status 1"],
    ),
    "forks.py": ("ok", ["publishers many"], []),
    "forks_without_end.py": ("ok", ["publishers parent"], ["too-many-processes: it had more than 12 processes"]),
    "hidden_daemon.py": ("ok", ["publishers visible"], []),
    "hostile_names.py": (
        "ok",
        [
            "clients /\u202egnorw",
            "params ~\x9bbell",
            "publishers /$(touch owned)",
            "publishers /-rf",
            "publishers /../../etc/passwd",
            "publishers /brace{{any}}",
            "publishers /good",
            "publishers /new\nline",
            "publishers /odd_type",
            "publishers /two words",
        ],
        ["device-missing: could not open port /dev/x"],
    ),
    "ignores_signals.py": ("ok", ["publishers stubborn"], []),
    "late_topics.py": ("ok", ["params ~delay", "publishers late"], []),
    "logs_error.py": ("ok", ["publishers state"], ["error-logged: calibration is not valid, cameras are off"]),
    "needs_robot.py": ("ok", ["params robot_description", "publishers joint_states"], []),
    "own_name.py": ("ok", ["publishers /robots/{any}/{node}/pose", "publishers {node}_debug", "publishers ~own"], []),
    "random_names.py": (
        "ok",
        [
            "publishers /worker_{any}",
            "publishers id_{any}/pose",
            "publishers session_{any}/status",
            "publishers steady",
            "subscribers camera_2021/image",
        ],
        [],
    ),
    "refuses_arguments.py": ("ok", ["publishers stubborn_name"], []),
    "retries_for_ever.py": ("ok", ["publishers state"], ["waits: retrying in 1 s"]),
    "slow_import.py": ("ok", ["publishers slow"], []),
    "very_slow_import.py": ("failed", [], ["silent: it never contacted the master"]),
    "waits_for_action.py": ("ok", ["actions move", "publishers arrived"], []),
    "waits_for_clock.py": ("ok", ["publishers timed"], []),
    "waits_for_device.py": ("failed", [], ["device-missing: could not open port /dev/ttyUSB_robot: No such file or directory", "silent"]),
    "waits_for_message.py": ("ok", ["publishers answer @message", "subscribers first"], []),
    "waits_for_odd_message.py": ("ok", ["subscribers strange"], ["waits-for-message: strange"]),
    "waits_for_odd_service.py": ("ok", ["clients odd/call", "publishers state"], ["waits-for-service: odd/call"]),
    "waits_for_param.py": ("ok", ["params mission/id", "publishers state"], ["waits-for-param: mission/id"]),
    "waits_for_service.py": ("ok", ["clients map/load", "publishers loaded"], []),
    "wants_args.py": ("failed", [], ["arguments-required: Usage: wants_args INPUT OUTPUT"]),
    "wants_memory.py": ("ok", ["publishers hungry"], ["too-much-memory: it took more than 300 MiB of memory"]),
}


@pytest.fixture(scope="module")
def records(tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, Any]]:
    prefix = install(tmp_path_factory.mktemp("odd"))
    found = run({"prefixes": [str(prefix)], "packages": [PACKAGE], "limits": {"quiet": 0.7, "limit": LIMIT, "jobs": 6, **BOUNDS}})
    assert found[-1] == {"kind": "end", "left": 0}
    assert processes_with(str(prefix)) == []
    return {record["name"]: record for record in found if record["kind"] == "node"}


def test_every_program_was_run(records: dict[str, dict[str, Any]]) -> None:
    assert sorted(records) == sorted(EXPECTED)


@pytest.mark.parametrize("name", EXPECTED)
def test_diagnosis(name: str, records: dict[str, dict[str, Any]]) -> None:
    record = records[name]
    status, names, problems = EXPECTED[name]
    registered = sorted(
        f"{category} {entry['name']}" + (f" @{entry['when']}" if "when" in entry else "")
        for category, entries in record["interface"].items()
        for entry in entries
    )
    said = [f"{problem['code']}: {problem['detail']}" for problem in record["problems"]]
    assert (record["status"], registered) == (status, names)
    assert len(said) == len(problems), said
    assert all(whole.startswith(begin) for whole, begin in zip(said, problems, strict=True)), said
    assert record["seconds"] < (LIMIT + STOPPING) * 2  # each is run twice


def test_a_long_import_is_no_sign_that_there_is_nothing(tmp_path: Path) -> None:
    prefix = install(tmp_path / "prefix", ["very_slow_import.py"])
    record = next(
        record
        for record in run({"prefixes": [str(prefix)], "packages": [PACKAGE], "limits": {"quiet": 0.5, "limit": 60}})
        if record["kind"] == "node"
    )
    assert (record["status"], record["problems"]) == ("ok", [])
    assert record["interface"] == {"publishers": [{"name": "at_last", "type": "std_msgs/String"}]}


def test_types_of_services_are_known_from_their_clients(records: dict[str, dict[str, Any]]) -> None:
    (client,) = records["waits_for_service.py"]["interface"]["clients"]
    assert client == {"name": "map/load", "type": "odd_msgs/Load", "md5": "d49b9423403730888a6ce1fd191c2caf"}


def test_arguments_and_params_are_found_again_in_names(tmp_path: Path) -> None:
    prefix = install(tmp_path / "prefix", ["wants_args.py"])
    job = {
        "prefixes": [str(prefix)],
        "packages": [PACKAGE],
        "nodes": {f"{PACKAGE}/wants_args.py": {"args": "{} camera/{}_raw", "remap": {"unused": "/other"}}},
        "limits": {"quiet": 0.5, "limit": LIMIT},
    }
    record = next(record for record in run(job) if record["kind"] == "node")
    assert record["status"] == "ok"
    assert record["interface"] == {
        "subscribers": [{"name": "{arg:1}", "type": "std_msgs/String"}],
        "publishers": [{"name": "{arg:2}", "type": "std_msgs/String"}],
    }


def test_shards_are_disjoint_and_whole(tmp_path: Path) -> None:
    prefix = install(tmp_path / "prefix", ["wants_args.py", "crashes_politely.py", "waits_for_message.py"])
    job = {"prefixes": [str(prefix)], "packages": [PACKAGE], "limits": {"quiet": 0.3, "limit": 3}}

    def names(**more: Any) -> list[str]:
        return sorted(record["name"] for record in run({**job, **more}) if record["kind"] == "node")

    whole = names()
    parts = [names(shard=[number, 3]) for number in (1, 2, 3)]
    assert whole == ["crashes_politely.py", "waits_for_message.py", "wants_args.py"]
    assert sorted(name for part in parts for name in part) == whole


def test_what_is_done_is_not_done_again(tmp_path: Path) -> None:
    prefix = install(tmp_path / "prefix", ["wants_args.py", "crashes_politely.py"])
    job = {"prefixes": [str(prefix)], "packages": [PACKAGE], "limits": {"quiet": 0.3, "limit": 3}}
    first = {record["name"]: record["hash"] for record in run(job) if record["kind"] == "node"}
    again = [record["name"] for record in run({**job, "done": [first["wants_args.py"]]}) if record["kind"] == "node"]
    assert again == ["crashes_politely.py"]


def test_nothing_goes_on_when_nobody_listens_any_more(tmp_path: Path) -> None:
    prefix = install(tmp_path / "prefix", ["busy_loop.py", "crashes_politely.py", "ignores_signals.py"])
    job = {"prefixes": [str(prefix)], "packages": [PACKAGE], "limits": {"quiet": 0.3, "limit": 300, "jobs": 3}}
    (tmp_path / "tmp").mkdir()
    environment = {**os.environ, "TMPDIR": str(tmp_path / "tmp")}
    process = subprocess.Popen([sys.executable, "-I", str(PROGRAM)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment)
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write(json.dumps(job).encode())
    process.stdin.close()
    process.stdout.readline()
    process.stdout.close()
    assert process.wait(60) == 141
    assert list((tmp_path / "tmp").iterdir()) == []
    assert processes_with(str(prefix)) == []

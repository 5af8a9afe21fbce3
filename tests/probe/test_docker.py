"""A real container: built from a Debian image without a registry, catkin packages in it, nodes run without a network, nothing left
behind.
"""

from __future__ import annotations

import gc
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from launchlint.probe.configuration import Limits
from launchlint.probe.engine import LABEL, Image, connect

pytestmark = pytest.mark.docker

HERE = Path(__file__).resolve().parent
BASE = os.environ.get("LAUNCHLINT_DOCKER_BASE", "debian:bookworm")
NETWORK = os.environ.get("LAUNCHLINT_DOCKER_NETWORK", "host")


def docker(*words: str) -> str:
    return subprocess.run(["docker", *words], capture_output=True, text=True, timeout=120, check=True).stdout.strip()


@pytest.fixture(scope="module", autouse=True)
def _base() -> None:
    if subprocess.run(["docker", "image", "inspect", BASE], capture_output=True, check=False).returncode:
        pytest.skip(f"the engine has no image {BASE} (.ci/run makes one)")


def configuration(directory: Path, text: str = "") -> Path:
    file = directory / "probe.yaml"
    shutil.copytree(HERE / "workspace", directory / "workspace", dirs_exist_ok=True)
    file.write_text(
        f"base: {BASE}\nnetwork: {NETWORK}\nrepositories: [{{path: workspace}}]\nlimits: {{quiet: 0.7, limit: 10, memory: 700m}}\n{text}"
    )
    return file


def command(directory: Path, *words: str, text: str = "") -> list[str]:
    return [sys.executable, "-m", "launchlint", "probe", str(configuration(directory, text)), "-o", str(directory / "library.json"), *words]


NODES = "nodes: {probe_talker/wants_arguments.py: {args: '{}'}}\nlaunch: [probe_talker/launch/talk.launch]\n"


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> tuple[dict[str, Any], str]:
    """The library of the small workspace, and what the command said."""
    directory = tmp_path_factory.mktemp("docker")
    done = subprocess.run(command(directory, "-v", text=NODES), capture_output=True, text=True, timeout=900, check=False)
    assert done.returncode == 1, done.stderr[-5000:]  # a file of one package cannot be compiled
    return json.loads((directory / "library.json").read_text()), done.stderr


def names(variant: dict[str, Any]) -> list[str]:
    categories = ("publishers", "subscribers", "services", "clients", "actions", "params")
    return [f"{category} {entry['name']} {entry.get('type', '')}".strip() for category in categories for entry in variant.get(category, [])]


def test_the_workspace_is_built_and_its_nodes_are_recorded(built: tuple[dict[str, Any], str]) -> None:
    document, _ = built
    packages = document["packages"]
    assert packages["probe_talker"]["build"] == {"result": "ok"}
    assert packages["probe_counter"]["build"]["result"] == "partial"
    assert packages["probe_counter"]["build"]["errors"][0].endswith("was not declared in this scope")
    programs = {name: program for package in packages.values() for name, program in package["executables"].items()}
    assert {name: names(program["variants"]["default"]) for name, program in programs.items()} == {
        "counter": ["publishers ~total std_msgs/Int32", "subscribers reading probe_talker/Reading", "params ~start"],
        "talker.py": [
            "publishers reading probe_talker/Reading",
            "publishers ~state std_msgs/String",
            "subscribers /orders std_msgs/String",
            "services ~reset std_srvs/Trigger",
            "params ~rate",
        ],
        "wants_arguments.py": ["publishers {arg:1} *"],
    }
    reading = document["messages"]["probe_talker/Reading"]
    assert reading["md5"] == "68d16538d80a70e69e20338c58a09ca5"
    assert {
        entry["md5"] for name in ("counter", "talker.py") for entry in _topics(programs[name]) if entry["type"] == "probe_talker/Reading"
    } == {reading["md5"]}


def _topics(program: dict[str, Any]) -> list[dict[str, Any]]:
    variant = program["variants"]["default"]
    return [*variant["publishers"], *variant["subscribers"]]


def test_the_launch_file_is_recorded(built: tuple[dict[str, Any], str]) -> None:
    assert built[0]["packages"]["probe_talker"]["launch"] == [
        {
            "file": "launch/talk.launch",
            "status": "ok",
            "nodes": [
                {
                    "name": "talker",
                    "publishers": [
                        {"name": "reading", "type": "probe_talker/Reading"},
                        {"name": "talker/state", "type": "std_msgs/String"},
                    ],
                    "subscribers": [{"name": "/orders", "type": "std_msgs/String"}],
                    "services": [{"name": "talker/reset"}],
                }
            ],
            "params": ["volume"],
        }
    ]


def test_what_is_missing_is_said(built: tuple[dict[str, Any], str]) -> None:
    assert re.search(r"probe_counter: built in part: .*\n(    .*\n)*    make: \*\*\* ", built[1])
    assert "probe_talker: the dependency no_such_package_anywhere was not installed: apt has no package for it" in built[1]


def test_nothing_is_left_behind(built: tuple[dict[str, Any], str]) -> None:
    assert docker("ps", "-aq", "--filter", f"label={LABEL}") == ""
    assert docker("volume", "ls", "-q", "--filter", f"label={LABEL}") == ""


def test_a_second_run_finds_the_layers_and_the_same_library(built: tuple[dict[str, Any], str], tmp_path: Path) -> None:
    done = subprocess.run(command(tmp_path, "-v", "--jobs", "3", text=NODES), capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 1
    assert "Running in" not in done.stderr.replace("LABEL", "")
    assert json.loads((tmp_path / "library.json").read_text()) == built[0]


def test_ctrl_c_ends_the_container(built: tuple[dict[str, Any], str], tmp_path: Path) -> None:
    words = command(tmp_path, "-q", text="nodes: {probe_counter/counter: {quiet: 50}}\n")
    process = subprocess.Popen(words, stderr=subprocess.PIPE, text=True, preexec_fn=_obey)
    end = time.monotonic() + 120
    while time.monotonic() < end and not docker("ps", "-q", "--filter", f"label={LABEL}"):
        time.sleep(0.1)
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=60)
    assert (process.returncode, said.strip().splitlines()[-1]) == (130, "launchlint: stopped")
    assert docker("ps", "-aq", "--filter", f"label={LABEL}") == ""
    assert docker("volume", "ls", "-q", "--filter", f"label={LABEL}") == ""


def _obey() -> None:
    signal.signal(signal.SIGINT, signal.default_int_handler)


HOSTILE = '''#!/usr/bin/env python3
"""Tries all doors: rospy is what it says it is."""
import json, os, sys

found = {"root": os.getuid() == 0}
found["writes"] = False
for place in ("/launchlint", "/workspace", "/home/launchlint"):
    try:
        open(place + "/owned", "w")
        found["writes"] = True
    except OSError:
        pass
with open("/proc/net/route") as routes:
    found["network"] = len(routes.readlines()) > 1
with open("/proc/self/status") as status:
    lines = dict(line.rstrip().split(":\\t", 1) for line in status if ":\\t" in line)
found["capabilities"] = lines["CapEff"].strip("0") != ""
found["privileges"] = lines["NoNewPrivs"] != "1"
found["mounts"] = os.path.exists("/var/run/docker.sock") or os.path.exists("/work")
print("RuntimeError: open doors: " + ", ".join(sorted(name for name, is_open in found.items() if is_open)))
for _ in range(3):  # what looks like the probe's own words, and what does not
    os.write(1, b"")
    for name in ("/proc/1/fd/1", "/proc/%d/fd/1" % os.getppid()):
        try:
            with open(name, "w") as out:
                out.write("\\x1b]0;owned\\x07 not a record\\n")
                evil = {"kind": "node", "package": "../../evil", "name": "x", "program": "rospy", "variant": "default", "status": "ok"}
                out.write(json.dumps(evil) + "\\n")
        except OSError:
            pass
sys.exit(1)
'''
BOMB = '''#!/usr/bin/env python3
"""Takes all memory there is: rospy is what it says it is."""
held = []
while True:
    held.append(bytearray(64 * 2**20))
'''
FLOOD = '''#!/usr/bin/env python3
"""Ten gigabytes for whoever reads the container's output: rospy is what it says it is."""
import os
out = os.open("/proc/%d/fd/1" % os.getppid(), os.O_WRONLY)
for _ in range(160000):
    os.write(out, b"x" * 65535 + b"\\n")
'''


def test_hostile_nodes_stay_inside(tmp_path: Path, built: tuple[dict[str, Any], str]) -> None:
    package = tmp_path / "src" / "hostile"
    (package / "scripts").mkdir(parents=True)
    (package / "package.xml").write_text("<package format='2'><name>hostile</name><version>1.0.0</version></package>\n")
    for name, text in (("doors.py", HOSTILE), ("memory.py", BOMB), ("flood.py", FLOOD)):
        (package / "scripts" / name).write_text(text)
        (package / "scripts" / name).chmod(0o755)
    config = tmp_path / "probe.yaml"
    config.write_text(f"base: {BASE}\nnetwork: {NETWORK}\nrepositories: [{{path: src}}]\nlimits: {{limit: 20, memory: 300m, jobs: 1}}\n")
    words = [sys.executable, "-m", "launchlint", "probe", str(config), "-o", str(tmp_path / "library.json"), "-v"]
    done = subprocess.run(words, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 1, done.stderr[-3000:]
    assert "\x1b" not in done.stderr
    package_known = json.loads((tmp_path / "library.json").read_text())["packages"]
    assert list(package_known) == ["hostile"]
    programs = package_known["hostile"]["executables"]
    assert {name: program["status"] for name, program in programs.items()} == {
        "doors.py": "failed",
        "flood.py": "failed",
        "memory.py": "failed",
    }
    said = {name: [f"{problem['code']}: {problem['detail']}" for problem in program["problems"]] for name, program in programs.items()}
    assert any("open doors:" in line and line.rstrip().endswith("open doors:") for line in said["doors.py"]), said
    assert said["memory.py"] in (
        ["too-much-memory: it took more than 225 MiB of memory"],
        ["ended: it was ended by signal 9"],
        ["broke-the-container: it wanted more memory than it may have (`memory` in `limits`)"],
    )
    assert said["flood.py"][0].startswith("broke-the-container: it printed "), said
    assert docker("ps", "-aq", "--filter", f"label={LABEL}") == ""


# The SDK leaves the socket of an attached container to the garbage collector.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_a_container_that_never_ends_is_ended() -> None:
    """Its program is not ours, and neither stops at its time nor heeds a signal."""
    stubborn = f'FROM {BASE}\nRUN useradd launchlint\nENTRYPOINT ["/bin/sh", "-c", "trap \'\' TERM INT; while :; do sleep 1; done"]\n'
    words = ["docker", "build", "-q", "--network", NETWORK, "--label", f"{LABEL}=test", "-"]
    name = subprocess.run(words, input=stubborn, capture_output=True, text=True, timeout=120, check=True).stdout.strip()
    engine = connect("never-ends")
    try:
        with engine.container(Image(name, "stubborn"), b"{}", Limits()) as container:
            began = time.monotonic()
            assert list(container.output(2)) == []
            assert container.timed_out
            assert time.monotonic() - began < 30
        assert docker("ps", "-aq", "--filter", f"label={LABEL}=never-ends") == ""
        assert docker("volume", "ls", "-q", "--filter", f"label={LABEL}=never-ends") == ""
    finally:
        engine.close()
        docker("rmi", "-f", name)
        gc.collect()

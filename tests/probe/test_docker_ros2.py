"""A real container with ROS 2: packages of both kinds built, nodes and components run without a network."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

pytestmark = [pytest.mark.docker, pytest.mark.ros2]

HERE = Path(__file__).resolve().parent
VARIABLE = "LAUNCHLINT_DOCKER_ROS2_BASE"
"""Names an image with ROS 2 that the engine has, such as ros:jazzy; none is fetched for a test."""
NETWORK = os.environ.get("LAUNCHLINT_DOCKER_NETWORK", "host")

HOSTILE = '''#!/usr/bin/env python3
"""Tries all doors: rclpy is what it says it is."""
import os

doors = []
for place in ("/launchlint", "/workspace", "/home/launchlint"):
    try:
        open(place + "/owned", "w")
        doors.append(place)
    except OSError:
        pass
if os.getuid() == 0:
    doors.append("root")
with open("/proc/net/route") as routes:
    if len(routes.readlines()) > 1:
        doors.append("network")
print("RuntimeError: open doors: " + ", ".join(doors))
raise SystemExit(1)
'''


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> tuple[dict[str, Any], str]:
    """The library of the small workspace, and what the command said."""
    base = os.environ.get(VARIABLE, "")
    if not base or subprocess.run(["docker", "image", "inspect", base], capture_output=True, check=False).returncode:
        pytest.skip(f"the engine has no image with ROS 2 ({VARIABLE} names one)")
    directory = tmp_path_factory.mktemp("docker")
    shutil.copytree(HERE / "workspace_ros2", directory / "workspace")
    hostile = directory / "workspace" / "probe_teller" / "probe_teller" / "doors.py"
    hostile.write_text(HOSTILE)
    setup = hostile.parent.parent / "setup.py"
    setup.write_text(setup.read_text().replace("    entry_points", '    scripts=["probe_teller/doors.py"],\n    entry_points'))
    file = directory / "probe.yaml"
    file.write_text(f"base: {base}\nnetwork: {NETWORK}\nrepositories: [{{path: workspace}}]\nlimits: {{limit: 20, memory: 1000m}}\n")
    command = [sys.executable, "-m", "launchlint", "probe", str(file), "-o", str(directory / "library.json"), "-v"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=1200, check=False)
    assert done.returncode == 1, done.stderr[-5000:]  # a program of one package cannot be compiled
    return json.loads((directory / "library.json").read_text()), done.stderr


def names(program: dict[str, Any]) -> list[str]:
    variant = program["variants"]["default"]
    categories = ("publishers", "subscribers", "services", "clients", "actions", "params")
    return [f"{category} {entry['name']} {entry['type']}" for category in categories for entry in variant.get(category, [])]


def test_packages_are_built_and_their_nodes_recorded(built: tuple[dict[str, Any], str]) -> None:
    document, _ = built
    packages = document["packages"]
    assert document["version"] == 2
    assert {name: (package["middleware"], package["version"]) for name, package in packages.items()} == {
        "probe_counting": ("ros2", "0.1.0"),
        "probe_teller": ("ros2", "2.1.0"),
    }
    teller = packages["probe_teller"]["executables"]["teller"]
    assert (teller["class"], teller["variants"]["default"]["node"]) == ("rclpy", "teller")
    assert names(teller) == ["publishers ~story std_msgs/msg/String", "subscribers /silence std_msgs/msg/String", "params ~volume integer"]
    assert packages["probe_teller"]["build"] == {"result": "ok"}
    assert packages["probe_counting"]["build"]["result"] == "partial"
    assert packages["probe_counting"]["build"]["errors"][0].endswith("was not declared in this scope")


def test_a_component_is_the_same_in_a_container_and_alone(built: tuple[dict[str, Any], str]) -> None:
    package = built[0]["packages"]["probe_counting"]
    component, alone = package["components"]["probe_counting::Counter"], package["executables"]["count"]
    assert (component["class"], alone["class"]) == ("component", "rclcpp")
    assert names(component) == names(alone) == ["publishers total std_msgs/msg/Int32", "params ~start integer"]
    for program in (component, alone):
        variant = program["variants"]["default"]
        assert variant["node"] == "counter"
        assert "open" not in variant
        qos = variant["publishers"][0]["qos"]
        assert (qos["reliability"], qos["durability"]) == ("reliable", "transient_local")


def test_what_is_missing_is_said(built: tuple[dict[str, Any], str]) -> None:
    assert "probe_teller: the dependency no_such_package_anywhere was not installed: apt has no package for it" in built[1]
    assert "the dependency rclpy" not in built[1]


def test_a_hostile_node_stays_inside(built: tuple[dict[str, Any], str]) -> None:
    program = built[0]["packages"]["probe_teller"]["executables"]["doors.py"]
    assert program["status"] == "failed"
    assert any(problem["detail"].endswith("open doors:") for problem in program["problems"]), program["problems"]

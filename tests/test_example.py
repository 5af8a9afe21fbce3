"""The bundled example is what its page says, in the eyes of the real roslaunch too."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest

TURTLES = Path(__file__).resolve().parent.parent / "examples" / "turtles"
PACKAGE = TURTLES / "turtle_parade"
NODES = "import sys, roslaunch; sys.argv[0] = 'roslaunch'; roslaunch.main()"


def roslaunch_nodes(python: str, name: str, log: Path) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "ROS_PACKAGE_PATH": str(TURTLES), "ROS_LOG_DIR": str(log)}
    command = [python, "-c", NODES, "--nodes", str(PACKAGE / "launch" / name)]
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=60, check=False)


@pytest.mark.ros
def test_roslaunch_refuses_the_broken_parade(ros_python: str, tmp_path: Path) -> None:
    run = roslaunch_nodes(ros_python, "parade_broken.launch", tmp_path)
    assert run.returncode != 0
    assert "multiple nodes named [/sim2]" in run.stdout + run.stderr


@pytest.mark.ros
def test_roslaunch_starts_eight_nodes_in_the_parade(ros_python: str, tmp_path: Path) -> None:
    run = roslaunch_nodes(ros_python, "parade.launch", tmp_path)
    assert run.stdout.split() == [
        "/first/sim1",
        "/first/circle",
        "/second/sim2",
        "/second/square",
        "/third/sim3",
        "/third/line",
        "/fourth/sim4",
        "/fourth/wide_circle",
    ]


def test_every_controller_of_the_parade_is_there_executable_and_installed() -> None:
    installed = (PACKAGE / "CMakeLists.txt").read_text(encoding="utf-8")
    for launch_file in sorted((PACKAGE / "launch").glob("*.launch")):
        for node in ElementTree.parse(launch_file).iter("node"):
            if node.get("pkg") == "turtle_parade":
                script = PACKAGE / "scripts" / str(node.get("type"))
                assert script.read_text(encoding="utf-8").startswith("#!/usr/bin/env python3\n")
                assert os.access(script, os.X_OK)
                assert f"scripts/{script.name}" in installed


def test_scripts_compile() -> None:
    for script in sorted(PACKAGE.rglob("*.py")):
        compile(script.read_text(encoding="utf-8"), str(script), "exec")


def test_the_library_says_what_the_scripts_publish() -> None:
    library = json.loads((PACKAGE / "library.json").read_text(encoding="utf-8"))
    executables = library["packages"]["turtle_parade"]["executables"]
    assert sorted(executables) == sorted(script.name for script in (PACKAGE / "scripts").iterdir())
    for name, program in executables.items():
        (publisher,) = program["variants"]["default"]["publishers"]
        path, line = publisher["evidence"][0]["at"].removeprefix("turtle_parade/").split(":")
        assert path == f"scripts/{name}"
        assert f'"{publisher["name"]}"' in (PACKAGE / path).read_text(encoding="utf-8").splitlines()[int(line) - 1]

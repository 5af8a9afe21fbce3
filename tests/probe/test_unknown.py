"""``launchlint probe --unknown``: what launch files start and nobody knows is probed once, and known to every command from then on."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.probe.odd_nodes import HERE

TALKS = """#!/usr/bin/env python3
# stands for a rospy node
import sys
from wire import Node, spin

words = [word for word in sys.argv[1:] if ":=" not in word]
node = Node()
node.publish(words[0] if words else "state")
spin()
"""
LAUNCH = """<launch>
  <node pkg="demo" type="talk.py" name="one" args="chatter 5"/>
  <node pkg="demo" type="talk.py" name="two" args="chatter 5"/>
  <node pkg="demo" type="tell.py" name="three"/>
  <node pkg="elsewhere" type="node" name="four"/>
</launch>
"""


def script(place: Path, name: str) -> None:
    path = place / "demo" / "scripts" / name
    path.write_text(TALKS)
    path.chmod(0o755)


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """A repository with two programs that nobody knows, and one of a package that is not there."""
    root = tmp_path / "robot"
    (root / ".git").mkdir(parents=True)
    (root / "demo" / "launch").mkdir(parents=True)
    (root / "demo" / "scripts").mkdir()
    (root / "other").mkdir()
    (root / "demo" / "package.xml").write_text("<package><name>demo</name><version>1.0.0</version><depend>other</depend></package>")
    (root / "other" / "package.xml").write_text("<package><name>other</name><version>1.0.0</version></package>")
    (root / "demo" / "launch" / "robot.launch").write_text(LAUNCH)
    (root / ".launchlint.yaml").write_text("extract: false\n")
    shutil.copyfile(HERE / "nodes" / "wire.py", root / "demo" / "scripts" / "wire.py")
    script(root, "talk.py")
    script(root, "tell.py")
    return root


def run(place: Path, *words: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "ROS_DISTRO": "odd", "CMAKE_PREFIX_PATH": "", "ROS_PACKAGE_PATH": ""}
    command = [sys.executable, "-m", "launchlint", *words]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False, cwd=place, env=environment)


def test_what_nobody_knows_is_probed_once(place: Path) -> None:
    before = run(place, "graph", "--dangling", "demo/launch/robot.launch").stdout
    assert "chatter" not in before.replace('args="chatter', "")
    done = run(place, "probe", "--unknown", "--local")
    assert done.returncode == 0, done.stderr
    assert ".launchlint/unknown.yaml: 2 programs that nobody knows\n" in done.stderr
    assert ".launchlint/probed.json: 2 executables recorded, 0 could not be run" in done.stderr
    assert "not probed, since their packages are not in the workspace: elsewhere/node;" in done.stderr
    assert sorted(path.name for path in (place / ".launchlint").iterdir()) == ["probed.json", "unknown.yaml"]
    text = (place / ".launchlint" / "unknown.yaml").read_text()
    assert text[text.index("repositories") :] == (
        "repositories:\n- path: ../demo\n- path: ../other\npackages:\n- demo\nprograms:\n- demo/talk.py\n- demo/tell.py\n"
        "nodes:\n  demo/talk.py:\n    args: '{} 5'\n"
    )
    programs = json.loads((place / ".launchlint" / "probed.json").read_text())["packages"]["demo"]["executables"]
    assert [entry["name"] for entry in programs["talk.py"]["variants"]["default"]["publishers"]] == ["{arg:1}"]
    assert [entry["name"] for entry in programs["tell.py"]["variants"]["default"]["publishers"]] == ["state"]
    after = run(place, "graph", "--dangling", "demo/launch/robot.launch").stdout
    assert "/chatter" in after
    again = run(place, "probe", "--unknown", "--local")
    assert (again.returncode, again.stdout) == (0, "")
    assert again.stderr.startswith("not probed, since their packages")


def test_what_was_probed_earlier_stays_known(place: Path) -> None:
    assert run(place, "probe", "--unknown", "--local", "-q").returncode == 0
    script(place, "third.py")
    launch = place / "demo" / "launch" / "robot.launch"
    launch.write_text(LAUNCH.replace("</launch>", '  <node pkg="demo" type="third.py" name="five"/>\n</launch>'))
    done = run(place, "probe", "--unknown", "--local")
    assert done.returncode == 0, done.stderr
    assert ".launchlint/unknown.yaml: 1 program that" in done.stderr
    programs = json.loads((place / ".launchlint" / "probed.json").read_text())["packages"]["demo"]["executables"]
    assert sorted(programs) == ["talk.py", "tell.py", "third.py"]


def test_a_library_of_the_project_that_cannot_be_read_is_told(place: Path) -> None:
    (place / ".launchlint").mkdir()
    (place / ".launchlint" / "broken.json").write_text("{")
    done = run(place, "check", ".")
    assert done.returncode == 2
    assert ".launchlint/broken.json" in done.stderr


def test_a_link_leads_to_no_library(place: Path, tmp_path: Path) -> None:
    (tmp_path / "secret.json").write_text("{")
    (place / ".launchlint").mkdir()
    (place / ".launchlint" / "secret.json").symlink_to(tmp_path / "secret.json")
    assert run(place, "check", "demo/launch/robot.launch").returncode in (0, 1)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("probe",), "give one CONFIG.yaml"),
        (("probe", "a.yaml", "b.yaml", "-o", "x.json"), "give one CONFIG.yaml"),
        (("probe", "a.yaml"), "-o is missing"),
        (("probe", "--unknown", "nowhere.launch"), "nowhere.launch"),
    ],
)
def test_wrong_command_lines(place: Path, words: tuple[str, ...], said: str) -> None:
    done = run(place, *words)
    assert done.returncode == 2
    assert said in done.stderr


ROS2_LAUNCH = """<launch>
  <node pkg="demo2" exec="talk" name="one" args="chatter"/>
</launch>
"""
ROS2_MANIFEST = (
    "<package format='3'><name>demo2</name><version>1.0.0</version><export><build_type>ament_cmake</build_type></export></package>"
)


def test_what_is_of_ros_2_gets_an_image_of_ros_2(place: Path) -> None:
    (place / "demo2" / "launch").mkdir(parents=True)
    (place / "demo2" / "package.xml").write_text(ROS2_MANIFEST)
    (place / "demo2" / "launch" / "robot.launch.xml").write_text(ROS2_LAUNCH)
    run(place, "probe", "--unknown", "--local", "demo2/launch/robot.launch.xml")
    text = (place / ".launchlint" / "unknown.yaml").read_text()
    assert text[text.index("base") :] == (
        "base: ros:jazzy\nrepositories:\n- path: ../demo2\npackages:\n- demo2\nprograms:\n- demo2/talk\n"
        "nodes:\n  demo2/talk:\n    args: '{}'\n"
    )


def test_two_versions_of_ros_are_not_probed_together(place: Path) -> None:
    (place / "demo2" / "launch").mkdir(parents=True)
    (place / "demo2" / "package.xml").write_text(ROS2_MANIFEST)
    (place / "demo2" / "launch" / "robot.launch.xml").write_text(ROS2_LAUNCH)
    done = run(place, "probe", "--unknown", "--local", "demo2/launch/robot.launch.xml", "demo/launch/robot.launch")
    assert ".launchlint/unknown.yaml: 2 programs that nobody knows\n" in done.stderr
    assert "not probed, since they are of the other version of ROS, which needs another image: demo2/talk\n" in done.stderr

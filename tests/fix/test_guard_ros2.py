"""The guard and launch files of ROS 2: what they describe must stay."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.fix.guard import Guard
from tests.evaluate.ros2.launching import Workspace

BEFORE = '<launch><!-- a --><arg name="x"   default="1"/><group if="false"><node pkg="pk" exec="e" name="n"/></group></launch>'


def refusal(directory: Path, after: str, before: str = BEFORE, name: str = "main.launch.xml") -> str:
    workspace = Workspace(directory, "", {name: before})
    session = workspace.session(environment={"ROS_VERSION": "2"})
    return Guard(session).refusal(str(workspace.launch_files / name), before.encode(), after.encode())


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ('name="x"   default="1"', 'default="1" name="x"', ""),
        ("<!-- a -->", "\n  <!-- b -->\n  ", ""),
        ('default="1"', 'default="2"', "the file would describe something else"),
        ('exec="e"', 'exec="f"', "the file would describe something else"),
        ('if="false"', 'unless="true"', "the file would describe something else"),
        ('exec="e"', 'exce="e"', "ros2 launch would refuse the file for another reason (lacks attribute)"),
    ],
)
def test_xml(tmp_path: Path, old: str, new: str, reason: str) -> None:
    assert refusal(tmp_path, BEFORE.replace(old, new)) == reason


def test_yaml(tmp_path: Path) -> None:
    before = "launch:\n- node: {pkg: pk, exec: e}\n"
    name = "main.launch.yaml"
    assert refusal(tmp_path / "a", "launch:\n  - node:\n      pkg: pk\n      exec: 'e'\n", before, name) == ""
    assert refusal(tmp_path / "b", before.replace("exec: e", "exec: f"), before, name) == "the file would describe something else"
    broken = before.replace("exec", "exce")
    assert refusal(tmp_path / "c", before, broken, name) == "ros2 launch would no longer see one reason to refuse the file"


def test_deep_files_come_to_an_end(tmp_path: Path) -> None:
    deep = f"<launch>{'<group>' * 400}{'</group>' * 400}</launch>"
    assert refusal(tmp_path, deep.replace("<launch>", "<launch> "), deep) == ""

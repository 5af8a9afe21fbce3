"""Repository and catkin workspace around a file."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.repository import catkin_workspace, default_workspaces, repository_root

Grow = Callable[[Mapping[str, str | None]], Path]

TREE = {
    "ws/.catkin_workspace": "",
    "ws/src/robot/.git/HEAD": "",
    "ws/src/robot/p/launch/a.launch": "",
    "ws/src/robot/sub/.git": "gitdir: ../.git/modules/sub",
    "ws/src/robot/sub/b.launch": "",
    "ws/src/loose/c.launch": "",
    "alone/.git/HEAD": "",
    "alone/d.launch": "",
    "linked/src/CMakeLists.txt": "-> /opt/ros/noetic/share/catkin/cmake/toplevel.cmake",
    "linked/src/e.launch": "",
    "plain/src/f.launch": "",
    "packed/robot/package.xml": "<package/>",
    "packed/robot/launch/g.launch": "",
}


@pytest.mark.parametrize(
    ("path", "root", "workspaces"),
    [
        ("ws/src/robot/p/launch/a.launch", "ws/src/robot", ["ws/src/robot", "ws/src"]),
        ("ws/src/robot/p", "ws/src/robot", ["ws/src/robot", "ws/src"]),
        ("ws/src/robot/sub/b.launch", "ws/src/robot/sub", ["ws/src/robot/sub", "ws/src"]),
        ("ws/src/loose/c.launch", "ws", ["ws"]),
        ("alone/d.launch", "alone", ["alone"]),
        ("linked/src/e.launch", "linked", ["linked"]),
        ("plain/src/f.launch", "plain/src", ["plain/src"]),
        ("packed/robot/launch/g.launch", "packed/robot", ["packed/robot"]),
        ("packed", "packed", ["packed"]),
        ("alone/not/there.launch", "alone", ["alone"]),
    ],
)
def test_root_and_workspaces(path: str, root: str, workspaces: list[str], grow: Grow) -> None:
    top = grow(TREE)
    assert os.path.relpath(repository_root(f"{top}/{path}"), top) == root
    assert [os.path.relpath(each, top) for each in default_workspaces([f"{top}/{path}"])] == workspaces


def test_workspaces_of_several_paths_come_once(grow: Grow) -> None:
    top = grow(TREE)
    found = default_workspaces([f"{top}/ws/src/robot/p", f"{top}/alone", f"{top}/ws/src/robot/sub", f"{top}/alone/d.launch"])
    assert [os.path.relpath(each, top) for each in found] == ["ws/src/robot", "ws/src", "alone", "ws/src/robot/sub"]


def test_no_workspace(grow: Grow) -> None:
    assert catkin_workspace(f"{grow(TREE)}/plain/src") is None

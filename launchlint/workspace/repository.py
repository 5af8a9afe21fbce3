"""Where the checked files live: their repository, and the catkin workspace around it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

_MANIFESTS = ("package.xml", "manifest.xml")
LONGEST_PATH = 4_096
"""Characters: nothing on disk has a longer path, while a text that substitutions make may have megabytes, of any depth."""
_WORKSPACE_MARKERS = (".catkin_workspace", ".catkin_tools", ".rosinstall")


def repository_root(path: str) -> str:
    """The directory that a file's or directory's project ends at, absolute.

    That is the nearest directory upward with a ``.git`` (a directory, or the file of a worktree or submodule), else the nearest catkin
    workspace, else the package it lies in, else the directory itself. No program is run.
    """
    path = os.path.abspath(path)
    directory = path if os.path.isdir(path) else os.path.dirname(path)
    for each in _upward(directory):
        if os.path.exists(os.path.join(each, ".git")):
            return each
    workspace = catkin_workspace(directory)
    if workspace is not None:
        return workspace
    return next((each for each in _upward(directory) if any(os.path.isfile(os.path.join(each, name)) for name in _MANIFESTS)), directory)


def catkin_workspace(path: str) -> str | None:
    """The catkin workspace that ``path`` lies in (absolute), by the files that catkin_make, catkin tools and wstool leave; else ``None``.

    A ``src`` directory whose ``CMakeLists.txt`` is catkin's link to its top-level file counts too.
    """
    for each in _upward(os.path.abspath(path)):
        source = os.path.join(each, "src")
        if not os.path.isdir(source):
            continue
        if any(os.path.exists(os.path.join(each, marker)) for marker in _WORKSPACE_MARKERS) or _is_source_space(source):
            return each
    return None


def default_workspaces(paths: Iterable[str]) -> list[str]:
    """Where the packages of the checked ``paths`` are looked for when nobody says so; absolute, each once.

    For each path that is its repository, then, where that lies in the source space of a catkin workspace, the whole source space.
    """
    found: list[str] = []
    for path in paths:
        root = repository_root(path)
        found.append(root)
        workspace = catkin_workspace(root)
        if workspace is not None:
            source = os.path.join(workspace, "src")
            if root == source or root.startswith(source + os.sep):
                found.append(source)
    return list(dict.fromkeys(found))


def _is_source_space(source: str) -> bool:
    top = os.path.join(source, "CMakeLists.txt")
    return os.path.islink(top) and os.path.basename(os.readlink(top)) == "toplevel.cmake"


def _upward(directory: str) -> Iterator[str]:
    if len(directory) > LONGEST_PATH:
        directory = directory[: directory.rfind(os.sep, 0, LONGEST_PATH)] or os.sep
    while True:
        yield directory
        parent = os.path.dirname(directory)
        if parent == directory:
            return
        directory = parent

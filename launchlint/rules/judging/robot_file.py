"""Files that belong to the robot: what lies outside of the workspace where a system keeps its own files."""

from __future__ import annotations

import posixpath
import re

from launchlint.rules.judging.other_file import is_inside
from launchlint.workspace.looking import exists
from launchlint.workspace.packages import Packages

_SYSTEM = re.compile(r"/(?:etc|opt(?!/ros/)|var|usr/local|media|mnt|dev|home|root|workspaces)/")
"""Also where development containers mount what is worked on (containers.dev: workspaceFolder)."""
_ROS = re.compile(r"/opt/ros/[a-z]+(?=/)")
ABSENT_ROS = "it belongs to a distribution of ROS that is not installed here"
INSTALL = "install that, or name the file by its package"
_FEWEST_STEPS = 2
_MOST_STEPS = 12


def is_robots(path: str, packages: Packages, root: str) -> bool:
    """Whether the file at ``path`` (absolute) is one of the machine that the launch file is for: no workspace or package can hold it.

    One whose directory is, but for where it begins, one of what is checked belongs to the machine or image in which that lies there.
    """
    if is_inside(path, (*packages.workspaces, root or "/nowhere")):
        return False
    if _SYSTEM.match(path) is None and not _is_elsewhere_here(path, root):
        return False
    return packages.package_of(path) is None


def is_of_absent_ros(path: str) -> bool:
    """Whether ``path`` lies in the installation of a distribution of ROS that is not installed here: there the file may well be."""
    found = _ROS.match(path)
    return found is not None and not exists(found[0])


def _is_elsewhere_here(path: str, root: str) -> bool:
    """Whether ``path`` leads to a directory of ``root`` where it is looked up from there, and that from another place than ``root``."""
    steps = posixpath.dirname(path).split("/")[1:]
    tails = (steps[start:] for start in range(1, min(len(steps) - _FEWEST_STEPS, _MOST_STEPS) + 1))
    return bool(root) and any(exists(posixpath.join(root, *tail)) for tail in tails)


def is_temporary(path: str, packages: Packages, root: str) -> bool:
    """Whether the file at ``path`` (absolute) lies in `/tmp`, and is not beside what is checked: a program writes it while it runs."""
    parts, own = path.split("/"), root.split("/")
    return parts[1:2] == ["tmp"] and parts[:3] != own[:3] and not is_inside(path, packages.workspaces)


def advice(path: str) -> str:
    """What to do about it."""
    return f"it is a file of the robot: see that {path} is there before this is started"

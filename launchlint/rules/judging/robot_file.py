"""Files that belong to the robot: what lies outside of the workspace where a system keeps its own files."""

from __future__ import annotations

import re

from launchlint.rules.judging.other_file import is_inside
from launchlint.workspace.packages import Packages

_SYSTEM = re.compile(r"/(?:etc|opt(?!/ros/)|var|usr/local|media|mnt|dev|home|root)/")


def is_robots(path: str, packages: Packages, root: str) -> bool:
    """Whether the file at ``path`` (absolute) is one of the machine that the launch file is for: no workspace or package can hold it."""
    if _SYSTEM.match(path) is None or is_inside(path, (*packages.workspaces, root or "/nowhere")):
        return False
    return packages.package_of(path) is None


def advice(path: str) -> str:
    """What to do about it."""
    return f"it is a file of the robot: see that {path} is there before this is started"

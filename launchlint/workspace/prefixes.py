"""Devel and install spaces: where ROS packages lie once they are built or installed.

Facts from catkin.workspace, catkin.find_in_workspaces and ament_index.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence

from launchlint.workspace.looking import is_file

MARKER = ".catkin"
_LARGEST_MARKER = 1 << 16
_BUILT_BY = ("CMakeLists.txt", "setup.py", "Makefile")
"""What builds a package: it is not installed with it."""


class Prefix:
    """One prefix such as ``/opt/ros/noetic`` or ``~/catkin_ws/devel``.

    ``is_catkin`` says that it has a ``.catkin`` marker (catkin searches only those), ``is_ros`` that ROS packages are installed in it.
    """

    __slots__ = ("is_catkin", "is_ros", "path", "share")

    def __init__(self, path: str, is_catkin: bool, is_ros: bool) -> None:
        self.path = path
        self.is_catkin = is_catkin
        self.is_ros = is_ros
        self.share = os.path.join(path, "share")

    def __repr__(self) -> str:
        return f"Prefix({self.path!r})"

    def libexec(self, package: str) -> list[str]:
        """The directories of it that hold executables of ``package``."""
        return [each for sub in ("lib", "libexec") if os.path.exists(each := os.path.join(self.path, sub, package))]

    def sources(self) -> list[str]:
        """The source spaces that a devel space's marker names (catkin.workspace.get_source_paths), absolute."""
        if not self.is_catkin:
            return []
        try:
            with open(os.path.join(self.path, MARKER), encoding="utf-8", errors="surrogateescape") as file:
                listed = file.read(_LARGEST_MARKER)
        except OSError:
            return []
        return list(dict.fromkeys(os.path.abspath(each) for each in listed.split(";") if each.strip() and "\0" not in each))


def prefixes(environment: Mapping[str, str]) -> list[Prefix]:
    """Prefixes named by ``CMAKE_PREFIX_PATH``, then ``/opt/ros/$ROS_DISTRO``; only those that exist, each once."""
    return _existing(environment, ("CMAKE_PREFIX_PATH",))


def ament_prefixes(environment: Mapping[str, str]) -> list[Prefix]:
    """As :func:`prefixes`, for ROS 2: those of ``AMENT_PREFIX_PATH`` first."""
    return _existing(environment, ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH"))


def _existing(environment: Mapping[str, str], variables: Sequence[str]) -> list[Prefix]:
    named = [each for variable in variables for each in environment.get(variable, "").split(os.pathsep) if each]
    distribution = environment.get("ROS_DISTRO", "")
    if distribution and "/" not in distribution and distribution not in (".", ".."):
        named.append(os.path.join("/opt/ros", distribution))
    found: list[Prefix] = []
    for path in dict.fromkeys(os.path.abspath(each) for each in named):
        if os.path.isdir(path):
            is_catkin = os.path.isfile(os.path.join(path, MARKER))
            found.append(Prefix(path, is_catkin, is_catkin or path.startswith("/opt/ros/") or _has_ros(path)))
    return found


def _has_ros(path: str) -> bool:
    """Whether some ``share/ros*`` directory lies below ``path``."""
    try:
        with os.scandir(os.path.join(path, "share")) as scan:
            return any(entry.name.startswith("ros") and entry.is_dir() for entry in scan)
    except OSError:
        return False


def is_installed(package: str) -> bool:
    """Whether the package in this directory is an installed one: it lies in ``PREFIX/share``, without what would build it."""
    if os.path.basename(os.path.dirname(package)) != "share":
        return False
    return not any(is_file(os.path.join(package, name)) for name in _BUILT_BY)

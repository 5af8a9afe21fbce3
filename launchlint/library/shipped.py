"""The library that launchlint ships: one file for each package, read when a launch file uses the package.

``bundled/`` holds those of ROS 1, ``bundled/ros2/`` those of ROS 2: some packages exist in both, and do other things in each.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping

from launchlint.library.terms import TABLES
from launchlint.model import ROS1, ROS2

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

DIRECTORY = os.path.join(os.path.dirname(__file__), "bundled")
ROS2_SHELF = "ros2"
SHELVES = {ROS1: DIRECTORY, ROS2: os.path.join(DIRECTORY, ROS2_SHELF)}
"""Where the packages of each middleware are."""
INDEX = "index.json"
"""Maps each nodelet class (component) whose name does not begin with its package to the package, under the name of the table they are in;
made by ``scripts/bundled_library.py``.
"""
SEPARATORS = {ROS1: "/", ROS2: "::"}
"""What stands behind the package in the name of a nodelet class, of a component."""


def is_in_library(package: str, middleware: str = ROS1) -> bool:
    """Whether the shipped library knows ``package``: then there is such a package, whatever the public index says."""
    return _may_be_a_file(package) and os.path.isfile(os.path.join(SHELVES[middleware], f"{package}.json"))


def _may_be_a_file(package: str) -> bool:
    """Whether a file of the library can bear the name: no path of a hostile launch file's making does."""
    return package.isascii() and package.replace("_", "a").replace("-", "a").isalnum() and f"{package}.json" != INDEX


class Bundled:
    """The shipped library of a middleware. Its files were validated when it was made (a test holds them to it)."""

    def __init__(self, middleware: str = ROS1, directory: str = "") -> None:
        self._directory = directory or SHELVES[middleware]
        self._table = TABLES[middleware][1]
        self._separator = SEPARATORS[middleware]
        self._packages: dict[str, Mapping[str, Any] | None] = {}
        self._index: Mapping[str, str] | None = None

    def package(self, name: str) -> Mapping[str, Any] | None:
        """What is known of a package."""
        if name not in self._packages:
            self._packages[name] = self._read(name)
        return self._packages[name]

    def _read(self, name: str) -> Mapping[str, Any] | None:
        if not _may_be_a_file(name):
            return None
        try:
            with open(os.path.join(self._directory, f"{name}.json"), "rb") as file:
                found: Mapping[str, Any] = json.load(file)["packages"][name]
                return found
        except OSError:  # there is none, or the name is longer than a file's may be
            return None

    def package_of_class(self, name: str) -> str | None:
        """The package that has a nodelet class or component: usually its name begins with the package's."""
        package = name.partition(self._separator)[0]
        known = self.package(package)
        if known is not None and name in known.get(self._table, ()):
            return package
        if self._index is None:
            with open(os.path.join(self._directory, INDEX), "rb") as file:
                self._index = json.load(file)[self._table]
        return self._index.get(name)

    def names(self) -> tuple[str, ...]:
        """The names of all packages, sorted."""
        return tuple(sorted(name[:-5] for name in os.listdir(self._directory) if name.endswith(".json") and name != INDEX))

"""The library that launchlint ships: one file for each package in ``bundled/``, read when a launch file uses the package."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

DIRECTORY = os.path.join(os.path.dirname(__file__), "bundled")
INDEX = "index.json"
"""Maps each nodelet class whose name does not begin with its package to the package; made by ``scripts/bundled_library.py``."""


def is_in_library(package: str) -> bool:
    """Whether the shipped library knows ``package``: then there is such a package, whatever the public index says."""
    return _may_be_a_file(package) and os.path.isfile(os.path.join(DIRECTORY, f"{package}.json"))


def _may_be_a_file(package: str) -> bool:
    """Whether a file of the library can bear the name: no path of a hostile launch file's making does."""
    return package.isascii() and package.replace("_", "a").replace("-", "a").isalnum() and f"{package}.json" != INDEX


class Bundled:
    """The shipped library. Its files were validated when it was made (a test holds them to it)."""

    def __init__(self, directory: str = DIRECTORY) -> None:
        self._directory = directory
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

    def package_of_class(self, nodelet: str) -> str | None:
        """The package that has a nodelet class: usually its name begins with the package's."""
        package = nodelet.partition("/")[0]
        known = self.package(package)
        if known is not None and nodelet in known.get("nodelets", ()):
            return package
        if self._index is None:
            with open(os.path.join(self._directory, INDEX), "rb") as file:
                self._index = json.load(file)["nodelets"]
        return self._index.get(nodelet)

    def names(self) -> tuple[str, ...]:
        """The names of all packages, sorted."""
        return tuple(sorted(name[:-5] for name in os.listdir(self._directory) if name.endswith(".json") and name != INDEX))

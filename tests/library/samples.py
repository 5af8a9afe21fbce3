"""Small libraries and a node's situation, made in a few words."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from launchlint.library.template import UNKNOWN


def library(**packages: Any) -> dict[str, Any]:
    """A library with these packages."""
    return {"format": "launchlint-library", "version": 1, "packages": packages}


def ros2_library(**packages: Any) -> dict[str, Any]:
    """A library of version 2 with these packages of ROS 2."""
    known = {name: {"middleware": "ros2", **package} for name, package in packages.items()}
    return {"format": "launchlint-library", "version": 2, "packages": known}


def executable(**interface: Any) -> dict[str, Any]:
    """An executable with this as its default variant."""
    return {"class": "roscpp", "variants": {"default": interface}}


def one(program: Mapping[str, Any]) -> dict[str, Any]:
    """A library with one executable, demo/node."""
    return library(demo={"executables": {"node": program}})


def publishers(*entries: Mapping[str, Any]) -> dict[str, Any]:
    """A library with one executable that publishes these."""
    return one(executable(publishers=list(entries)))


def evidence(by: str, at: str = "somewhere") -> list[dict[str, str]]:
    """Evidence of one kind."""
    return [{"by": by, "at": at}]


def written(path: Path, document: Any) -> str:
    """The path of a file that holds a library."""
    path.write_text(document if isinstance(document, str) else json.dumps(document), encoding="utf-8")
    return str(path)


class Node:
    """A node as it is started, for templates and conditions. Remapping is by whole names."""

    def __init__(
        self,
        arguments: tuple[Any, ...] = (),
        options: Mapping[str, Any] | None = None,
        params: Mapping[str, Any] | None = None,
        remaps: Mapping[str, str] | None = None,
        node: str = "filter",
    ) -> None:
        self.node = node
        self._arguments = arguments
        self._options = options or {}
        self._params = params or {}
        self._remaps = remaps or {}

    def argument(self, position: int) -> Any:
        try:
            return self._arguments[position - 1 if position > 0 else position]
        except IndexError:
            return None

    def arguments_from(self, position: int) -> Any:
        return UNKNOWN if UNKNOWN in self._arguments else list(self._arguments[position - 1 :])

    def option(self, name: str) -> Any:
        return self._options.get(name)

    def param(self, name: str) -> Any:
        return self._params.get(name)

    def resolved(self, name: str) -> str:
        resolved = name if name.startswith("/") else f"/{self.node}/{name[1:]}" if name.startswith("~") else f"/ns/{name}"
        return self._remaps.get(resolved, resolved)

    def is_remapped(self, name: str) -> bool:
        return self.resolved(name) in self._remaps.values()

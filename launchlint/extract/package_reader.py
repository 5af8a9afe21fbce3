"""The programs of one package: what a reader of any kind of package can do."""

from __future__ import annotations

import os
import re
from abc import ABC, abstractmethod

from launchlint.extract.assembly import Workspace
from launchlint.extract.origin import Origin
from launchlint.extract.task import Skipped, Task
from launchlint.workspace.cmake_targets import CMakeFacts, Target
from launchlint.workspace.looking import read_bytes
from launchlint.workspace.package import Package

_PYTHON = re.compile(rb"#![^\n]*\bpython")


class PackageReader(ABC):
    """The programs of one package. ``python`` is the class that its programs in Python have in a library."""

    python = "rospy"

    def __init__(self, package: Package, origin: Origin, workspace: Workspace) -> None:
        self.package = package
        self.origin = origin
        self.workspace = workspace
        self.parts = workspace.parts(package.name)
        self.cmake: CMakeFacts = self.parts.cmake
        self.tasks: list[Task] = []
        self.skipped: list[Skipped] = []

    @abstractmethod
    def read(self) -> None:
        """Fill ``tasks`` and ``skipped``."""

    @abstractmethod
    def find(self, table: str, name: str) -> None:
        """Fill ``tasks`` or ``skipped`` with the one program of a table that launch files call ``name``."""

    @property
    @abstractmethod
    def complete(self) -> bool:
        """Whether it certainly has no more nodelet classes, or components, than were found; and it has some."""

    def one(self, table: str, name: str) -> Task | Skipped | None:
        """One program by the name that launch files give it, nothing else being read; None where this package has none of that name."""
        self.tasks, self.skipped = [], []
        self.find(table, name)
        if self.tasks:
            return self.tasks[0]
        return self.skipped[0] if self.skipped else None

    def _script(self, name: str, path: str, entry: str = "") -> bool:
        if not self.workspace.may_read(path, self.origin.root) or not os.path.isfile(path):
            return False
        begin = _begin(path)
        if not (_PYTHON.match(begin) or (path.endswith(".py") and not begin.startswith(b"#!"))):
            if begin.startswith(b"#!"):
                self.skipped.append(Skipped(self.package.name, name, self._shown(path), "it is a script, but not Python"))
            return False
        self.tasks.append(self._task("executables", name, self.python, (path,))._replace(entry=entry))
        return True

    def _cpp(self, kind: str, name: str, client: str, target: Target, entry: str, shown: str) -> None:
        made = self.workspace.assemble(self.package.name, target, self.origin.root, entry)
        if not made.sources:
            self.skipped.append(Skipped(self.package.name, shown, self._shown(self.package.directory), "its source files are not here"))
            return
        task = self._task(kind, name, client, made.sources)
        self.tasks.append(
            task._replace(
                entry=entry,
                includes=made.includes,
                plugins=made.plugins,
                doubts=made.doubts,
                templates=made.templates,
                packages=made.packages,
                parameters=made.parameters,
            )
        )

    def _task(self, kind: str, name: str, client: str, sources: tuple[str, ...]) -> Task:
        return Task(self.package.name, self.package.directory, kind, name, client, sources, "", (), self.origin, ())

    def _shown(self, path: str) -> str:
        return os.path.relpath(path, self.origin.root).replace(os.sep, "/")


def _begin(path: str) -> bytes:
    try:
        return read_bytes(path, 4 << 20)[:200]
    except OSError:
        return b""

"""The programs of a package of ROS 1."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterable

from launchlint.extract.assembly import Workspace, has_main
from launchlint.extract.origin import Origin
from launchlint.extract.package_reader import PackageReader
from launchlint.extract.task import Skipped
from launchlint.workspace.cmake_targets import Target
from launchlint.workspace.executables import Executables, executables
from launchlint.workspace.looking import read_bytes
from launchlint.workspace.nodelets import NodeletClass
from launchlint.workspace.package import Package

_NO_PROGRAMS = ("setup.py", "conf.py", "__init__.py")


class CatkinPackage(PackageReader):
    """Executables, scripts and nodelets."""

    def __init__(self, package: Package, origin: Origin, workspace: Workspace) -> None:
        super().__init__(package, origin, workspace)
        self.programs: Executables = executables(package)

    @property
    def complete(self) -> bool:
        """Whether all nodelet classes are known, and there are some."""
        return not self.programs.nodelet_reasons and bool(self.programs.nodelet_classes)

    def read(self) -> None:
        """Fill ``tasks`` and ``skipped``."""
        done: set[str] = set()
        for name, path in self._scripts():
            if name not in done and name.isprintable() and self._script(name, path):
                done.add(name)
        for target_name, target in sorted(self.cmake.targets.items()):
            how = self.cmake.executables.get(target.output, "")
            is_program = has_main(target) if target.assumed else not target.is_library and "gtest" not in how and "gmock" not in how
            if is_program and target.output not in done:
                done.add(target.output)
                self._executable(target_name, target)
        for class_name, described in self.programs.nodelet_classes.items():
            if "odelet" in described.base or not described.base:
                self._nodelet(class_name, described)

    def find(self, table: str, name: str) -> None:
        """As said there. A script that lacks the executable bit is read like any other: that it cannot be started yet is told elsewhere."""
        if table == "nodelets":
            described = self.programs.nodelet_classes.get(name)
            if described is not None and ("odelet" in described.base or not described.base):
                self._nodelet(name, described)
        elif not any(each == name and self._script(each, path) for each, path in self._scripts()):
            for target_name, target in sorted(self.cmake.targets.items()):
                if target.output == name and (has_main(target) if target.assumed else not target.is_library):
                    self._executable(target_name, target)
                    break
            else:
                flaw = self.programs.flaw(name)
                if flaw is not None:
                    self._script(name, flaw.path)

    def _scripts(self) -> Iterable[tuple[str, str]]:
        """Name and file of everything that is installed to be run, or has the executable bit."""
        yield from sorted(self.cmake.programs.items())
        yield from ((os.path.basename(path), path) for path in _setup_scripts(self.package.directory))
        for name, program in self.programs.by_name.items():
            if program.path is not None and name not in _NO_PROGRAMS and not name.endswith(".cfg"):
                yield name, program.path

    def _executable(self, name: str, target: Target) -> None:
        self._cpp("executables", target.output, "roscpp", target, "", target.output)

    def _nodelet(self, name: str, described: NodeletClass) -> None:
        target = self.parts.library(described.library)
        if target is None:
            reason = f"no target of its CMakeLists.txt makes the library {described.library.rpartition('/')[2] or 'it is in'}"
            self.skipped.append(Skipped(self.package.name, name, self._shown(described.path), reason))
            return
        self._cpp("nodelets", name, "nodelet", target, described.type or name.replace("/", "::"), name)


def _setup_scripts(directory: str) -> list[str]:
    """Files that ``setup.py`` installs as programs: ``scripts=['bin/x']``."""
    try:
        tree = ast.parse(read_bytes(os.path.join(directory, "setup.py")))
    except (OSError, SyntaxError, ValueError, RecursionError, MemoryError):
        return []
    found: list[str] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.keyword):
            key, value = node.arg, node.value
        elif (
            isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Subscript) and isinstance(node.targets[0].slice, ast.Constant)
        ):
            key, value = str(node.targets[0].slice.value), node.value
        else:
            continue
        if key == "scripts" and isinstance(value, (ast.List, ast.Tuple)):
            found += [each.value for each in value.elts if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    return [os.path.normpath(os.path.join(directory, each)) for each in found[:500] if "\0" not in each]

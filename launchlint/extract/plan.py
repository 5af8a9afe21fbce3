"""Which programs there are in packages, and which files each of them is made of."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from launchlint.errors import UsageError
from launchlint.extract.assembly import Workspace, has_main
from launchlint.extract.fact import Plugin
from launchlint.extract.origin import Origin, origin_of
from launchlint.extract.template import Template
from launchlint.spelling import did_you_mean
from launchlint.workspace.cmake_targets import CMakeFacts, Target
from launchlint.workspace.executables import Executables, executables
from launchlint.workspace.looking import read_bytes
from launchlint.workspace.nodelets import NodeletClass
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages

_PYTHON = re.compile(rb"#![^\n]*\bpython")
_NO_PROGRAMS = ("setup.py", "conf.py", "__init__.py")


class Task(NamedTuple):
    """One program to be read: what a worker needs to know of it.

    ``plugins`` are the classes that it can load and whose sources are among its own; ``templates`` are those of its sources that the build
    fills in; ``packages`` those that its package depends on, and that are not here.
    """

    package: str
    directory: str
    kind: str
    name: str
    client: str
    sources: tuple[str, ...]
    entry: str
    includes: tuple[str, ...]
    origin: Origin
    doubts: tuple[str, ...]
    plugins: tuple[Plugin, ...] = ()
    templates: tuple[Template, ...] = ()
    packages: tuple[str, ...] = ()


class Skipped(NamedTuple):
    """A program that is not read, and why. ``path`` is relative to the origin."""

    package: str
    name: str
    path: str
    reason: str


class Plan(NamedTuple):
    """What is to be read. ``complete`` are packages of which all nodelet classes are known; ``modules`` maps directories to packages."""

    tasks: tuple[Task, ...]
    skipped: tuple[Skipped, ...]
    origins: tuple[Origin, ...]
    complete: frozenset[str]
    modules: dict[str, str]


def plan(sources: Sequence[str], wanted: Sequence[str] = ()) -> Plan:
    """The programs of the packages in directories, or of those that are ``wanted`` by name.

    Raises:
        UsageError: there is no such directory or package.
    """
    packages = _packages(sources)
    names = {package.name for package, _ in packages}
    for each in wanted:
        if each not in names:
            hint = did_you_mean(each, names) or f"there are {len(names)} packages: {', '.join(sorted(names)[:10])}"
            raise UsageError(f"--package {each}: there is no such package in these sources; {hint}")
    tasks: list[Task] = []
    skipped: list[Skipped] = []
    origins: dict[Origin, None] = {}
    complete: set[str] = set()
    workspace = Workspace(package for package, _ in packages)
    for package, given in packages:
        if package.broken:
            skipped.append(Skipped(package.name, "", package.manifest_path, f"the package cannot be read: {package.broken}"))
        elif not package.is_metapackage and (not wanted or package.name in wanted):
            reader = PackageReader(package, origin_of(package.directory, given), workspace)
            reader.read()
            origins[reader.origin] = None
            tasks += reader.tasks
            skipped += reader.skipped
            if not reader.programs.nodelet_reasons and reader.programs.nodelet_classes:
                complete.add(package.name)
    modules = {package.directory: package.name for package, _ in packages if not package.broken}
    return Plan(tuple(tasks), tuple(skipped), tuple(origins), frozenset(complete), modules)


def _packages(sources: Sequence[str]) -> list[tuple[Package, str]]:
    found: dict[str, tuple[Package, str]] = {}
    for source in sources:
        if not os.path.isdir(source):
            reason = "it is a file; give the directory of a package or workspace" if os.path.exists(source) else "it does not exist"
            raise UsageError(f"cannot read sources from {source!r}: {reason}")
        packages = Packages([source], {}, explicit=True)
        listed = packages.places[0].everything
        if not listed:
            around = packages.package_of(source)
            listed = [] if around is None else [around]
        if not listed:
            raise UsageError(f"there is no package in {source!r}: no package.xml was found in it or below it")
        for package in listed:
            found.setdefault(os.path.realpath(package.directory), (package, source))
    seen: set[str] = set()
    first: list[tuple[Package, str]] = []
    for package, given in found.values():
        if package.broken or package.name not in seen:
            first.append((package, given))
        seen.add(package.name)
    return first


class PackageReader:
    """The programs of one package."""

    def __init__(self, package: Package, origin: Origin, workspace: Workspace) -> None:
        self.package = package
        self.origin = origin
        self.programs: Executables = executables(package)
        self.workspace = workspace
        self.parts = workspace.parts(package.name)
        self.cmake: CMakeFacts = self.parts.cmake
        self.tasks: list[Task] = []
        self.skipped: list[Skipped] = []

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

    def one(self, table: str, name: str) -> Task | Skipped | None:
        """One program by the name that launch files give it, nothing else being read; None where this package has none of that name.

        A script that lacks the executable bit is read like any other: that it cannot be started yet is told elsewhere.
        """
        self.tasks, self.skipped = [], []
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
        if self.tasks:
            return self.tasks[0]
        return self.skipped[0] if self.skipped else None

    def _scripts(self) -> Iterable[tuple[str, str]]:
        """Name and file of everything that is installed to be run, or has the executable bit."""
        yield from sorted(self.cmake.programs.items())
        yield from ((os.path.basename(path), path) for path in _setup_scripts(self.package.directory))
        for name, program in self.programs.by_name.items():
            if program.path is not None and name not in _NO_PROGRAMS and not name.endswith(".cfg"):
                yield name, program.path

    def _script(self, name: str, path: str) -> bool:
        if not self.workspace.may_read(path, self.origin.root) or not os.path.isfile(path):
            return False
        begin = _begin(path)
        if not (_PYTHON.match(begin) or (path.endswith(".py") and not begin.startswith(b"#!"))):
            if begin.startswith(b"#!"):
                self.skipped.append(Skipped(self.package.name, name, self._shown(path), "it is a script, but not Python"))
            return False
        self.tasks.append(self._task("executables", name, "rospy", (path,)))
        return True

    def _executable(self, name: str, target: Target) -> None:
        self._cpp("executables", target.output, "roscpp", target, "", target.output)

    def _nodelet(self, name: str, described: NodeletClass) -> None:
        target = self.parts.library(described.library)
        if target is None:
            reason = f"no target of its CMakeLists.txt makes the library {described.library.rpartition('/')[2] or 'it is in'}"
            self.skipped.append(Skipped(self.package.name, name, self._shown(described.path), reason))
            return
        self._cpp("nodelets", name, "nodelet", target, described.type or name.replace("/", "::"), name)

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

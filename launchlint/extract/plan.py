"""Which programs there are in packages, and which files each of them is made of."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import NamedTuple

from launchlint.errors import UsageError
from launchlint.extract.origin import Origin, origin_of
from launchlint.spelling import did_you_mean
from launchlint.workspace.cmake_facts import CMakeFacts, Target, read_cmake
from launchlint.workspace.executables import Executables, executables
from launchlint.workspace.nodelets import NodeletClass
from launchlint.workspace.packages import Package, Packages
from launchlint.workspace.reading import read_bytes

CPP_ENDINGS = (".cpp", ".cc", ".cxx", ".c++", ".C", ".cu")
MOST_SOURCES = 400
"""Files of one C++ program."""

_PYTHON = re.compile(rb"#![^\n]*\bpython")
_LOADER = re.compile(r"\bnodelet::Loader\s+\w+\s*(?:;|\(\s*(?:true)?\s*\)|\{\s*\})")
_LOAD = re.compile(r"(?:\.|->)load\s*\(\s*(ros::this_node::getName\(\)|\w+)\s*,\s*(?:\"([\w/]+)\"|(\w+))\s*,")
_OWN_NAME = re.compile(r"\b(\w+)\s*(?:=|\()\s*ros::this_node::getName\(\)")
_STRING = re.compile(r"\bstring\s+(\w+)\s*(?:=|\()\s*\"([\w/]+)\"")
_INCLUDED = re.compile(r"^[ \t]*#[ \t]*include[ \t]*[<\"](\w+)/", re.MULTILINE)
_NO_PROGRAMS = ("setup.py", "conf.py", "__init__.py")


class Task(NamedTuple):
    """One program to be read: what a worker needs to know of it.

    ``loads`` are the nodelets that a program loads into itself under its own name, ``loader`` the place where it makes the nodelet::Loader.
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
    loads: tuple[Task, ...] = ()
    loader: tuple[str, int] = ("", 0)


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
    directories = {package.name: package for package, _ in packages}
    for package, given in packages:
        if package.broken:
            skipped.append(Skipped(package.name, "", package.manifest_path, f"the package cannot be read: {package.broken}"))
        elif not package.is_metapackage and (not wanted or package.name in wanted):
            reader = _Reader(package, origin_of(package.directory, given), directories)
            reader.read()
            origins[reader.origin] = None
            tasks += reader.tasks
            skipped += reader.skipped
            if not reader.programs.nodelet_reasons and reader.programs.nodelet_classes:
                complete.add(package.name)
    nodelets = {task.name: task for task in tasks if task.kind == "nodelets"}
    tasks = [_with_loaded(task, nodelets) if task.client == "roscpp" else task for task in tasks]
    modules = {package.directory: package.name for package, _ in packages if not package.broken}
    return Plan(tuple(tasks), tuple(skipped), tuple(origins), frozenset(complete), modules)


def _with_loaded(task: Task, nodelets: dict[str, Task]) -> Task:
    """A program that is nothing but a frame for nodelets gets their names: they are loaded under its own name, with its remappings."""
    for path in task.sources:
        text = _text(path)
        made = _LOADER.search(text)
        if made is None:
            continue
        loads = _LOAD.findall(text)
        own = set(_OWN_NAME.findall(text))
        strings = dict(_STRING.findall(text))
        classes = [literal or strings.get(variable, "") for _, literal, variable in loads]
        named = all(name.startswith("ros::this_node") or name in own for name, _, _ in loads)
        if not loads or not named or not all(each in nodelets for each in classes):
            return task
        line = text.count("\n", 0, made.start()) + 1
        shown = os.path.relpath(path, task.origin.root).replace(os.sep, "/")
        return task._replace(loads=tuple(nodelets[each] for each in dict.fromkeys(classes)), loader=(shown, line))
    return task


def _text(path: str) -> str:
    try:
        return read_bytes(path).decode("utf-8", "replace")
    except OSError:
        return ""


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


class _Reader:
    """The programs of one package."""

    def __init__(self, package: Package, origin: Origin, packages: dict[str, Package]) -> None:
        self.package = package
        self.origin = origin
        self.programs: Executables = executables(package)
        self.files = _files(package.directory)
        self.cmake: CMakeFacts = read_cmake(package.directory, lambda: self.files)
        self.tasks: list[Task] = []
        self.skipped: list[Skipped] = []
        self._packages = packages
        self._includes: tuple[str, ...] | None = None

    def read(self) -> None:
        """Fill ``tasks`` and ``skipped``."""
        done: set[str] = set()
        for name, path in self._scripts():
            if name not in done and name.isprintable() and self._script(name, path):
                done.add(name)
        by_output = {target.output: target for target in self.cmake.targets.values() if target.is_library}
        for target_name, target in sorted(self.cmake.targets.items()):
            how = self.cmake.executables.get(target.output, "")
            if not target.is_library and target.output not in done and "gtest" not in how and "gmock" not in how:
                done.add(target.output)
                self._executable(target_name, target)
        for class_name, described in self.programs.nodelet_classes.items():
            if "odelet" in described.base or not described.base:
                self._nodelet(class_name, described, by_output)

    def _scripts(self) -> Iterable[tuple[str, str]]:
        """Name and file of everything that is installed to be run, or has the executable bit."""
        yield from sorted(self.cmake.programs.items())
        yield from ((os.path.basename(path), path) for path in _setup_scripts(self.package.directory))
        for name, program in self.programs.by_name.items():
            if program.path is not None and name not in _NO_PROGRAMS and not name.endswith(".cfg"):
                yield name, program.path

    def _script(self, name: str, path: str) -> bool:
        if not os.path.realpath(path).startswith(os.path.realpath(self.origin.root) + os.sep) or not os.path.isfile(path):
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

    def _nodelet(self, name: str, described: NodeletClass, by_output: dict[str, Target]) -> None:
        library = described.library.rpartition("/")[2]
        target = by_output.get(library) or by_output.get(library.removeprefix("lib")) or by_output.get(library.removesuffix(".so"))
        if target is None:
            reason = f"no target of its CMakeLists.txt makes the library {library or 'it is in'}"
            self.skipped.append(Skipped(self.package.name, name, self._shown(described.path), reason))
            return
        self._cpp("nodelets", name, "nodelet", target, described.type or name.replace("/", "::"), name)

    def _cpp(self, kind: str, name: str, client: str, target: Target, entry: str, shown: str) -> None:
        sources, doubts = self._sources(target)
        if not sources:
            self.skipped.append(Skipped(self.package.name, shown, self._shown(self.package.directory), "its source files are not here"))
            return
        task = self._task(kind, name, client, sources)
        self.tasks.append(task._replace(entry=entry, includes=self._include_directories(), doubts=doubts))

    def _task(self, kind: str, name: str, client: str, sources: tuple[str, ...]) -> Task:
        return Task(self.package.name, self.package.directory, kind, name, client, sources, "", (), self.origin, ())

    def _sources(self, target: Target) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """The C++ files of a target and of the libraries of this package that are linked to it, and why there may be more."""
        sources: dict[str, None] = {}
        doubts: dict[str, None] = {}
        pending, seen = [target], {id(target)}
        while pending and len(sources) < MOST_SOURCES:
            each = pending.pop(0)
            if not each.complete:
                doubts[f"not all sources of {each.output} are known"] = None
            for path in each.sources:
                if path.endswith(CPP_ENDINGS) and os.path.isfile(path) and self._inside(path):
                    sources[path] = None
            for library in each.libraries:
                inner = self.cmake.targets.get(library)
                if inner is not None and id(inner) not in seen:
                    seen.add(id(inner))
                    pending.append(inner)
        self._add_dependencies(sources)
        return tuple(sources), tuple(doubts)

    def _add_dependencies(self, sources: dict[str, None]) -> None:
        """Sources of the libraries of other packages, where their headers are included."""
        pending, seen = list(sources), {self.package.name}
        while pending and len(sources) < MOST_SOURCES:
            path = pending.pop(0)
            for name in dict.fromkeys(_INCLUDED.findall(_text(path))):
                if name in seen or name not in self._packages:
                    continue
                seen.add(name)
                for each in library_sources(self._packages[name].directory):
                    if self._inside(each) and each not in sources and len(sources) < MOST_SOURCES:
                        sources[each] = None
                        pending.append(each)

    def _include_directories(self) -> tuple[str, ...]:
        """Where headers are: of this package, and of those it depends on that are among the sources."""
        if self._includes is None:
            found = {each: None for each in self.cmake.include_directories if os.path.isdir(each)}
            pending, seen = [self.package], {self.package.name}
            while pending:
                package = pending.pop(0)
                for below in ("include", "src") if package is self.package else ("include",):
                    path = os.path.join(package.directory, below)
                    if os.path.isdir(path):
                        found[path] = None
                for name in sorted(package.manifest.depends()) if package.manifest is not None else ():
                    if name in self._packages and name not in seen:
                        seen.add(name)
                        pending.append(self._packages[name])
            self._includes = tuple(found)
        return self._includes

    def _inside(self, path: str) -> bool:
        return os.path.realpath(path).startswith(os.path.realpath(self.origin.root) + os.sep)

    def _shown(self, path: str) -> str:
        return os.path.relpath(path, self.origin.root).replace(os.sep, "/")


@lru_cache(maxsize=1024)
def library_sources(directory: str) -> tuple[str, ...]:
    """The C++ files of the libraries that a package offers to others: all but nodelets."""
    cmake = read_cmake(directory, lambda: _files(directory))
    libraries = [target for target in cmake.targets.values() if target.is_library and "nodelet" not in target.output]
    paths = (path for target in libraries for path in target.sources)
    return tuple(dict.fromkeys(path for path in paths if path.endswith(CPP_ENDINGS) and os.path.isfile(path)))


def _files(directory: str) -> list[str]:
    """All files of a package relative to it, for ``file(GLOB)``; hidden directories and links to directories are left out."""
    found: list[str] = []
    for here, directories, files in os.walk(directory):
        directories[:] = sorted(each for each in directories if not each.startswith("."))
        relative = os.path.relpath(here, directory)
        found += [each if relative == "." else f"{relative}/{each}" for each in sorted(files)]
        if len(found) > 20_000:
            break
    return found


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

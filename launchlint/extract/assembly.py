"""Which files a C++ program is made of: its own sources, those of libraries whose headers it includes, and those of plugins it can load.

A library of another package is linked through ``${catkin_LIBRARIES}``, which names nothing: what says that it is used is a header of that
package among the included ones. Of its library sources those are taken that include the header, too.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from typing import NamedTuple

from launchlint.extract.fact import Plugin
from launchlint.extract.template import Template, filled, template_of
from launchlint.workspace import looking
from launchlint.workspace.cmake_exports import Exported, exported_commands
from launchlint.workspace.cmake_facts import read_cmake
from launchlint.workspace.cmake_targets import CMakeFacts, Target
from launchlint.workspace.nodelets import NodeletClass, plugin_classes
from launchlint.workspace.packages import Package

CPP_ENDINGS = (".cpp", ".cc", ".cxx", ".c++", ".C", ".cu")
MOST_SOURCES = 400
"""Source files of one C++ program."""
_MOST_SCANNED = 1_500
_MOST_DESCRIPTIONS = 50

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n\0]{1,300})[>"]', re.MULTILINE)
_QUOTED = re.compile(r'"([\w:/]{3,200})"')
_EXPORTED = re.compile(r"<\w+\s[^>]*?\bplugin\s*=\s*[\"']([^\"'\n\0]{1,300})[\"']")
_LOADER = re.compile(r"\bnodelet::Loader\b")
_MAIN = re.compile(r"^[ \t]*int[ \t\n]+main[ \t\n]*\(", re.MULTILINE)
_CLASS_LOADER = re.compile(r"\bClassLoader\s*<")


class Assembled(NamedTuple):
    """The files of a program and which are templates, where their headers are, the plugins it can load, and why there may be more.

    ``packages`` are those that the packages of its files depend on, and that are not here.
    """

    sources: tuple[str, ...]
    templates: tuple[Template, ...]
    includes: tuple[str, ...]
    plugins: tuple[Plugin, ...]
    doubts: tuple[str, ...]
    packages: tuple[str, ...]


class Parts:
    """What one package builds: its targets, plugin descriptions, and directories with headers."""

    def __init__(self, package: Package, exported: Callable[[str], Exported | None]) -> None:
        self.package = package
        looking.note_tree(package.directory)
        looking.note((os.path.abspath(package.manifest_path),))
        self.cmake: CMakeFacts = read_cmake(package.directory, lambda: files_below(package.directory), exported)
        self.by_output = {target.output: target for target in self.cmake.targets.values() if target.is_library}
        self.own_includes = tuple(each for each in self.cmake.include_directories if os.path.isdir(each))
        self._libraries: tuple[str, ...] | None = None

    @property
    def library_sources(self) -> tuple[str, ...]:
        """The C++ files of the libraries that it offers to others: all but nodelets."""
        if self._libraries is None:
            libraries = (target for target in self.cmake.targets.values() if target.is_library and "nodelet" not in target.output)
            self._libraries = tuple(dict.fromkeys(path for target in libraries for path in cpp_sources(target)))
        return self._libraries

    def library(self, name: str) -> Target | None:
        """The target that makes a library, by the path in a plugin description: ``lib/libfoo``, ``foo.so``."""
        last = name.rpartition("/")[2].removesuffix(".so")
        return self.by_output.get(last) or self.by_output.get(last.removeprefix("lib"))


class Workspace:
    """The packages in the given directories, with what each of them builds.

    ``limits``: no source outside of these directories is read; by default none outside of the root of the program that is put together.
    """

    def __init__(self, packages: Iterable[Package], limits: Iterable[str] = ()) -> None:
        self._limits = tuple(os.path.realpath(each).rstrip(os.sep) + os.sep for each in limits)
        self.packages = {package.name: package for package in packages if not package.broken}
        self._parts: dict[str, tuple[Parts, frozenset[str]]] = {}
        self._exported: dict[str, tuple[Exported, frozenset[str]]] = {}
        self._includes: dict[str, tuple[tuple[str, ...], frozenset[str]]] = {}
        self._plugins: dict[str, tuple[tuple[NodeletClass, ...], frozenset[str]]] = {}
        self._by_directory = {os.path.abspath(package.directory): package.name for package in self.packages.values()}

    def parts(self, name: str) -> Parts:
        """What a package builds, read once."""
        if name not in self._parts:
            self._parts[name] = looking.watched(lambda: Parts(self.packages[name], self.exported))
        parts, looked = self._parts[name]
        looking.note(looked)
        return parts

    def exported(self, name: str) -> Exported | None:
        """The CMake commands that a package here exports, read once; None where it is not here."""
        if name not in self.packages:
            return None
        if name not in self._exported:
            self._exported[name] = looking.watched(lambda: exported_commands(self.packages[name].directory))
        found, looked = self._exported[name]
        looking.note(looked)
        return found

    def plugins(self, name: str) -> tuple[NodeletClass, ...]:
        """The classes of all plugin descriptions that ``package.xml`` of a package exports, of nodelets and others."""
        if name not in self._plugins:
            self._plugins[name] = looking.watched(lambda: _plugins(self.packages[name]))
        found, looked = self._plugins[name]
        looking.note(looked)
        return found

    def package_of(self, path: str) -> str:
        """The package that a file lies in; empty where it lies in none."""
        directory = os.path.dirname(path)
        for _ in range(100):
            if directory in self._by_directory:
                return self._by_directory[directory]
            parent = os.path.dirname(directory)
            if parent == directory:
                break
            directory = parent
        return ""

    def includes(self, name: str) -> tuple[str, ...]:
        """Where headers are: of a package, and of those it depends on that are here."""
        if name not in self._includes:
            self._includes[name] = looking.watched(lambda: self._find_includes(name))
        found, looked = self._includes[name]
        looking.note(looked)
        return found

    def _find_includes(self, name: str) -> tuple[str, ...]:
        found: dict[str, None] = {}
        pending, seen = [name], {name}
        while pending:
            package = self.packages[pending.pop(0)]
            found.update(dict.fromkeys(self.parts(package.name).own_includes))
            for below in ("include", "src") if package.name == name else ("include",):
                path = os.path.join(os.path.abspath(package.directory), below)
                if os.path.isdir(path):
                    found[path] = None
            for each in sorted(package.manifest.depends()) if package.manifest is not None else ():
                if each in self.packages and each not in seen:
                    seen.add(each)
                    pending.append(each)
        return tuple(found)

    def absent(self, name: str) -> tuple[str, ...]:
        """The packages that a package depends on and that are not here."""
        manifest = self.packages[name].manifest
        return tuple(each for each in manifest.depends() if each not in self.packages) if manifest is not None else ()

    def may_read(self, path: str, root: str) -> bool:
        """Whether a source of a program of ``root`` may be read at all."""
        return os.path.realpath(path).startswith(self._limits or os.path.realpath(root).rstrip(os.sep) + os.sep)

    def assemble(self, name: str, target: Target, root: str) -> Assembled:
        """The files of a target of the package ``name``; none of them lies outside ``root``."""
        return _Assembly(self, name, root).of(target)


class _Assembly:
    """One program that is being put together."""

    def __init__(self, workspace: Workspace, name: str, root: str) -> None:
        self.workspace = workspace
        self.name = name
        self.root = root
        self.sources: dict[str, None] = {}
        self.doubts: dict[str, None] = {}
        self.includes = dict.fromkeys(workspace.includes(name))
        self.packages = {name}
        self.plugins: dict[Plugin, None] = {}
        self.templates: dict[str, Template] = {}
        self.words: set[str] = set()
        self.loads_nodelets = self.loads_classes = False
        self._pending: list[str] = []
        self._scanned: set[str] = set()

    def of(self, target: Target) -> Assembled:
        self._add_target(target, self.workspace.parts(self.name))
        self._scan()
        while self._add_plugins():
            self._scan()
        if len(self.sources) >= MOST_SOURCES or len(self._scanned) >= _MOST_SCANNED:
            self.doubts["it has too many source files to read them all"] = None
        packages = tuple(sorted({each for name in self.packages for each in self.workspace.absent(name)}))
        return Assembled(
            tuple(self.sources), tuple(self.templates.values()), tuple(self.includes), tuple(self.plugins), tuple(self.doubts), packages
        )

    def _add_target(self, target: Target, parts: Parts) -> None:
        """A target with the libraries of its package that are linked to it."""
        pending, seen = [target], {id(target)}
        while pending and len(self.sources) < MOST_SOURCES:
            each = pending.pop(0)
            if not each.complete:
                self.doubts[f"not all sources of {each.output} are known"] = None
            for path in cpp_sources(each):
                self._add_source(path)
            for output, made in each.generated.items():
                if output.endswith(CPP_ENDINGS):
                    self._add_template(template_of(made), each)
            for library in each.libraries:
                inner = parts.cmake.targets.get(library)
                if inner is not None and id(inner) not in seen:
                    seen.add(id(inner))
                    pending.append(inner)

    def _add_source(self, path: str) -> None:
        if path not in self.sources and len(self.sources) < MOST_SOURCES and self.workspace.may_read(path, self.root):
            self.sources[path] = None
            self._pending.append(path)

    def _add_template(self, template: Template | None, target: Target) -> None:
        if template is None or self.templates.setdefault(template.path, template) != template:
            self.doubts[f"not all sources of {target.output} are known"] = None
        else:
            self._add_source(template.path)

    def _scan(self) -> None:
        """Read what the files include, and add the sources of the libraries of other packages that come in with their headers."""
        while self._pending and len(self._scanned) < _MOST_SCANNED:
            path = self._pending.pop(0)
            if path in self._scanned:
                continue
            self._scanned.add(path)
            text = filled(text_of(path), path, tuple(self.templates.values()))
            self.loads_nodelets = self.loads_nodelets or _LOADER.search(text) is not None
            self.loads_classes = self.loads_classes or _CLASS_LOADER.search(text) is not None
            self.words.update(_QUOTED.findall(text))
            for quote, spelled in _INCLUDE.findall(text):
                header = found_header(spelled, quote == '"', path, tuple(self.includes))
                if header is not None and header not in self._scanned:
                    self._pending.append(header)
                    owner = self.workspace.package_of(header)
                    if owner:
                        self._add_providers(owner, header)

    def _add_providers(self, name: str, header: str) -> None:
        if name not in self.packages:
            self.packages.add(name)
            self.includes.update(dict.fromkeys(self.workspace.includes(name)))
        last = os.path.basename(header)
        for path in self.workspace.parts(name).library_sources:
            if last in included_names(path):
                self._add_source(path)

    def _add_plugins(self) -> bool:
        """Plugins that the program can load, by the names and base classes that it spells; whether there were any new ones."""
        if not (self.loads_nodelets or self.loads_classes):
            return False
        before = len(self.plugins)
        for package in self.workspace.packages:
            for each in self.workspace.plugins(package):
                is_nodelet = "odelet" in each.base or not each.base
                wanted = self.loads_nodelets and each.name in self.words if is_nodelet else self.loads_classes and each.base in self.words
                plugin = Plugin(each.name, each.type or each.name.replace("/", "::"), each.base)
                parts = self.workspace.parts(package) if wanted else None
                target = None if parts is None else parts.library(each.library)
                if parts is not None and target is not None and plugin not in self.plugins:
                    self.plugins[plugin] = None
                    self.packages.add(package)
                    self.includes.update(dict.fromkeys(self.workspace.includes(package)))
                    self._add_target(target, parts)
        return len(self.plugins) > before


def _plugins(package: Package) -> tuple[NodeletClass, ...]:
    found: list[NodeletClass] = []
    exported = _EXPORTED.findall(text_of(package.manifest_path))
    for each in dict.fromkeys(exported[:_MOST_DESCRIPTIONS]):
        path = os.path.realpath(os.path.join(package.directory, each.replace("${prefix}/", "", 1)))
        if path.startswith(os.path.realpath(package.directory) + os.sep):
            found += plugin_classes(path)[0]
    return tuple(found)


def cpp_sources(target: Target) -> list[str]:
    """The C++ files of a target; CMake finds one that is named without its ending."""
    found = []
    for path in target.sources:
        tried = (path,) if os.path.splitext(path)[1] else tuple(path + ending for ending in CPP_ENDINGS)
        found += [each for each in tried if each.endswith(CPP_ENDINGS) and os.path.isfile(each)][:1]
    return found


def has_main(target: Target) -> bool:
    """Whether one of its sources defines ``main()``."""
    return any(_MAIN.search(text_of(path)) is not None for path in cpp_sources(target))


def found_header(name: str, quoted: bool, includer: str, directories: Sequence[str]) -> str | None:
    """The file that ``#include`` means, beside the includer or in the directories; None where it is not here."""
    if "\0" in name or os.path.isabs(name):
        return None
    beside = os.path.dirname(includer)
    near = (os.path.join(beside, "include"), os.path.join(os.path.dirname(beside), "include"))
    # Where a header is not found, a directory called include beside the file is looked into, too.
    for directory in (beside, *directories, *near) if quoted else directories:
        path = os.path.normpath(os.path.join(directory, name))
        if os.path.isfile(path):
            return path
    return None


def included_names(path: str) -> frozenset[str]:
    """The last parts of the names of the headers that a file includes."""
    looking.note((os.path.abspath(path),))
    return _included_names(path, _stamp(path))


@lru_cache(maxsize=4096)
def _included_names(path: str, stamp: object) -> frozenset[str]:
    return frozenset(os.path.basename(name) for _, name in _INCLUDE.findall(_text(path, stamp)))


def text_of(path: str) -> str:
    """The text of a file; empty where it cannot be read."""
    looking.note((os.path.abspath(path),))
    return _text(path, _stamp(path))


@lru_cache(maxsize=512)
def _text(path: str, stamp: object) -> str:
    try:
        return looking.read_bytes(path).decode("utf-8", "replace")
    except OSError:
        return ""


def _stamp(path: str) -> object:
    """Another one where the file is another."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return (status.st_mtime_ns, status.st_size, status.st_ino)


def files_below(directory: str) -> list[str]:
    """All files of a package relative to it, for ``file(GLOB)``; hidden directories and links to directories are left out."""
    found: list[str] = []
    for here, directories, files in os.walk(directory):
        directories[:] = sorted(each for each in directories if not each.startswith("."))
        relative = os.path.relpath(here, directory)
        found += [each if relative == "." else f"{relative}/{each}" for each in sorted(files)]
        if len(found) > 20_000:
            break
    return found

"""Which files a C++ program is made of: its own sources, those of libraries whose headers it includes, and those of plugins it can load.

A library of another package is linked through ``${catkin_LIBRARIES}``, which names nothing: what says that it is used is a header of that
package among the included ones. Of its library sources those are taken that include the header, too.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable

from launchlint.extract.definitions import Library
from launchlint.extract.fact import Plugin
from launchlint.extract.scanned import Files, scan, text_of
from launchlint.extract.template import Template, filled, template_of
from launchlint.named_tuple import NamedTuple
from launchlint.workspace import looking
from launchlint.workspace.cmake_exports import Exported, exported_commands
from launchlint.workspace.cmake_facts import read_cmake
from launchlint.workspace.cmake_targets import CMakeFacts, Target
from launchlint.workspace.nodelets import NodeletClass, plugin_classes
from launchlint.workspace.package import Package

CPP_ENDINGS = (".cpp", ".cc", ".cxx", ".c++", ".C", ".cu")
MOST_SOURCES = 400
"""Source files of one C++ program."""
_MOST_SCANNED = 1_500
_MOST_DESCRIPTIONS = 50

_EXPORTED = re.compile(r"<\w+\s[^<>]*?\bplugin\s*=\s*[\"']([^\"'\n\0]{1,300})[\"']")
_MAIN = re.compile(r"^[ \t]*(?:int[ \t\n]+main|TEST|TEST_[FP]|TEST_CASE|SCENARIO)[ \t\n]*\(", re.MULTILINE)


class Assembled(NamedTuple):
    """The files of a program and which are templates, where their headers are, the plugins it can load, and why there may be more.

    ``packages`` are those that the packages of its files depend on, and that are not here; ``parameters`` the YAML files that
    generate_parameter_library makes classes of, for these packages and those whose headers are included.
    """

    sources: tuple[str, ...]
    templates: tuple[Template, ...]
    includes: tuple[str, ...]
    plugins: tuple[Plugin, ...]
    doubts: tuple[str, ...]
    packages: tuple[str, ...]
    parameters: tuple[str, ...]


class Parts:
    """What one package builds: its targets, plugin descriptions, and directories with headers."""

    def __init__(self, package: Package, exported: Callable[[str], Exported | None]) -> None:
        self.package = package
        looking.note_tree(package.directory)
        looking.note((os.path.abspath(package.manifest_path),))
        self.is_ament = package.manifest is not None and package.manifest.is_ament
        depended = package.manifest.build_dependencies if package.manifest is not None else ()
        self.cmake: CMakeFacts = read_cmake(
            package.directory, lambda: files_below(package.directory), exported, ament=self.is_ament, depended=depended
        )
        self.by_output = {target.output: target for target in self.cmake.targets.values() if target.is_library}
        self.own_includes = tuple(each for each in self.cmake.include_directories if os.path.isdir(each))
        self._libraries: tuple[str, ...] | None = None

    def linked(self, target: Target) -> list[Target]:
        """A target with the libraries of this package that are linked to it."""
        found, seen = [target], {id(target)}
        for each in found:
            for library in each.libraries:
                inner = self.cmake.targets.get(library) or self.cmake.targets.get(library.rpartition("::")[2])
                if inner is not None and id(inner) not in seen:
                    seen.add(id(inner))
                    found.append(inner)
        return found

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
        self._parts: dict[str, tuple[Parts, looking.Looked]] = {}
        self._exported: dict[str, tuple[Exported, looking.Looked]] = {}
        self._includes: dict[str, tuple[tuple[str, ...], looking.Looked]] = {}
        self._plugins: dict[str, tuple[tuple[NodeletClass, ...], looking.Looked]] = {}
        self.files = Files()
        self._classes: dict[tuple[tuple[str, ...], str], tuple[tuple[str, ...], looking.Looked]] = {}
        self._libraries: dict[tuple[str, ...], Library] = {}
        self._providers: dict[tuple[str, str], tuple[tuple[str, ...], looking.Looked]] = {}
        self._may_read: dict[tuple[str, str], bool] = {}
        self._owners: dict[str, str] = {}
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
        if directory not in self._owners:
            self._owners[directory] = self._owner(directory)
        return self._owners[directory]

    def _owner(self, directory: str) -> str:
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
            depended = sorted(package.manifest.depends()) if package.manifest is not None else ()
            for each in (*depended, *self.parts(package.name).cmake.found):  # CMake finds what is built beside it, declared or not
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
        key = (path, root)
        if key not in self._may_read:
            self._may_read[key] = os.path.realpath(path).startswith(self._limits or os.path.realpath(root).rstrip(os.sep) + os.sep)
        return self._may_read[key]

    def providers(self, name: str, header: str) -> tuple[str, ...]:
        """The library sources of a package that define what a header of it declares: those that include it, and define a name in it.

        With them come those of the same libraries whose objects register their classes as the library is loaded.
        """
        key = (name, header)
        if key not in self._providers:
            self._providers[key] = looking.watched(lambda: self._find_providers(name, header))
        found, looked = self._providers[key]
        looking.note(looked)
        return found

    def _find_providers(self, name: str, header: str) -> tuple[str, ...]:
        last = os.path.basename(header)
        library = self._library(name, self.parts(name).library_sources)
        defining = set(library.defining(header))
        found = {
            path: None
            for path in self.parts(name).library_sources
            if any(os.path.basename(each) == last for _, each in self.files.scan(path).includes) and path in defining
        }
        for target in self.parts(name).cmake.targets.values() if found else ():
            sources = cpp_sources(target) if target.is_library and "nodelet" not in target.output else []
            if not found.keys().isdisjoint(sources):
                found.update((path, None) for path in sources if self.files.scan(path).registers)
        return tuple(found)

    def class_sources(self, name: str, target: Target, type_: str, root: str) -> tuple[str, ...]:
        """The sources of a target and the libraries linked to it that a class needs; all where that is not known."""
        sources = tuple(path for each in self.parts(name).linked(target) for path in cpp_sources(each) if self.may_read(path, root))
        key = (sources, type_)
        if key not in self._classes:
            self._classes[key] = looking.watched(lambda: self._library(name, sources).of_class(type_))
        found, looked = self._classes[key]
        looking.note(looked)
        return found

    def _library(self, name: str, sources: tuple[str, ...]) -> Library:
        if sources not in self._libraries:
            directories = self.includes(name)
            self._libraries[sources] = Library(sources, self.files.text, lambda path: self.files.included(path, directories))
        return self._libraries[sources]

    def assemble(self, name: str, target: Target, root: str, entry: str = "") -> Assembled:
        """The files of a target of the package ``name``, or of the class ``entry`` in it; none of them lies outside ``root``."""
        return _Assembly(self, name, root).of(target, entry)


class _Assembly:
    """One program that is being put together."""

    def __init__(self, workspace: Workspace, name: str, root: str) -> None:
        self.workspace = workspace
        self.name = name
        self.root = root
        self.sources: dict[str, None] = {}
        self.doubts: dict[str, None] = {}
        self.includes = dict.fromkeys(workspace.includes(name))
        self._directories = tuple(self.includes)
        self.packages = {name}
        self._described: set[str] = set()
        self.plugins: dict[Plugin, None] = {}
        self.templates: dict[str, Template] = {}
        self.words: set[str] = set()
        self.loads_nodelets = self.loads_classes = False
        self._pending: list[str] = []
        self._scanned: set[str] = set()

    def of(self, target: Target, entry: str) -> Assembled:
        self._add_target(target, self.name, entry)
        self._scan()
        while self._add_plugins():
            self._scan()
        if len(self.sources) >= MOST_SOURCES or len(self._scanned) >= _MOST_SCANNED:
            self.doubts["it has too many source files to read them all"] = None
        packages = tuple(sorted({each for name in self.packages for each in self.workspace.absent(name)}))
        described = [
            path
            for name in sorted(self.packages | self._described)
            for path in self.workspace.parts(name).cmake.parameter_libraries.values()
        ]
        return Assembled(
            tuple(self.sources),
            tuple(self.templates.values()),
            tuple(self.includes),
            tuple(self.plugins),
            tuple(self.doubts),
            packages,
            tuple(sorted(path for path in described if self.workspace.may_read(path, self.root))),
        )

    def _add_target(self, target: Target, name: str, entry: str = "") -> None:
        """A target with the libraries of its package that are linked to it; of these only what the class ``entry`` needs, where one is."""
        parts = self.workspace.parts(name)
        linked = parts.linked(target)
        needed = set(self.workspace.class_sources(name, target, entry, self.root)) if entry else None
        for each in linked:
            if not each.complete:
                self.doubts[f"not all sources of {each.output} are known"] = None
            for path in cpp_sources(each):
                if needed is None or path in needed:
                    self._add_source(path)
            for output, made in each.generated.items():
                if output.endswith(CPP_ENDINGS):
                    self._add_template(template_of(made), each)

    def _add_package(self, name: str) -> None:
        self.packages.add(name)
        self.includes.update(dict.fromkeys(self.workspace.includes(name)))
        self._directories = tuple(self.includes)

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
            said = self.workspace.files.scan(path)
            if path in self.templates:
                said = scan(filled(self.workspace.files.text(path), path, tuple(self.templates.values())))
            self.loads_nodelets = self.loads_nodelets or said.loads_nodelets
            self.loads_classes = self.loads_classes or said.loads_classes
            self.words.update(said.quoted)
            for quoted, spelled in said.includes:
                header = self.workspace.files.header(path, quoted, spelled, self._directories)
                if header is None:
                    self._add_described(spelled)
                elif header not in self._scanned:
                    self._pending.append(header)
                    owner = self.workspace.package_of(header)
                    if owner:
                        self._add_providers(owner, header)

    def _add_described(self, header: str) -> None:
        """A header that generate_parameter_library makes in another package: ``package/library.hpp``."""
        name, _, rest = header.partition("/")
        if name in self.workspace.packages and rest.rpartition(".")[0] in self.workspace.parts(name).cmake.parameter_libraries:
            self._described.add(name)

    def _add_providers(self, name: str, header: str) -> None:
        if name not in self.packages:
            self._add_package(name)
        for path in self.workspace.providers(name, header):
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
                    self._add_package(package)
                    self._add_target(target, package, plugin.type)
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
    """Whether one of its sources defines ``main()``, or tests, for which their library does."""
    return any(_MAIN.search(text_of(path)) is not None for path in cpp_sources(target))


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

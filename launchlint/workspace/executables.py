"""What a package can run, told from its files alone: nothing is built, nothing is started.

``exhaustive`` says that nothing else can exist. Where a list is not exhaustive a name that is not in it may still be right: a rule must not
call it wrong.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable, Mapping, Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.cmake_facts import CMAKE_FILE, read_cmake
from launchlint.workspace.cmake_made import Made
from launchlint.workspace.cmake_taking import matches, takes
from launchlint.workspace.cmake_targets import CMakeFacts, Install
from launchlint.workspace.looking import Looked, exists, files_of, remembered, start, walk
from launchlint.workspace.manifest import PACKAGE_FILE
from launchlint.workspace.nodelets import NodeletClass, read_nodelet_classes
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.prefixes import Prefix
from launchlint.workspace.program_names import packages_having

_MOST_DIRECTORIES = 300
_SCRIPT_ENDS = (".py", ".sh", ".bash", ".pl", ".rb", ".lua")
_CONFIGURES = ".cfg"
"""Descriptions for dynamic_reconfigure are scripts that the build runs."""
_RELAYED = "catkin_install_python(PROGRAMS)"
_EXECUTABLE = stat.S_IRUSR | stat.S_IXUSR


class Executable(NamedTuple):
    """One thing ``<node type="…">`` can name. ``how`` it is known: the CMake command that makes it, or ``file`` for one at ``path``."""

    name: str
    how: str
    path: str | None


class Flaw(NamedTuple):
    """A file that is meant to be run and cannot: it lacks the executable bit, or, being a script, the ``#!`` line."""

    path: str
    lacks_bit: bool
    lacks_shebang: bool


class Executables:
    """The executables of one package.

    ``by_name`` is sorted by name. ``reasons`` say why there may be more than these (empty: ``exhaustive``). ``installed`` says that the
    package is an installed one, not one in a workspace. ``nodelet_classes`` maps class names (as ``pkg/Class``) to their descriptions, and
    ``nodelet_reasons`` say why there may be more of those. ``relayed`` are the names that ``catkin_install_python`` is given: since ROS
    Noetic it writes a program of each into the devel space, which roslaunch finds first and which reads the script.
    """

    __slots__ = ("_unrunnable", "by_name", "installed", "nodelet_classes", "nodelet_reasons", "reasons", "relayed")

    def __init__(
        self,
        by_name: Mapping[str, Executable],
        reasons: Sequence[str],
        installed: bool,
        nodelets: tuple[Mapping[str, NodeletClass], Sequence[str]],
        unrunnable: Mapping[str, str],
        relayed: frozenset[str] = frozenset(),
    ) -> None:
        self.by_name = by_name
        self.reasons = tuple(reasons)
        self.installed = installed
        self.nodelet_classes = nodelets[0]
        self.nodelet_reasons = tuple(nodelets[1])
        self._unrunnable = unrunnable
        self.relayed = relayed

    @property
    def exhaustive(self) -> bool:
        """Whether no executable can exist that is not in ``by_name``."""
        return not self.reasons

    @property
    def names(self) -> list[str]:
        """Their names, sorted."""
        return list(self.by_name)

    @property
    def programs(self) -> list[str]:
        """Those of the names that people would call programs: what is built, and scripts; any file may have the executable bit."""
        return [each.name for each in self.by_name.values() if each.how != "file" or _is_program(each.path)]

    @property
    def has_runnable_script(self) -> bool:
        """Whether any script of the package has the executable bit."""
        return any(each.how == "file" and each.name.endswith(_SCRIPT_ENDS) for each in self.by_name.values())

    @property
    def unrunnable(self) -> list[str]:
        """The names of the files that have no executable bit."""
        return list(self._unrunnable)

    def flaw(self, name: str) -> Flaw | None:
        """What is wrong with the script called ``name``, if the package has one that cannot be started; reads its first bytes.

        A file without the executable bit is not found by roslaunch (roslib.packages.find_node); one with the bit and without
        ``#!`` is found, and the operating system then refuses to run it. A name that something else of the package answers to is fine.
        """
        found = self.by_name.get(name)
        if found is not None and found.how != "file" and name not in self._unrunnable:
            return None
        if found is not None and found.path is not None and found.how == "file":
            lacks = name.endswith(_SCRIPT_ENDS) and start(found.path) not in (b"#!", b"\x7fE", None)
            return Flaw(found.path, False, True) if lacks else None
        path = self._unrunnable.get(name)
        if path is None:
            return None
        begin = start(path)
        if begin != b"#!" and not name.endswith(_SCRIPT_ENDS):
            return None
        return Flaw(path, True, begin not in (b"#!", None))


class InstalledFiles(NamedTuple):
    """Which of its files a package installs; ``reasons`` say why there may be more (empty: exhaustive).

    ``by_name``: there is an ``install()`` as such, and not only a ``catkin_install_python``, which serves devel spaces, too.
    ``leaves_programs``: the package builds programs and installs nothing that is built.
    """

    installs: tuple[Install, ...]
    reasons: tuple[str, ...]
    by_name: bool = True
    leaves_programs: bool = False

    @property
    def exhaustive(self) -> bool:
        """Whether a file that is not covered is certainly not installed."""
        return not self.reasons

    def covers(self, path: str) -> bool:
        """Whether some ``install()`` command takes the file at ``path`` (absolute)."""
        return any(takes(install, path) for install in self.installs)

    def leaves_out(self, path: str) -> bool:
        """Whether some ``install(DIRECTORY …)`` would take the file at ``path`` (absolute), were it not for its EXCLUDE."""
        return any(install.without and takes(install._replace(without=()), path) and not takes(install, path) for install in self.installs)

    def makes_runnable(self, path: str) -> bool:
        """Whether the file at ``path`` (absolute) can be run once it is installed, whatever its permissions are here."""
        parts = path.split("/")
        return any(takes(each, path) and any(matches(pattern, parts) for pattern in each.runnable) for each in self.installs)

    @property
    def directories(self) -> tuple[str, ...]:
        """The directories that are installed, absolute, sorted."""
        return tuple(sorted({each.path for each in self.installs if each.is_directory}))


def executables(package: Package, prefixes: Iterable[Prefix] = ()) -> Executables:
    """What ``package`` can run, from its CMake files, the executable files in it, and its directories in ``prefixes``.

    The search is that of roslib.packages.find_node: a file of that name with the executable bit, at any depth, in the libexec directories
    of the devel and install spaces or in the package itself. Never raises.
    """
    files, complete = files_of(package.directory)
    installed = _is_installed(package)
    facts = CMakeFacts() if installed else read_cmake(package.directory, lambda: list(files))
    found: dict[str, Executable] = {}
    unrunnable: dict[str, str] = {}
    reasons = list(dict.fromkeys(facts.executables_reasons))
    if not complete:
        reasons.append("the package has too many files")
    for directory, listed in [(package.directory, files), *_libexec(package, prefixes, installed)]:
        for file, mode in listed.items():
            name = os.path.basename(file)
            if mode & _EXECUTABLE == _EXECUTABLE:
                found.setdefault(name, Executable(name, "file", os.path.join(directory, file)))
            else:
                unrunnable.setdefault(name, os.path.join(directory, file))
    for name, how in facts.executables.items():
        found.setdefault(name, Executable(name, how, None))
    nodelets = read_nodelet_classes(package)
    relayed = frozenset(name for name, how in facts.executables.items() if how == _RELAYED)
    return Executables(dict(sorted(found.items())), reasons, installed, nodelets, unrunnable, relayed)


def launch_install_directories(package: Package) -> InstalledFiles:
    """Which files the package's ``install(DIRECTORY …)``, ``install(FILES …)`` and ``install(PROGRAMS …)`` take. Never raises."""
    facts = read_cmake(package.directory, lambda: list(files_of(package.directory)[0]))
    leaves_programs = not facts.installs_targets and any(not target.is_library for target in facts.targets.values())
    return InstalledFiles(tuple(facts.installs), tuple(dict.fromkeys(facts.installs_reasons)), facts.installs_by_name, leaves_programs)


def made_files(package: Package) -> Made:
    """What files the CMake files of ``package`` make. Never raises."""
    return read_cmake(package.directory, lambda: list(files_of(package.directory)[0])).made


class ExecutableIndex:
    """What there is in the packages of one run, and what their builds make and install; each looked at once."""

    __slots__ = ("_executables", "_having", "_installs", "_made", "_packages", "_walked")

    def __init__(self, packages: Packages) -> None:
        self._packages = packages
        self._executables: dict[str, tuple[Executables, Looked]] = {}
        self._having: dict[None, tuple[Mapping[str, Sequence[str]], Looked]] = {}
        self._installs: dict[str, tuple[InstalledFiles, Looked]] = {}
        self._made: dict[str, tuple[Made, Looked]] = {}
        self._walked: dict[str, tuple[Sequence[tuple[str, Sequence[str]]], Looked]] = {}

    def executables(self, package: Package) -> Executables:
        """What ``package`` can run."""
        return remembered(self._executables, package.directory, lambda: executables(package, self._packages.prefixes))

    def having(self, name: str) -> Sequence[str]:
        """The packages of the workspaces, by name and sorted, that have a program called just ``name``; all are looked at."""
        return remembered(self._having, None, self._programs).get(name, [])

    def _programs(self) -> Mapping[str, Sequence[str]]:
        return packages_having(self._packages, lambda package: self.executables(package).by_name)

    def installs(self, package: Package) -> InstalledFiles:
        """What ``package`` installs."""
        return remembered(self._installs, package.directory, lambda: launch_install_directories(package))

    def made(self, package: Package) -> Made:
        """What files the build of ``package`` makes."""
        return remembered(self._made, package.directory, lambda: made_files(package))

    def directories(self, package: Package) -> Sequence[tuple[str, Sequence[str]]]:
        """Each directory of ``package`` with the names in it, as :func:`~launchlint.workspace.looking.walk` gives them."""
        return remembered(self._walked, package.directory, lambda: tuple(walk(package.directory, _MOST_DIRECTORIES)))


def _is_program(path: str | None) -> bool:
    return path is not None and not path.endswith(_CONFIGURES) and start(path) in (b"#!", b"\x7fE")


def _is_installed(package: Package) -> bool:
    """An installed package stands in ``<prefix>/share`` and has no ``CMakeLists.txt``."""
    parent = os.path.dirname(package.directory)
    return (
        os.path.basename(parent) == "share"
        and os.path.basename(package.manifest_path) == PACKAGE_FILE
        and not exists(os.path.join(package.directory, CMAKE_FILE))
    )


def _libexec(package: Package, prefixes: Iterable[Prefix], installed: bool) -> list[tuple[str, dict[str, int]]]:
    """The libexec directories of the package with their files."""
    if not package.name or "/" in package.name or package.name in (".", ".."):
        return []
    directories = [each for prefix in prefixes for each in prefix.libexec(package.name)]
    if installed:
        prefix = os.path.dirname(os.path.dirname(package.directory))
        directories += Prefix(prefix, False, False).libexec(package.name)
    return [(each, files_of(each)[0]) for each in dict.fromkeys(directories)]

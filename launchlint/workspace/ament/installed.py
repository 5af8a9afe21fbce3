"""What is installed of one package: which source file stands under which share path, and which programs there are in ``lib/PKG``.

What the build files say is read, nothing is built. Where they are not wholly understood there are ``reasons``, and then what is not found
here may be there all the same: only :meth:`Installed.lacks` and :meth:`Installed.lacks_program` say that something is certainly missing.
"""

from __future__ import annotations

import os
import posixpath
from collections.abc import Iterable, Mapping, Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.ament.placed import below_prefix, places_of, sources_of
from launchlint.workspace.cmake_targets import CMakeFacts, Install
from launchlint.workspace.looking import files_of
from launchlint.workspace.package import Package

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.ament.scripts import Script


class Program(NamedTuple):
    """A program of a package. ``how`` it comes to be: a command, an entry point, or ``file``. ``sources`` are files (absolute) it is made
    from, as far as they are known. ``destination``: the directory below the prefix it is installed to, empty where it is built and not
    installed, ``None`` where that is not known. ``entry`` is the ``module:function`` of an entry point.
    """

    name: str
    how: str
    sources: tuple[str, ...]
    destination: str | None
    entry: str = ""


class Installed:
    """What is installed of the package called ``name``.

    ``installs`` are files and directory trees, ``programs`` all programs, those not in ``lib/PKG`` among them, in order.
    ``reasons`` say why there may be more files, ``program_reasons`` why there may be more programs; in the directories ``gaps`` below the
    prefix there may be more of both. ``components`` are the classes that can be loaded into a container; None where not all are known.
    """

    __slots__ = ("components", "gaps", "installs", "name", "program_reasons", "programs", "reasons")

    def __init__(
        self,
        name: str,
        installs: Sequence[Install],
        reasons: Iterable[str],
        programs: Sequence[Program],
        program_reasons: Iterable[str],
        gaps: Iterable[str] = (),
        components: frozenset[str] | None = None,
    ) -> None:
        self.components = components
        self.name = name
        self.installs = tuple(installs)
        self.reasons = tuple(dict.fromkeys(reasons))
        self.programs = tuple(programs)
        self.gaps = frozenset(gaps)
        self.program_reasons = tuple(dict.fromkeys((*self.reasons, *program_reasons)))

    def share_paths(self, file: str) -> tuple[str, ...]:
        """The paths below ``share/PKG`` at which the file at ``file`` (absolute) stands; sorted."""
        start = f"share/{self.name}/"
        return tuple(sorted({place[len(start) :] for place in places_of(self.installs, file) if place.startswith(start)}))

    def source_of(self, path: str) -> str | None:
        """The file or directory (absolute) that stands at ``path`` below ``share/PKG`` once the package is installed; ``None`` where none
        is known to (see :meth:`lacks`).
        """
        return next(sources_of(self.installs, posixpath.normpath(f"share/{self.name}/{path}")), None)

    def lacks(self, path: str) -> bool:
        """Whether there is certainly nothing at ``path`` below ``share/PKG`` once the package is installed."""
        if self.reasons or any(below_prefix(each.destination) is None or each.renamed is None for each in self.installs):
            return False
        place = posixpath.normpath(f"share/{self.name}/{path}")
        if any(gap == "." or f"{place}/".startswith(f"{gap}/") for gap in self.gaps):
            return False
        if any(f"{below_prefix(each.destination)}/".startswith(f"{place}/") for each in self.installs):
            return False  # a directory above one that things are installed to
        return not any(True for _ in sources_of(self.installs, place))

    @property
    def libexec(self) -> Mapping[str, Program]:
        """The programs in ``lib/PKG``, by name; sorted."""
        there = f"lib/{self.name}"
        return {each.name: each for each in sorted(self.programs, key=lambda each: each.name) if each.destination == there}

    def elsewhere(self, name: str) -> Program | None:
        """The program ``name`` that is built, or in another directory, where none of that name is in ``lib/PKG``; else ``None``."""
        there = f"lib/{self.name}"
        found = [each for each in self.programs if each.name == name]
        return (
            None
            if not found or any(each.destination in (there, None) for each in found)
            else max(found, key=lambda each: each.destination or "")
        )

    def lacks_program(self, name: str) -> bool:
        """Whether there is certainly no program ``name`` in ``lib/PKG`` once the package is installed."""
        there = f"lib/{self.name}"
        return (
            not self.program_reasons
            and self.gaps.isdisjoint((there, "lib", "."))
            and not any(each.destination is None or (each.name == name and each.destination == there) for each in self.programs)
        )


def of_cmake(package: Package, facts: CMakeFacts, files: Mapping[str, int], scripts: Sequence[Script], reasons: Iterable[str]) -> Installed:
    """What a package of build type ``ament_cmake`` installs.

    ``files`` are those of the package; ``scripts`` the programs in Python that ``setup.cfg`` names, ``reasons`` why there may be more.
    """
    programs = [*_targets(facts), *_files(facts.installs, package, files)]
    programs += [Program(each.name, "console_scripts", each.sources, below_prefix(each.destination), each.entry) for each in scripts]
    gaps = [(reason, below_prefix(destination)) for reason, destination in facts.gaps]
    outside = [each for each in facts.installs if each.is_directory and not f"{each.path}/".startswith(f"{package.directory}/")]
    to_programs = {below_prefix(each.destination) for each in outside} & {f"lib/{package.name}", "lib"}
    gaps += [("files of a directory outside of the package are not looked at", each) for each in sorted(filter(None, to_programs))]
    local = {reason for reason, _ in gaps} - {reason for reason, destination in gaps if destination is None}
    return Installed(
        package.name,
        facts.installs,
        [each for each in facts.installs_reasons if each not in local],
        programs,
        (*facts.targets_reasons, *reasons),
        [destination for _, destination in gaps if destination is not None],
        None if facts.targets_reasons or facts.executables_reasons else frozenset(each.plugin for each in facts.components),
    )


def of_files(
    package: Package, installs: Sequence[Install], reasons: Iterable[str], scripts: Sequence[Script], script_reasons: Iterable[str]
) -> Installed:
    """What a package of build type ``ament_python`` installs: its ``data_files``, and its programs."""
    programs = [Program(each.name, "setup.py", each.sources, below_prefix(each.destination), each.entry) for each in scripts]
    programs += _files(installs, package, {})
    return Installed(package.name, installs, reasons, programs, script_reasons, components=frozenset())


def of_prefix(package: Package) -> Installed:
    """What there is of a package that is installed: it lies in ``PREFIX/share``."""
    prefix = os.path.dirname(os.path.dirname(package.directory))
    libexec = os.path.join(prefix, "lib", package.name)
    files = {each: mode for each, mode in files_of(libexec)[0].items() if "/" not in each}
    programs = [Program(each, "file", (os.path.join(libexec, each),), f"lib/{package.name}") for each in files]
    return Installed(package.name, [Install(package.directory, True, "share")], (), programs, ())


def unknown(package: Package, reason: str) -> Installed:
    """Nothing is known of what ``package`` installs."""
    return Installed(package.name, (), (reason,), (), ())


def _targets(facts: CMakeFacts) -> Iterable[Program]:
    """What is built: each executable with where ``install(TARGETS …)`` puts it."""
    to: dict[str, list[str | None]] = {}
    for install in facts.target_installs:
        to.setdefault(install.name, []).append(below_prefix(install.destination))
    named = {target.output: (name, target) for name, target in facts.targets.items() if not target.is_library}
    for name, how in facts.executables.items():
        if how.endswith("(PROGRAMS)"):
            continue
        target, parts = named.get(name, (name, None))
        for destination in to.get(target, [""]):
            yield Program(name, how, () if parts is None else tuple(parts.sources), destination)


def _files(installs: Sequence[Install], package: Package, files: Mapping[str, int]) -> Iterable[Program]:
    """Files and the contents of directories that are installed to ``lib/PKG``, and files to ``bin``."""
    there = f"lib/{package.name}"
    for install in installs:
        to = below_prefix(install.destination)
        if to not in (there, "bin", "lib", None):
            continue
        if not install.is_directory:
            name = install.renamed or os.path.basename(install.path)
            if install.renamed is not None and (to is not None or "*" in install.runnable):
                yield Program(name, "file", (install.path,), to)
            continue
        if to is None:
            continue
        for file in files:
            path = os.path.join(package.directory, file)
            for place in places_of((install,), path):
                if posixpath.dirname(place) in (there, "bin"):
                    yield Program(posixpath.basename(place), "file", (path,), posixpath.dirname(place))

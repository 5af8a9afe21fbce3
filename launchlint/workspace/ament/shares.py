"""Paths below ``$(find-pkg-share PKG)``, which is the source directory of a package here: what of it is there once it is installed."""

from __future__ import annotations

import os

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.ament.installed import Installed
from launchlint.workspace.ament.reading import InstalledIndex
from launchlint.workspace.looking import Looked, exists, remembered
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.prefixes import is_installed

_BUILD = ("CMakeLists.txt", "setup.py")


class Shared(NamedTuple):
    """A path in the source directory of ``package``, taken for one below its share directory: ``path`` is what follows that."""

    package: Package
    path: str
    installed: Installed


def shared(packages: Packages, file: str) -> Shared | None:
    """The package whose share directory ``file`` (absolute) would lie in; ``None`` where it is that of no package of the workspaces."""
    colcon = packages.colcon
    found = colcon.once(_Places).of(file)
    return None if found is None else Shared(*found, colcon.once(InstalledIndex).of(found[0]))


class _Places:
    """Where files lie in their packages: the same files are asked for in each configuration of many launch files."""

    __slots__ = ("_found", "_packages")

    def __init__(self, packages: Packages) -> None:
        self._packages = packages
        self._found: dict[str, tuple[tuple[Package, str] | None, Looked]] = {}

    def of(self, file: str) -> tuple[Package, str] | None:
        """The package that ``file`` lies in, and its path there."""
        return remembered(self._found, file, lambda: self._place(file))

    def _place(self, file: str) -> tuple[Package, str] | None:
        nearest = self._packages.package_of(file)
        if nearest is None or not nearest.name or is_installed(nearest.directory):
            return None
        package = self._packages.get(nearest.name, file)
        if package is None or package.directory != nearest.directory:
            return None
        path = os.path.relpath(os.path.abspath(file), package.directory)
        return None if path == "." else (package, path)


def installed_source(packages: Packages, file: str) -> str | None:
    """The file that is installed to where ``file`` (absolute) would lie if the source directory were the share directory.

    ``$(find-pkg-share rover)/launch/a.launch.xml`` may come from ``rover/bringup/launch/a.launch.xml``. ``None`` where none is known.
    """
    found = shared(packages, file)
    source = None if found is None else found.installed.source_of(found.path)
    return source if source is not None and exists(source) else None


def is_built(packages: Packages, file: str) -> bool:
    """Whether the package whose share directory ``file`` (absolute) would lie in has anything that says what it installs."""
    found = shared(packages, file)
    return found is not None and any(exists(os.path.join(found.package.directory, each)) for each in _BUILD)


def may_be_installed(packages: Packages, file: str) -> str:
    """Why something may stand there once the package is installed, although it is not here: what of its build files is not understood.

    Empty where certainly nothing will stand there, and where there is nothing to build the package with.
    """
    found = shared(packages, file)
    if found is None or found.installed.lacks(found.path) or not is_built(packages, file):
        return ""
    reasons = found.installed.reasons
    return reasons[0] if reasons else "it installs files whose names are not known here"

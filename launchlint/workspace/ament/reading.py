"""What the packages of a run install, each looked at once."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence

from launchlint.workspace.ament.installed import Installed, of_cmake, of_files, of_prefix, unknown
from launchlint.workspace.ament.scripts import Script, entry_points, read_setup_cfg
from launchlint.workspace.cmake_exports import Exported, exported_commands
from launchlint.workspace.cmake_facts import read_cmake
from launchlint.workspace.cmake_targets import CMakeFacts
from launchlint.workspace.looking import Looked, files_of, remembered
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.prefixes import is_installed
from launchlint.workspace.program_names import packages_having

ROS2 = {"ROS_VERSION": "2"}


class InstalledIndex:
    """What the packages that :attr:`Packages.colcon` finds install; ``packages.once(InstalledIndex)`` is the one of a run."""

    __slots__ = ("_found", "_having", "_packages")

    def __init__(self, packages: Packages) -> None:
        self._packages = packages
        self._having: dict[None, tuple[Mapping[str, Sequence[str]], Looked]] = {}
        self._found: dict[str, tuple[Installed, Looked]] = {}

    def of(self, package: Package) -> Installed:
        """What ``package`` installs. Never raises."""
        return remembered(self._found, package.directory, lambda: installed(package, self._packages))

    def having(self, name: str) -> Sequence[str]:
        """The packages of the workspaces, by name and sorted, that have a program called just ``name``; all are looked at."""
        return remembered(self._having, None, self._programs).get(name, [])

    def _programs(self) -> Mapping[str, Sequence[str]]:
        return packages_having(self._packages, lambda package: self.of(package).libexec)


def installed(package: Package, packages: Packages) -> Installed:
    """What ``package`` installs, by its build type; unknown for those that ament does not build. Never raises."""
    if is_installed(package.directory):
        return of_prefix(package)
    types = () if package.manifest is None else package.manifest.under(ROS2).build_types
    if types == ("ament_cmake",):
        return _by_cmake(package, packages)
    if types == ("ament_python",):
        return installed_by_python(package)
    return unknown(package, f"its build type is {', '.join(types) or 'not known'}")


def _by_cmake(package: Package, packages: Packages) -> Installed:
    files, _ = files_of(package.directory)

    def exported(name: str) -> Exported | None:
        other = packages.get(name, package.directory)
        return None if other is None or is_installed(other.directory) else exported_commands(other.directory)

    depended = package.manifest.build_dependencies if package.manifest is not None else ()
    return installed_by_cmake(package, read_cmake(package.directory, lambda: list(files), exported, ament=True, depended=depended))


def installed_by_cmake(package: Package, facts: CMakeFacts) -> Installed:
    """What a package of build type ``ament_cmake`` installs, by what its CMake files say. Never raises."""
    files, complete = files_of(package.directory)
    scripts, reasons = _scripts(facts)
    return of_cmake(package, facts, files, scripts, reasons if complete else [*reasons, "the package has too many files"])


def _scripts(facts: CMakeFacts) -> tuple[list[Script], list[str]]:
    scripts: list[Script] = []
    reasons: list[str] = []
    for install in facts.script_installs:
        read = read_setup_cfg(install.file)
        try:
            scripts += entry_points(() if read is None else read.scripts, os.path.dirname(install.file), install.destination)
        except ValueError as error:
            reasons.append(str(error))
        if read is None:
            reasons.append("setup.cfg cannot be read")
    return scripts, reasons


def installed_by_python(package: Package) -> Installed:
    """What a package of build type ``ament_python`` installs. Never raises."""
    from launchlint.workspace.ament.setup_py import read_setup

    found = read_setup(package.directory)
    return of_files(package, found.installs, found.reasons, found.scripts, found.script_reasons)

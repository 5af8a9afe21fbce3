"""Which nodelet classes the packages that are here export, each looked at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from launchlint.workspace.looking import Looked, remembered
from launchlint.workspace.nodelets import read_nodelet_classes
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages


class ExportedNodelets:
    """The classes in the plugin descriptions of all packages that are here: any package may export any class name."""

    def __init__(self, packages: Packages) -> None:
        self._packages = packages
        self._of_package: dict[str, tuple[tuple[Sequence[str], Sequence[str]], Looked]] = {}
        self._everywhere: dict[None, tuple[tuple[Mapping[str, str], bool], Looked]] = {}

    def of_package(self, package: Package) -> tuple[Sequence[str], Sequence[str]]:
        """The classes that ``package`` exports, sorted, and the reasons why there may be more."""
        return remembered(self._of_package, package.directory, lambda: _read(package))

    def everywhere(self) -> tuple[Mapping[str, str], bool]:
        """Each class that any package here exports → the package, and whether all descriptions could be read."""
        return remembered(self._everywhere, None, self._read_everywhere)

    def _read_everywhere(self) -> tuple[Mapping[str, str], bool]:
        found: dict[str, str] = {}
        readable = True
        for package in [package for place in self._packages.places for package in place.everything]:
            classes, reasons = self.of_package(package)
            readable = readable and not reasons
            for name in classes:
                found.setdefault(name, package.name)
        return found, readable


def _read(package: Package) -> tuple[Sequence[str], Sequence[str]]:
    classes, reasons = read_nodelet_classes(package)
    return list(classes), reasons


def exported_nodelets(packages: Packages) -> ExportedNodelets:
    """What ``packages`` export."""
    return packages.once(ExportedNodelets)

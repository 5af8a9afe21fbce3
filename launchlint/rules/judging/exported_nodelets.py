"""Which nodelet classes the packages that are here export, each looked at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from launchlint.workspace.nodelets import read_nodelet_classes
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages


class ExportedNodelets:
    """The classes in the plugin descriptions of all packages that are here: any package may export any class name."""

    def __init__(self, packages: Packages) -> None:
        self._packages = packages
        self._of_package: dict[str, tuple[Sequence[str], Sequence[str]]] = {}
        self._everywhere: tuple[dict[str, str], bool] | None = None

    def of_package(self, package: Package) -> tuple[Sequence[str], Sequence[str]]:
        """The classes that ``package`` exports, sorted, and the reasons why there may be more."""
        if package.directory not in self._of_package:
            classes, reasons = read_nodelet_classes(package)
            self._of_package[package.directory] = (list(classes), reasons)
        return self._of_package[package.directory]

    def everywhere(self) -> tuple[Mapping[str, str], bool]:
        """Each class that any package here exports → the package, and whether all descriptions could be read."""
        if self._everywhere is None:
            found: dict[str, str] = {}
            readable = True
            for package in [package for place in self._packages.places for package in place.everything]:
                classes, reasons = self.of_package(package)
                readable = readable and not reasons
                for name in classes:
                    found.setdefault(name, package.name)
            self._everywhere = (found, readable)
        return self._everywhere


def exported_nodelets(packages: Packages) -> ExportedNodelets:
    """What ``packages`` export."""
    return packages.once(ExportedNodelets)

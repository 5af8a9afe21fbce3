"""Packages of one workspace that have the same name."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Sequence

from launchlint.workspace.looking import is_file

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.package import Package
    from launchlint.workspace.packages import Packages


_NOT_BUILT = "COLCON_IGNORE"
_MOST_ABOVE = 7
"""Directories above a package in which one is looked for; those of an install space lie deeper than those of sources."""


def built_together(copies: Sequence[Package]) -> list[list[Package]]:
    """``copies`` of one name, those together that one catkin would build; what is built for ROS 2 only (ament) is left out.

    So is what a ``COLCON_IGNORE`` sets aside, there or above: it is kept in a workspace of ROS 2, as all that this one installs.
    """
    return _by_source_space(
        copy for copy in copies if (copy.manifest is None or not copy.manifest.is_ament) and not _is_set_aside(copy.directory)
    )


def _is_set_aside(directory: str) -> bool:
    """Whether the nearest directories around hold a ``COLCON_IGNORE``."""
    for _ in range(_MOST_ABOVE):
        if is_file(posixpath.join(directory, _NOT_BUILT)):
            return True
        directory = posixpath.dirname(directory)
    return False


def built_together_by_colcon(copies: Iterable[Package]) -> list[list[Package]]:
    """``copies`` of one name, as colcon finds them, those together that it would build in one workspace of ROS 2.

    One that catkin builds, too, is left out: who keeps both sides by side sets the other one aside before building.
    """
    return _by_source_space(copy for copy in copies if copy.manifest is not None and copy.manifest.is_ament)


def _by_source_space(copies: Iterable[Package]) -> list[list[Package]]:
    together: dict[str, list[Package]] = {}
    for copy in copies:
        together.setdefault(_source_space(copy), []).append(copy)
    return list(together.values())


def first_of_name(package: Package, packages: Packages) -> Package:
    """The package that is built together with ``package`` and stands before it under the same name; else ``package`` itself."""
    for built in built_together(packages.duplicates().get(package.name, ())):
        if any(each.directory == package.directory for each in built[1:]):
            return built[0]
    return package


def _source_space(package: Package) -> str:
    """The nearest directory called ``src`` above the package: a repository of exercises has a workspace for each."""
    start, separator, _ = package.directory.rpartition("/src/")
    return start + separator

"""Paths that lead out of the directory that a package of ROS 2 is installed to: where they end is not told by where its sources lie."""

from __future__ import annotations

import posixpath

from launchlint.workspace.packages import Packages

_UP = "/../"


def leads_out(file: str, packages: Packages) -> str:
    """The package out of whose directory ``file`` (as it is made, with ``..``) leads; empty where it leads out of none.

    What launch finds below ``find-pkg-share`` is installed: four levels up from there is the workspace, and not what is around the sources.
    """
    start, up, _ = file.partition(_UP)
    package = packages.package_of(f"{start}/package.xml") if up else None
    if package is None:
        return ""
    inside = f"{posixpath.normpath(file)}/".startswith(f"{package.directory.rstrip('/')}/")
    return "" if inside else package.name


def where(package: str) -> str:
    """What to say of it."""
    return f"the path leads out of where {package} is installed to, which is another place than that of its sources"

"""Paths that lead out of the directory that a package of ROS 2 is installed to: where they end is not told by where its sources lie."""

from __future__ import annotations

import posixpath

from launchlint.rules.judging.other_file import is_inside
from launchlint.source import Place
from launchlint.workspace.packages import Packages

_UP = "/../"
_NEAREST = 3
"""Directories around a workspace below which nothing is meant by a path that is not written out."""


def leads_out(file: str, near: Place, packages: Packages) -> str:
    """The package out of whose directory ``file`` (as it is made, with ``..``) leads, or that of ``near``, where the path is worked out and
    leads to the directories around the workspace; empty where it does neither.

    What launch finds below ``find-pkg-share`` is installed: four levels up from there is the workspace, and not what is around the sources.
    """
    start, up, _ = file.partition(_UP)
    package = packages.package_of(f"{start}/package.xml") if up else None
    target = posixpath.normpath(file)
    if package is not None:
        return "" if f"{target}/".startswith(f"{package.directory.rstrip('/')}/") else package.name
    home = packages.package_of(near.source.file)
    if home is None or not near.source.path.endswith(".py") or is_inside(target, packages.workspaces):
        return ""
    if up and start == posixpath.dirname(home.directory):  # up from share, in which the package is installed beside others
        return home.name
    for root in packages.workspaces:
        around = root
        for _ in range(_NEAREST):
            around = posixpath.dirname(around)
            if around.count("/") > 1 and target.startswith(f"{around}/") and around not in near.source.text:
                return home.name
    return ""


def where(package: str) -> str:
    """What to say of it."""
    return f"the path leads out of where {package} is installed to, which is another place than that of its sources"

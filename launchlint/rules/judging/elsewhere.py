"""Where else in its package the file is that was looked for."""

from __future__ import annotations

import posixpath
from itertools import islice

from launchlint.rules.judging.package_contents import contents
from launchlint.rules.view import LaunchView
from launchlint.spelling import differs_in_meaning
from launchlint.workspace.looking import is_file, names
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.put_aside import is_out_of_use

_MOST_PACKAGES = 500


def elsewhere(path: str, package: Package, view: LaunchView) -> str | None:
    """What was probably meant by ``path`` (absolute, in ``package``, not there); ``None`` where nothing is like it.

    That is the only file of this name in the package, or else the only one in its directory whose name has more, or fewer, words.
    """
    directory, name = posixpath.split(path)
    same = [posixpath.join(parent, name) for parent, listed in contents(view.packages).directories(package) if name in listed]
    if len(same) == 1 and not is_out_of_use(same[0], path):
        return posixpath.relpath(same[0], package.directory)
    stem, ending = posixpath.splitext(name)
    others = ((other, other.removesuffix(ending)) for other in names(directory) if other.endswith(ending))
    longer = [other for other, words in others if _goes_on(words, stem) or _goes_on(stem, words)]
    return longer[0] if len(longer) == 1 and not differs_in_meaning(longer[0], name) else None


def in_another_package(path: str, package: Package, packages: Packages) -> str:
    """The only other package of the workspaces that has a file at the same path as ``path`` (absolute) has in ``package``; else empty."""
    found = _others(posixpath.relpath(path, package.directory), package, packages)
    return found[0].name if len(found) == 1 else ""


def file_in_another_package(path: str, package: Package, packages: Packages) -> str | None:
    """The file (absolute) that only one other package has there; else None."""
    inside = posixpath.relpath(path, package.directory)
    found = _others(inside, package, packages)
    return posixpath.join(found[0].directory, inside) if len(found) == 1 else None


def _others(inside: str, package: Package, packages: Packages) -> list[Package]:
    if inside.startswith(".."):
        return []
    others = (each for place in packages.places[: len(packages.workspaces)] for each in place.everything if each.name != package.name)
    return [each for each in islice(others, _MOST_PACKAGES) if is_file(posixpath.join(each.directory, inside))]


def _goes_on(longer: str, stem: str) -> bool:
    return longer.startswith((f"{stem}_", f"{stem}-"))

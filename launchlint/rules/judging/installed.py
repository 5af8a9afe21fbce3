"""Files that a package holds elsewhere, and that its build may install to the place where they are looked for."""

from __future__ import annotations

import posixpath

from launchlint.rules.judging.other_file import is_inside, shown
from launchlint.rules.judging.package_contents import contents
from launchlint.workspace.looking import is_file
from launchlint.workspace.packages import Packages
from launchlint.workspace.put_aside import is_out_of_use

ONLY_INSTALLED = "it is there from the install space only: {} puts {} at this place"
"""A note, with the build file and the file of the sources."""
IN_BOTH = "install {} to where it lies in the sources, and name it so: then it is found in a devel space, too"


def installed_from(file: str, packages: Packages) -> str | None:
    """The one file of the same package that bears the name of ``file``, which is not there, in a directory of the same name, where the
    package installs that one, or may for all that can be read of its build; else None.

    ``install(DIRECTORY test/yaml DESTINATION share/pkg)`` in CMakeLists.txt makes ``$(find pkg)/yaml/a.yaml`` right once the package is
    installed.
    """
    directory, name = posixpath.split(posixpath.abspath(file))
    package = packages.package_of(directory)
    if package is None or directory == package.directory:
        return None
    last = posixpath.basename(directory)
    found = [
        posixpath.join(parent, name)
        for parent, listed in contents(packages).directories(package)
        if posixpath.basename(parent) == last and name in listed and not is_out_of_use(f"{parent}/{name}", file)
    ]
    if len(found) != 1:
        return None
    installs = contents(packages).installs(package)
    return found[0] if installs.covers(found[0]) or not installs.exhaustive else None


def installed_at(file: str, packages: Packages) -> str | None:
    """The file of the sources (absolute) that an ``install()`` of its package puts at just the place of ``file``, which is not there; else
    None. Where a package is found by its name, ``share/PKG`` of the install space is what its sources are in a devel space (catkin).
    """
    file = posixpath.abspath(file)
    package = packages.package_of(file)
    if package is None or not package.name or not is_inside(file, packages.workspaces):
        return None
    from launchlint.workspace.ament.placed import sources_of

    place = f"share/{package.name}/{posixpath.relpath(file, package.directory)}"
    return next((each for each in sources_of(contents(packages).installs(package).installs, place) if is_file(each)), None)


def says_installed(source: str, packages: Packages, root: str) -> tuple[str, str]:
    """The note and the help on what :func:`installed_at` gives."""
    package = packages.package_of(source)
    cmake = "CMakeLists.txt" if package is None else shown(posixpath.join(package.directory, "CMakeLists.txt"), root)
    return ONLY_INSTALLED.format(cmake, shown(source, root)), IN_BOTH.format(posixpath.basename(source))

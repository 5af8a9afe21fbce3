"""Files that a package holds elsewhere, and that its build may install to the place where they are looked for."""

from __future__ import annotations

import posixpath

from launchlint.rules.judging.package_contents import contents
from launchlint.workspace.packages import Packages
from launchlint.workspace.put_aside import is_out_of_use


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

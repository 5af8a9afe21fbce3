"""A launch file among the tests of a package that nothing starts: data for another test, or what is left of one."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping

from launchlint.late import late
from launchlint.workspace.looking import Looked, is_file, note, walk, watched
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.registered_tests import CMAKE_FILE, TEST_END, registering
from launchlint.workspace.texts import texts

_TESTS = late(r"(?:^|/)tests?/")
_SEVERAL = "${"
"""What is registered here is called by names that cannot be seen."""
_NAMED = late(r"(?<![\w.-])\.*([\w-][\w.-]*\.(?:launch|xml)\b(?:\.xml\b)?)")
_STARTS = late(r"roslaunch|rostest")
_LAUNCH_ENDS = (".launch", ".xml", TEST_END)
_TELLS = (".md", ".rst", ".txt", ".yml", ".yaml")
_MOST_DIRECTORIES = 200
_MOST_FILES = 600
_MOST_NAMING = 5


def why_idle(file: str, home: Package, packages: Packages) -> str:
    """Why nothing of package ``home`` starts the launch ``file``, which lies among its tests, for people; empty where something may.

    It is started by ``CMakeLists.txt`` (its name, or a directory above it), by a launch file or a document that names it, and by whatever
    calls roslaunch or rostest and names it. Without a
    ``CMakeLists.txt`` it cannot be told. What ends in ``.test`` people start, too.
    """
    absolute = posixpath.abspath(file)
    inside = posixpath.relpath(absolute, home.directory)
    name = posixpath.basename(file)
    if not is_file(posixpath.join(home.directory, CMAKE_FILE)):
        return ""  # what registers the tests is not here
    if name.endswith(TEST_END) or _TESTS.search(inside) is None or inside.startswith(".."):
        return ""
    # By its name, or with a directory that it is in.
    registered = any(_SEVERAL in each.text or each.names_it for each in registering(home.directory, inside))
    if registered or _is_named(name, absolute, home, packages):
        return ""
    return f"nothing of {home.name} starts {inside}, which lies among its tests"


def _is_named(name: str, itself: str, home: Package, packages: Packages) -> bool:
    """Whether a launch file, a document, or whatever calls roslaunch names the file."""
    return any(file != itself for file in naming(name, home, packages))


def naming(name: str, home: Package, packages: Packages) -> tuple[str, ...]:
    """The first few files (absolute) of package ``home`` that name the launch file: launch files, documents, and what calls roslaunch."""
    known = packages.once(_known)
    if home.directory not in known:
        known[home.directory] = watched(lambda: _named(home.directory))
    named, looked = known[home.directory]
    note(looked)
    return named.get(name, ())


def _known(packages: Packages) -> dict[str, tuple[Mapping[str, tuple[str, ...]], Looked]]:
    """The launch files that files of each package name, as far as it was asked for, and what that hangs on."""
    return {}


def _named(directory: str) -> Mapping[str, tuple[str, ...]]:
    """Name of a launch file → the first few files below ``directory`` that name it: launch files, documents, and what calls roslaunch."""
    found: dict[str, tuple[str, ...]] = {}
    looked: set[str] = set()
    places = ((parent, [each for each in names if "." in each]) for parent, names in walk(directory, _MOST_DIRECTORIES))
    for file, text in texts(places, _MOST_FILES, looked):
        if not file.endswith((*_LAUNCH_ENDS, *_TELLS)) and _STARTS.search(text) is None:
            continue
        for name in sorted(set(_NAMED.findall(text))):
            found[name] = (*found.get(name, ()), file)[:_MOST_NAMING]
    note(looked)
    return found

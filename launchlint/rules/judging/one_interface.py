"""Launch files of one directory that take the same args, so that whoever includes them can put one in the place of another."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping

from launchlint.workspace.looking import Looked, names, note, watched
from launchlint.workspace.packages import Packages
from launchlint.workspace.texts import parts

_ENDS = (".launch.xml", ".launch.yaml", ".launch.yml", ".launch.py", ".launch", "_launch.py", "_launch.xml", "_launch.yaml")
_MOST_FILES = 40
_Taken = Mapping[str, frozenset[str]]


def taken_beside(file: str, name: str, declared: frozenset[str], packages: Packages) -> str:
    """A launch file beside ``file`` (absolute) that takes the arg ``name`` and reads it, and at least half of all those ``declared`` here.

    Empty where there is none. A file that includes this one is none: it reads the arg to pass it on.
    """
    directory, own = posixpath.split(file)
    known = packages.once(_known)
    if directory not in known:
        known[directory] = watched(lambda: _read(directory))
    taken, looked = known[directory]
    note(looked)
    includes = f"/{own}"
    others = (
        other
        for other, args in taken.items()
        if other != own and name in args and includes not in args and 2 * len(args & declared) >= len(declared)
    )
    return min(others, default="")


def _known(packages: Packages) -> dict[str, tuple[_Taken, Looked]]:
    """What the launch files of each directory take, as far as it was asked for, and what that hangs on."""
    return {}


def _read(directory: str) -> _Taken:
    looked: set[str] = set()
    wanted = [name for name in names(directory) if name.endswith(_ENDS)]
    found = {posixpath.basename(file): frozenset(args) for file, args in parts([(directory, wanted)], _MOST_FILES, looked, "args")}
    note(looked)
    return found

"""Did you mean this file? The nearest name around the place where a file was looked for."""

from __future__ import annotations

import os

from launchlint.spelling import closest
from launchlint.workspace.looking import is_file, names
from launchlint.workspace.put_aside import is_out_of_use

MOST_DIRECTORIES = 50
MOST_LEVELS = 4


def nearby_file(file: str, ending: str = "") -> str | None:
    """The file that was probably meant instead of ``file``, which is not there.

    That is the file of the nearest name in the same directory (its name is returned), else the file of the same name in a directory
    beside it (returned with that directory), else that behind a directory that is misspelt (returned from that directory on). Only names
    that end with ``ending`` count, and nothing that was put aside.
    """
    directory, name = os.path.split(file)
    if not name or "\0" in file:
        return None
    near = closest(name, [other for other in names(directory) if other.endswith(ending)])
    if near is not None:
        return near
    parent, last = os.path.split(directory)
    beside = [(other, os.path.join(parent, other, name)) for other in names(parent)[:MOST_DIRECTORIES] if other != last]
    found = [other for other, path in beside if is_file(path) and not is_out_of_use(path, file)]
    if not parent or not name.endswith(ending):
        return None
    return f"{closest(last, found) or found[0]}/{name}" if found else _behind_misspelt(directory, name)


def _behind_misspelt(directory: str, name: str) -> str | None:
    """The file where the first directory of its path that does not exist is a slip for one that does."""
    outer, rest = directory, name
    for _ in range(MOST_LEVELS):
        outer, last = os.path.split(outer)
        beside = names(outer)[:MOST_DIRECTORIES] if outer and last else []
        if beside:
            near = None if last in beside else closest(last, beside)
            meant = os.path.join(outer, near or last, rest)
            return f"{near}/{rest}" if near and is_file(meant) and not is_out_of_use(meant, os.path.join(directory, name)) else None
        rest = f"{last}/{rest}"
    return None

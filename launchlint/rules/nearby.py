"""Did you mean this file? The nearest name around the place where a file was looked for."""

from __future__ import annotations

import os
from itertools import islice

from launchlint.spelling import closest

MOST_NAMES = 2_000
"""Directory entries that are looked at: a directory may be of any size, and this is only for a hint."""
MOST_DIRECTORIES = 50


def nearby_file(file: str, ending: str = "") -> str | None:
    """The file that was probably meant instead of ``file``, which is not there.

    That is the file of the nearest name in the same directory (its name is returned), else the file of the same name in a directory
    beside it (returned with that directory). Only names that end with ``ending`` count.
    """
    directory, name = os.path.split(file)
    if not name or "\0" in file:
        return None
    near = closest(name, [other for other in _names(directory) if other.endswith(ending)])
    if near is not None:
        return near
    parent, last = os.path.split(directory)
    found = [other for other in _names(parent)[:MOST_DIRECTORIES] if other != last and os.path.isfile(os.path.join(parent, other, name))]
    if not parent or not name.endswith(ending) or not found:
        return None
    return f"{closest(last, found) or found[0]}/{name}"


def _names(directory: str) -> list[str]:
    try:
        with os.scandir(directory or ".") as entries:
            return sorted(entry.name for entry in islice(entries, MOST_NAMES))
    except OSError:
        return []

"""Sources that a repository names and does not hold: git submodules, and the lists of wstool, rosinstall and vcstool.

What they name is put beside this checkout where somebody builds the workspace, so that a package of such a name is not unheard of.
"""

from __future__ import annotations

import os
from collections.abc import Iterable

from launchlint.late import late
from launchlint.spelling import folded
from launchlint.workspace.looking import note, read_bytes

GITMODULES = ".gitmodules"

_MOST_DIRECTORIES = 20_000
_MOST_LISTS = 200
_LONGEST_LINE = 1_000
_MOST_LINES = 5_000

# .gitmodules: path = …, url = …; rosinstall: local-name: …, uri: …; vcstool: a key for each repository, url: …
_GIVEN = late(r"(?<![\w-])(?:path|url|uri|local-name)['\"]?\s{0,9}[=:]\s{0,9}['\"]?([^\s'\",}]+)")
_KEY = late(r"\s+['\"]?([\w./~-]+)['\"]?\s*:\s*(?:#.*)?$")


def is_source_list(name: str) -> bool:
    """Whether a file of this name lists sources: ``.gitmodules``, ``*.repos``, ``*.rosinstall`` and ``*.rosinstall.noetic``."""
    return name == GITMODULES or name.endswith(".repos") or ".rosinstall" in name


def read_source_lists(roots: Iterable[str]) -> dict[str, str]:
    """The last parts of all names, paths and addresses in the lists below ``roots``, folded, each with the list (absolute).

    Hidden directories are passed over and links to directories not followed. Never raises.
    """
    found: dict[str, str] = {}
    for file in _lists(roots):
        try:
            text = read_bytes(file).decode("utf-8", "replace")
        except OSError:
            continue
        for line in text.splitlines()[:_MOST_LINES]:
            start = line[:_LONGEST_LINE]
            if start.lstrip().startswith(("#", ";")):
                continue
            key = _KEY.match(start) if file.endswith(".repos") else None
            for name in [key[1]] if key is not None else _GIVEN.findall(start):
                found.setdefault(folded(name.rstrip("/").rpartition("/")[2].rpartition(":")[2].removesuffix(".git")), file)
    return found


def _lists(roots: Iterable[str]) -> list[str]:
    """The lists below ``roots``, in the order of a sorted walk; of very many only the first."""
    found: dict[str, None] = {}
    left = _MOST_DIRECTORIES
    for root in roots:
        for directory, below, files in os.walk(root):
            note((directory,))
            below[:] = sorted(name for name in below if not name.startswith("."))
            found.update((os.path.join(directory, name), None) for name in sorted(files) if is_source_list(name))
            left -= 1
            if left <= 0 or len(found) >= _MOST_LISTS:
                return list(found)[:_MOST_LISTS]
    return list(found)

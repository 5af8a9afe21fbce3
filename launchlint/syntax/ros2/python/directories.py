"""What there is below a directory of the workspace, as patterns of file names find it (``glob`` and ``pathlib``)."""

from __future__ import annotations

import posixpath
from fnmatch import fnmatchcase

from launchlint.workspace import looking

MOST_DIRECTORIES = 2_000
_WILD = frozenset("*?[")


def fitting(directory: str, pattern: str, *, hidden: bool, recursive: bool) -> list[str] | None:
    """The paths that fit a pattern below a directory, sorted; None where there are too many to be looked at.

    ``hidden``: a wildcard stands for names that begin with a point, too. ``recursive``: ``**`` stands for all directories below.
    """
    found = [directory]
    for part in (each for each in pattern.split("/") if each not in ("", ".")):
        following: list[str] = []
        for base in found:
            if part == "**" and recursive:
                below = [each for each, _ in looking.walk(base, MOST_DIRECTORIES)]
                if len(below) >= MOST_DIRECTORIES:
                    return None
                following += below
            elif _WILD & set(part):
                names = looking.names(base) if looking.is_directory(base) else []
                if len(names) >= looking.MOST_NAMES:
                    return None
                following += [posixpath.join(base, name) for name in names if _fits(name, part, hidden=hidden)]
            elif looking.exists(posixpath.join(base, part)):
                following.append(posixpath.join(base, part))
        found = list(dict.fromkeys(following))
    return sorted(found)


def split(pattern: str) -> tuple[str, str]:
    """A pattern as the directory in front of its first wildcard, and the rest; the directory is empty where there is no wildcard."""
    parts = pattern.split("/")
    first = next((at for at, part in enumerate(parts) if _WILD & set(part)), None)
    return ("", pattern) if first is None else ("/".join(parts[:first]) or "/", "/".join(parts[first:]))


def _fits(name: str, part: str, *, hidden: bool) -> bool:
    return fnmatchcase(name, part) and (hidden or not name.startswith(".") or part.startswith("."))

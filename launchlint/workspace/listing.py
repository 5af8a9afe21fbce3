"""All files below a directory: what the build of a package and the search for its programs look at."""

from __future__ import annotations

import os

MOST_FILES = 20_000
SOURCE_ENDS = frozenset(".c .c++ .cc .cmake .cpp .cu .cxx .h .h++ .hh .hpp .hxx .in .ipp .py .txt".split())
"""Ends of the names of files that what nodes do is read from."""
_MORE_ENDS = frozenset(("", ".cfg", ".xml"))


def may_be_source(path: str) -> bool:
    """Whether what a node does, or what a package builds, may be read from a file of this name."""
    return os.path.splitext(path)[1].lower() in SOURCE_ENDS | _MORE_ENDS


def files_of(directory: str) -> tuple[dict[str, int], bool]:
    """All files below ``directory`` (relative, with ``/``, sorted by directory) with their mode bits, and whether that is all of them.

    Hidden directories are left out and links to directories followed, as in roslib.packages.
    """
    found: dict[str, int] = {}
    pending = [""]
    seen: set[tuple[int, int]] = set()
    try:
        status = os.stat(directory)
        seen.add((status.st_dev, status.st_ino))
    except OSError:
        return {}, False
    while pending:
        relative = pending.pop()
        below: list[str] = []
        try:
            with os.scandir(os.path.join(directory, relative)) as scan:
                entries = sorted(scan, key=lambda entry: entry.name)
        except OSError:
            continue
        for entry in entries:
            name = f"{relative}/{entry.name}" if relative else entry.name
            try:
                if entry.is_dir():
                    status = entry.stat()
                    if entry.name[0] != "." and (status.st_dev, status.st_ino) not in seen:
                        seen.add((status.st_dev, status.st_ino))
                        below.append(name)
                else:
                    found[name] = entry.stat().st_mode if entry.is_file() else 0
            except OSError:
                continue
            if len(found) > MOST_FILES:
                return found, False
        pending += reversed(below)
    return found, True

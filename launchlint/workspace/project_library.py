"""The libraries that a project keeps for itself: what was probed once is known to every command and everybody who has the repository."""

from __future__ import annotations

import os
from collections.abc import Sequence

DIRECTORY = ".launchlint"
"""Of the repository's root."""
PROBED = "probed.json"
"""What ``launchlint probe --unknown`` writes there."""
MOST_FILES = 50


def project_directory(path: str) -> str:
    """Where the libraries of the project around ``path`` are, or would be; absolute."""
    from launchlint.workspace.repository import repository_root

    return os.path.join(repository_root(path), DIRECTORY)


def project_libraries(paths: Sequence[str]) -> tuple[str, ...]:
    """The library files of the projects around ``paths``, absolute and sorted by name; nothing that a link names elsewhere."""
    found: dict[str, None] = {}
    for directory in dict.fromkeys(project_directory(path) for path in paths):
        try:
            names = sorted(name for name in os.listdir(directory) if name.endswith(".json"))[:MOST_FILES]
        except OSError:
            continue
        files = [os.path.join(directory, name) for name in names]
        if not os.path.islink(directory):
            found.update(dict.fromkeys(file for file in files if os.path.isfile(file) and not os.path.islink(file)))
    return tuple(found)

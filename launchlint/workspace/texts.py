"""Texts of a workspace that are looked through for a word: bounded in number and size, and noted for the cache."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence

from launchlint.workspace.looking import content

LARGEST = 200_000
"""Bytes of a file that are looked through."""


def texts(places: Iterable[tuple[str, Sequence[str]]], most: int, looked: set[str]) -> Iterator[tuple[str, str]]:
    """File (absolute) and text of the first ``most`` files of ``places``, which are directories with the names that are wanted of each.

    ``looked`` gets all directories, and the files that were read: what is found hangs on them. Never raises.
    """
    for directory, wanted in places:
        looked.add(directory)
        for name in wanted:
            if most <= 0:
                break
            most -= 1
            file = os.path.join(directory, name)
            looked.add(file)
            yield file, (content(file) or b"")[:LARGEST].decode("utf-8", "replace")

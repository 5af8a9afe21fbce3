"""The launch files of a workspace by their names without directories: where a file that is missing in one place may lie instead."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import walk

_ENDS = (".launch", ".launch.xml", ".test")
_MOST_DIRECTORIES = 4_000
_MOST_ALIKE = 20


class LaunchFiles(NamedTuple):
    """By name without directories the first files (absolute) of that name, in order; and the directories that were looked at."""

    known: Mapping[str, tuple[str, ...]]
    looked: frozenset[str]


def read_launch_files(directories: Iterable[str]) -> LaunchFiles:
    """The launch files below ``directories``. Bounded; never raises."""
    found: dict[str, list[str]] = {}
    looked: set[str] = set()
    for top in directories:
        for directory, listed in walk(top, _MOST_DIRECTORIES):
            looked.add(directory)
            for name in listed:
                if name.endswith(_ENDS) and len(found.setdefault(name, [])) < _MOST_ALIKE:
                    found[name].append(os.path.join(directory, name))
    return LaunchFiles({name: tuple(files) for name, files in found.items()}, frozenset(looked))

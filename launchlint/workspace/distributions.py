"""Which ROS distributions a workspace says it is for: in its README, continuous integration, images and scripts. Nothing is run."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from launchlint.workspace.looking import names, walk
from launchlint.workspace.texts import texts

_MOST_DIRECTORIES = 400
_MOST_FILES = 300
_WORKFLOWS = os.path.join(".github", "workflows")
_ENDS = (".yml", ".yaml", ".sh", ".bash", ".rosinstall", ".repos", ".dockerfile")
_NAMED = re.compile(r"(?<![A-Za-z])(fuerte|groovy|hydro|indigo|jade|kinetic|lunar|melodic|noetic)(?![A-Za-z])", re.IGNORECASE)


class Distributions(NamedTuple):
    """The distributions of ROS 1 that are named (small letters), and the places that were looked at."""

    named: frozenset[str]
    looked: frozenset[str]


def read_distributions(directories: Iterable[str]) -> Distributions:
    """The distributions that files below ``directories`` name. Bounded; never raises."""
    looked: set[str] = set()
    found = {name.lower() for _, text in texts(_places(directories), _MOST_FILES, looked) for name in _NAMED.findall(text)}
    return Distributions(frozenset(found), frozenset(looked))


def _places(directories: Iterable[str]) -> Iterator[tuple[str, list[str]]]:
    for top in directories:
        workflows = os.path.join(top, _WORKFLOWS)
        for directory, listed in ((workflows, names(workflows)), (top, names(top)), *walk(top, _MOST_DIRECTORIES)):
            yield directory, [name for name in listed if name.lower().startswith(("readme", "dockerfile")) or name.lower().endswith(_ENDS)]

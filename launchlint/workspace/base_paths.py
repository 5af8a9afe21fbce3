"""Directories below which a workspace's own images, workflows and scripts let colcon look for packages: ``colcon build --base-paths …``.

Nothing is run. colcon looks for packages below each base path (colcon-recursive-crawl), wherever that lies: also inside of a package, below
which it does not look otherwise.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import walk
from launchlint.workspace.texts import texts

_MOST_DIRECTORIES = 1_000
_MOST_FILES = 300
_HIDDEN = (".github", ".devcontainer", ".docker", ".ci")
_ENDS = (".sh", ".bash", ".yml", ".yaml", ".mk", ".dockerfile", "Makefile", "makefile", "justfile", "Justfile", "Jenkinsfile")
_OPTION = "--base-paths"
_OPTIONS = late(rf"{_OPTION}[ \t=]([^\n;&|]{{1,600}})")


class BasePaths(NamedTuple):
    """The last name of each base path (``src`` of ``/tmp/build/src``), and what was looked at (absolute)."""

    ends: frozenset[str]
    looked: frozenset[str]


def read_base_paths(directories: Iterable[str]) -> BasePaths:
    """The last names of the base paths that are written below ``directories``. Bounded; never raises."""
    found: set[str] = set()
    looked: set[str] = set()
    for _, text in texts(_places(directories), _MOST_FILES, looked):
        if _OPTION in text:
            for words in _OPTIONS.findall(text.replace("\\\n", " ")):
                found.update(_names(words))
    return BasePaths(frozenset(found), frozenset(looked))


def leads_below(outer: str, inner: str, paths: BasePaths) -> bool:
    """Whether one of the base paths may be a directory between those of the packages ``outer`` and ``inner`` (absolute), or ``inner``."""
    return not paths.ends.isdisjoint(os.path.relpath(inner, outer).split(os.sep))


def _names(words: str) -> Iterator[str]:
    for word in words.split():
        if word.startswith("-"):
            return
        name = word.strip("\"'`").rstrip("/*").rpartition("/")[2]
        if name not in ("", ".", ".."):
            yield name


def _places(directories: Iterable[str]) -> Iterator[tuple[str, list[str]]]:
    for top in directories:
        hidden = (each for name in _HIDDEN for each in walk(os.path.join(top, name), _MOST_DIRECTORIES))
        for directory, listed in (*hidden, *walk(top, _MOST_DIRECTORIES)):
            yield directory, [name for name in listed if name.startswith("Dockerfile") or name.endswith(_ENDS)]

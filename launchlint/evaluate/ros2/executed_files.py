"""What follows from which files a launch executes and what these are passed, and from nothing else.

Most configurations of an entry file execute the same files, so that it is taken over from one to the next.
"""

from __future__ import annotations

from functools import cached_property

from launchlint.evaluate.ros2.names_read import names_of
from launchlint.evaluate.ros2.passing import useless
from launchlint.model import ListedArgument

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.names_read import Names
    from launchlint.evaluate.ros2.walk import Walk
    from launchlint.problem import Problem
    from launchlint.syntax.ros2.description import Description

_PYTHON = ".py"
MOST_KEPT = 6
"""Sets of files of one entry file; the oldest goes first."""


class ExecutedFiles:
    """The files that were executed when a walk through the ``root`` had come to its end.

    ``listed`` are the args as people are shown them.
    """

    def __init__(self, walk: Walk, root: Description) -> None:
        self._session = walk.session
        self._root = root
        self._entered = tuple(walk.entered)
        self._executed = tuple(walk.executed.items())
        self._environment = dict(walk.context.environment.changes)
        self._below: dict[tuple[int, ...], list[Names] | None] = {}
        self.listed = tuple(
            ListedArgument(shown.argument.name, shown.argument.default is None, shown.conditional, shown.argument.place)
            for shown in walk.lister.list_executed(root, walk.executed).values()
        )

    def fits(self, walk: Walk, root: Description) -> bool:
        """Whether ``walk`` has executed the same files in the same order, passed them the same args, and left the same environment."""
        return (
            self._root is root
            and len(self._entered) == len(walk.entered)
            and len(self._executed) == len(walk.executed)
            and self._environment == walk.context.environment.changes
            and all(walk.executed.get(way) is description for way, description in self._executed)
            and self._entered == tuple(walk.entered)
        )

    @cached_property
    def useless(self) -> tuple[Problem, ...]:
        """Args that are passed or declared for nothing."""
        return tuple(useless(list(self._entered), self._session))

    def names_below(self, way: tuple[int, ...]) -> list[Names] | None:
        """What a file and those that it includes declare and set, under whatever condition; None where that may be anything."""
        if way not in self._below:
            self._below[way] = self._names_below(way)
        return self._below[way]

    def _names_below(self, way: tuple[int, ...]) -> list[Names] | None:
        if any(each.description is None and each.way[: len(way)] == way for each in self._entered):
            return None
        descriptions = [description for other, description in self._executed if other[: len(way)] == way]
        found = [self._session.once(description, names_of) for description in descriptions]
        return None if any(names.open and is_python(each) for names, each in zip(found, descriptions, strict=True)) else found


def is_python(description: Description) -> bool:
    """Whether a file is a program: what it reads cannot be told from what it describes."""
    return description.place.source.file.endswith(_PYTHON)


def executed_files(walk: Walk, root: Description) -> ExecutedFiles:
    """The files that a walk has executed: those of an earlier configuration of the entry file, where they are the same."""
    if walk.repeats is None:
        return ExecutedFiles(walk, root)
    kept = walk.repeats.files
    for each in kept:
        if each.fits(walk, root):
            return each
    made = ExecutedFiles(walk, root)
    kept.insert(0, made)
    del kept[MOST_KEPT:]
    return made

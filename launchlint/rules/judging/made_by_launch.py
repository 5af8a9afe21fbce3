"""A file that is not here since another launch file of its package makes it: one step of several that people start in turn."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping
from itertools import islice

from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.made_by_node import Word, absolute, handed_over
from launchlint.syntax.ros1.substitutions import opens
from launchlint.workspace.looking import Looked, note, walk, watched
from launchlint.workspace.packages import Packages
from launchlint.workspace.texts import parts

_LAUNCH_ENDS = (".launch", ".launch.xml", ".test")
_MOST_DIRECTORIES = 100
_MOST_FILES = 300
_MOST_WRITTEN_TO = 20


class Step(NamedTuple):
    """The launch ``file`` (absolute) that gives ``program``, in line ``line``, the directory to write to."""

    program: str
    file: str
    line: int


_Steps = Mapping[tuple[str, str], Step]


def written_by(path: str, near: str, packages: Packages) -> Step | None:
    """The launch file that probably makes the file at ``path`` (absolute), which the launch file ``near`` asks for; ``None`` if none does.

    That is another one of the same package, which hands over the directory in one word and the name, with its ending or without, in
    another, and says of one of them that it is written.
    """
    package = packages.package_of(path)
    if package is None:
        return None
    known = packages.once(_known)
    if package.directory not in known:
        known[package.directory] = watched(lambda: _read(package.directory, packages))
    steps, looked = known[package.directory]
    note(looked)
    directory, name = posixpath.split(path)
    found = (steps.get((directory, each)) for each in (name, posixpath.splitext(name)[0]))
    return next((step for step in found if step is not None and step.file != posixpath.abspath(near)), None)


def _known(packages: Packages) -> dict[str, tuple[_Steps, Looked]]:
    """What the launch files of each package write, as far as it was asked for, and what that hangs on."""
    return {}


def _read(directory: str, packages: Packages) -> _Steps:
    found: dict[tuple[str, str], Step] = {}
    listed = (
        (parent, [name for name in sorted(names) if name.endswith(_LAUNCH_ENDS)]) for parent, names in walk(directory, _MOST_DIRECTORIES)
    )
    looked: set[str] = set()
    for file, writing in parts(listed, _MOST_FILES, looked, "writing"):
        for text in writing:
            for key, step in _written(file, text, packages):
                found.setdefault(key, step)
    note(looked)
    return found


def _written(file: str, text: str, packages: Packages) -> Iterator[tuple[tuple[str, str], Step]]:
    """Each directory and name that a launch file hands over, where one of the two is there to be written."""
    words = list(handed_over(text))
    names = [word for word in words if word.value and "/" not in word.value and not opens(word.value)]
    if not any(word.writes for word in words):
        return
    for word in islice(_directories(words), _MOST_WRITTEN_TO):
        directory = absolute(word.value, file, packages)
        if not directory.startswith("/"):
            continue
        step = Step(word.program, file, text.count("\n", 0, word.start) + 1)
        for name in names:
            if word.writes or name.writes:
                yield (directory, name.value), step


def _directories(words: list[Word]) -> Iterator[Word]:
    """The words that may name a directory to write to: of a node, or of a param that says so; each value once."""
    told: set[str] = set()
    for word in words:
        if (word.is_node or word.writes) and "/" in word.value and word.value not in told:
            told.add(word.value)
            yield word

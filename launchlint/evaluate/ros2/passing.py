"""Which args nothing can read: ROS 2 launch keeps all launch configurations in one place, so that any file executed later may.

What is passed to an include stays set for what follows it, and what a file declares is seen by all that it includes. So an arg is
useless only where neither the files executed from there on nor the rest of those around can read it, taken branch or not.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator

from launchlint.evaluate.ros2.names_read import OF_LAUNCH, Names, names_of, names_of_refused
from launchlint.evaluate.ros2.problems import ArgUnused, PassedForNothing
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.source import Origin
from launchlint.syntax.ros2.description import Description

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    from launchlint.evaluate.session import Session
    from launchlint.source import IncludeStep

    Readers = Literal["some", "perhaps", "none"]
_MOST_WORK = 200_000


class Entered(NamedTuple):
    """A file that was executed, by the includes that led to it (``way``: each by its identity; ``step``), with what it was ``passed``.

    ``refused``: launch cannot read it. Without ``description`` it is not known what it reads.
    """

    way: tuple[int, ...]
    step: IncludeStep | None
    description: Description | None
    passed: tuple[tuple[str, Origin], ...]
    shown: str
    refused: bool = False


def useless(entered: list[Entered], session: Session) -> Iterator[Problem]:
    """Args that are passed or declared for nothing, in the order in which the files were executed."""
    files = _Files(entered, session)
    if files.work() > _MOST_WORK:
        return
    files.prepare()
    for index, each in enumerate(entered):
        if each.description is None:
            continue
        for name, origin in each.passed:
            if name in OF_LAUNCH or name.startswith("anon"):
                continue
            below = files.below(index, name)
            after = files.after(index, name) if below == "none" else "some"
            if after != "some":
                known = tuple(sorted(files.known_below(index)))
                yield PassedForNothing(origin=origin, name=name, file=each.shown, known=known, certain=after == "none")
        names = files.names(index)
        for argument in names.arguments if names is not None else ():
            if names is None or argument.name in names.read or names.open or argument.name in OF_LAUNCH:
                continue
            if files.below(index, argument.name, own=False) == "none" and files.after(index, argument.name) == "none":
                yield ArgUnused(
                    origin=Origin(argument.place, each.step), name=argument.name, description=argument.description, alone=names.alone
                )


class _Files:
    """The files that were executed, each by its place among them."""

    def __init__(self, entered: list[Entered], session: Session) -> None:
        self._entered = entered
        self._session = session
        self._at = {each.way: index for index, each in enumerate(entered)}
        self._names = [self._names_of(each) for each in entered]
        self._passed = [frozenset(name for name, _ in each.passed) for each in entered]

    def prepare(self) -> None:
        """Find what all questions are answered from."""
        self._first, self._last = self._numbers()
        self._missing = [self._last_missing(index) for index in range(len(self._entered))]
        self._readers: dict[str, list[int]] = {}
        for at, names in enumerate(self._names):
            for name in () if names is None else names.read.keys() | names.declared.keys():
                self._readers.setdefault(name, []).append(at)
        unsure = (at for at, names in enumerate(self._names) if names is None or names.open or not self._all_entered(at, -1))
        self._unsure = sorted(unsure, key=self._first.__getitem__)
        self._unsure_first = [self._first[at] for at in self._unsure]

    def _names_of(self, each: Entered) -> Names | None:
        if each.description is None:
            return None
        return self._session.once(each.description, names_of_refused if each.refused else names_of)

    def _numbers(self) -> tuple[list[int], list[int]]:
        """For each file its number in the order of the tree of includes, and that of the last one below it.

        Files are executed in that order, but for those that timers and ends of processes put off.
        """
        below: dict[tuple[int, ...], list[tuple[int, ...]]] = {}
        for way in self._at:
            below.setdefault(way[:-1], []).append(way) if way else None
        first: dict[tuple[int, ...], int] = {}
        last: dict[tuple[int, ...], int] = {}
        waiting: list[tuple[tuple[int, ...], bool]] = [((), False)]
        while waiting:
            way, done = waiting.pop()
            if done:
                last[way] = len(first) - 1
                continue
            first[way] = len(first)
            waiting.append((way, True))
            waiting.extend((each, False) for each in reversed(below.get(way, ())))
        return [first[each.way] for each in self._entered], [last[each.way] for each in self._entered]

    def _last_missing(self, index: int) -> int:
        """Where the last include of a file stands that has not been executed; -1 where all have been."""
        names, way = self._names[index], self._entered[index].way
        includes = () if names is None else names.includes
        return max((include.place.span.start for include in includes if (*way, id(include)) not in self._at), default=-1)

    def work(self) -> int:
        """How often a file would be asked for a name."""
        asked = sum(len(each.passed) + len(names.arguments) for each, names in zip(self._entered, self._names, strict=True) if names)
        return asked * len(self._entered)

    def names(self, index: int) -> Names | None:
        """What the file reads."""
        return self._names[index]

    def known_below(self, index: int) -> set[str]:
        """The args that the file and those below it declare."""
        names = (self._names[at] for at in range(index, len(self._entered)) if self._is_below(at, index))
        return {name for each in names if each is not None for name in each.declared}

    def below(self, index: int, name: str, *, own: bool = True) -> Readers:
        """Whether the file itself (``own``) or one that it includes can read ``name``."""
        for at in self._readers.get(name, ()):
            if self._is_below(at, index) and (own if at == index else name not in self._passed[at]):
                return "some"
        if not own and not self._all_entered(index, -1):
            return "perhaps"
        start = bisect_left(self._unsure_first, self._first[index])
        for at in self._unsure[start : bisect_right(self._unsure_first, self._last[index])]:
            if own if at == index else self._is_unsure(at, name):
                return "perhaps"
        return "none"

    def after(self, index: int, name: str) -> Readers:
        """Whether what is executed when the file has been can read ``name``: the files around it, and what they include."""
        for at in reversed(self._readers.get(name, ())):
            if at <= index:
                break
            if not self._is_below(at, index) and name not in self._passed[at]:
                return "some"
        unsure = (at for at in self._unsure if at > index and not self._is_below(at, index) and self._is_unsure(at, name))
        found: Readers = "none" if next(unsure, None) is None else "perhaps"
        way, step = self._entered[index].way, self._entered[index].step
        while way and step is not None:
            around = self._at.get(way[:-1])
            names = None if around is None else self._names[around]
            if around is None or names is None:
                return "some"
            if names.last(name) > step.place.span.end:
                return "some"
            if names.open or not self._all_entered(around, step.place.span.end):
                found = "perhaps"
            way, step = way[:-1], step.parent
        return found

    def _is_below(self, at: int, index: int) -> bool:
        """Whether a file is ``index`` itself or below it."""
        return self._first[index] <= self._first[at] <= self._last[index]

    def _is_unsure(self, at: int, name: str) -> bool:
        """Whether one of the unsure files may read ``name``: not if it gets another one."""
        return self._names[at] is None or name not in self._passed[at]

    def _all_entered(self, index: int, offset: int) -> bool:
        """Whether all that the file includes behind ``offset`` has been executed."""
        return self._names[index] is not None and self._missing[index] <= offset

"""Which args nothing can read: ROS 2 launch keeps all launch configurations in one place, so that any file executed later may.

What is passed to an include stays set for what follows it, and what a file declares is seen by all that it includes. So an arg is
useless only where neither the files executed from there on nor the rest of those around can read it, taken branch or not.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from launchlint.evaluate.ros2.names_read import OF_LAUNCH, Names, names_of, names_of_refused
from launchlint.evaluate.ros2.problems import ArgUnused, PassedForNothing
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
    def __init__(self, entered: list[Entered], session: Session) -> None:
        self._entered = entered
        self._session = session
        self._at = {each.way: index for index, each in enumerate(entered)}

    def work(self) -> int:
        """How often a file would be asked for a name."""
        asked = sum(len(each.passed) + len(names.arguments) for at, each in enumerate(self._entered) if (names := self.names(at)))
        return asked * len(self._entered)

    def names(self, index: int) -> Names | None:
        """What the file reads."""
        description = self._entered[index].description
        return (
            None if description is None else self._session.once(description, names_of_refused if self._entered[index].refused else names_of)
        )

    def known_below(self, index: int) -> set[str]:
        """The args that the file and those below it declare."""
        way = self._entered[index].way
        names = (self.names(at) for at in range(index, len(self._entered)) if self._entered[at].way[: len(way)] == way)
        return {name for each in names if each is not None for name in each.declared}

    def below(self, index: int, name: str, *, own: bool = True) -> Readers:
        """Whether the file itself (``own``) or one that it includes can read ``name``."""
        way = self._entered[index].way
        found: Readers = "none"
        for at in range(index if own else index + 1, len(self._entered)):
            if self._entered[at].way[: len(way)] == way:
                found = _worse(found, self._reads(at, name, passed=at == index))
        return found if own else _worse(found, "none" if self._all_entered(index, -1) else "perhaps")

    def after(self, index: int, name: str) -> Readers:
        """Whether what is executed when the file has been can read ``name``: the files around it, and what they include."""
        way, step = self._entered[index].way, self._entered[index].step
        found: Readers = "none"
        for at in range(index + 1, len(self._entered)):
            if self._entered[at].way[: len(way)] != way:
                found = _worse(found, self._reads(at, name))
        while way and step is not None:
            around = self._at.get(way[:-1])
            names = None if around is None else self.names(around)
            if around is None or names is None:
                return "some"
            if names.last(name) > step.place.span.end:
                return "some"
            if names.open or not self._all_entered(around, step.place.span.end):
                found = _worse(found, "perhaps")
            way, step = way[:-1], step.parent
        return found

    def _reads(self, at: int, name: str, *, passed: bool = False) -> Readers:
        names = self.names(at)
        if names is None:
            return "perhaps"
        if not passed and any(name == other for other, _ in self._entered[at].passed):
            return "none"  # it gets another one
        if names.last(name) >= 0:
            return "some"
        return "perhaps" if names.open or not self._all_entered(at, -1) else "none"

    def _all_entered(self, index: int, offset: int) -> bool:
        """Whether all that the file includes behind ``offset`` has been executed."""
        names, way = self.names(index), self._entered[index].way
        return names is not None and all((*way, id(include)) in self._at for include in names.includes if include.place.span.start > offset)


def _worse(one: Readers, other: Readers) -> Readers:
    return max(one, other, key=("none", "perhaps", "some").index)

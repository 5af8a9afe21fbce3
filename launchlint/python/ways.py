"""Ways through a program that is followed to the letter: which of them leave a block early, and what they have written until then.

Where one way out of several leaves (by return, break, continue, or an exception), what follows belongs to the others. It is written to a
log of its own, until the block that is left ends: there all ways come together again.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launchlint.python.memory import ENDED, GOES_ON, Branch, Ended, Log, Memory, taken_back
from launchlint.python.values import conjunction

Way = tuple[str, Branch]
"""A condition, and what is done under it."""


class Ways(Memory):
    """The ways that have left, and the one that goes on."""

    def __init__(self) -> None:
        super().__init__()
        self._open: list[tuple[list[Way], Log, str]] = []
        self.catching = 0  # how many ``try`` there are around what is followed

    @property
    def opened(self) -> int:
        """How many times some way has left what is not at its end yet."""
        return len(self._open)

    def may_end(self) -> None:
        """Some of several ways end with an exception that nobody catches: people take the others."""
        self.risks += 1

    def apply(self, branch: Branch) -> None:
        """Write again what a branch has written."""
        for mapping, key, value in branch.written.values():
            self.store(mapping, key, value)

    def ways(self, condition: str, body: Callable[[], int]) -> list[Way]:
        """What may be done under a condition, as one way or several; nothing of it is written yet."""
        mark = self.opened
        inner: list[Way] = []
        with self.branch(condition) as branch:
            try:
                branch.flow = body()
            except Ended as error:
                branch.flow, self.raised = ENDED, error
            branch.raised = self.raised if branch.flow == ENDED else None
            if self.opened > mark:
                inner = self.settle(mark, branch.flow)
        if not inner:
            return [(condition, branch)]
        return [(conjunction((condition, each)), _behind(branch, way)) for each, way in inner]

    def settle(self, mark: int, flow: int) -> list[Way]:
        """All ways since ``mark``, each with what it has written since then; ``flow`` is how the one that stayed has ended."""
        staying = Branch(flow)
        staying.raised = self.raised if flow == ENDED else None
        found: list[Way] = [("", staying)]
        while len(self._open) > mark:
            leaving, log, condition = self._open.pop()
            base = Branch()
            self._logs.pop()
            base.written = taken_back(log)
            found = [*leaving, *((conjunction((condition, each)), _behind(base, way)) for each, way in found)]
        return found

    def meet(self, ways: list[Way], local: dict[Any, Any]) -> int:
        """Go on behind several ways: with those that go on, or else those that end in the same way; the others have left."""
        flow = min(way.flow for _, way in ways)
        if flow != ENDED and not self.catching and any(way.flow == ENDED for _, way in ways):
            self.may_end()
            ways = [(condition, way) for condition, way in ways if way.flow != ENDED]
        current = [(condition, way) for condition, way in ways if way.flow == flow]
        leaving = [(condition, way) for condition, way in ways if way.flow != flow]
        if flow == ENDED:
            self.raised = current[0][1].raised if len(current) == 1 else None
        if not leaving:
            self.unite(current, local)
            return flow
        with self.branch("") as branch:
            self.unite(current, local)
        condition = current[0][0] if len(current) == 1 else ""
        log: Log = {}
        self._logs.append(log)
        self.apply(branch)
        self._open.append((leaving, log, condition))
        if condition and flow == GOES_ON:
            self.conditions.append(condition)
        return flow

    def unite(self, ways: list[Way], local: dict[Any, Any]) -> None:
        """Make one state of ways that end in the same way."""
        united = []
        for condition, way in ways:
            same = Branch()
            same.written = way.written
            united.append((condition, same))
        self.join(united, local)


def _behind(first: Branch, second: Branch) -> Branch:
    """What is done one behind the other."""
    both = Branch(second.flow)
    both.raised = second.raised
    both.written = {**first.written, **second.written}
    return both

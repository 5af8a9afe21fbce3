"""What a followed program has written to its variables so far, and how two ways through it come together again."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from launchlint.python.values import (
    ALIKE,
    COMPLETE,
    ENTRIES,
    ITEMS,
    KIND,
    MISSING,
    MOST_ITEMS,
    Choice,
    Unknown,
    Value,
    choice,
    is_maybe,
    same,
)

MOST_STEPS = 150_000
"""Statements and expressions that are looked at for one program."""
_LARGE = 64

Log = dict[tuple[int, Any], tuple[dict[Any, Any], Any, Any]]
"""What was there before something was written: (which mapping, key) → (mapping, key, value)."""


def taken_back(log: Log) -> Log:
    """Put back what was there before, and return what stood in these places until now."""
    written: Log = {}
    for place, (mapping, key, before) in log.items():
        written[place] = (mapping, key, mapping.get(key, MISSING))
        if before is MISSING:
            mapping.pop(key, None)
        else:
            mapping[key] = before
    return written


class Exhausted(Exception):
    """The program is too much to be followed."""


class Ended(Exception):
    """The followed program ends here, or raises."""


class Branch:
    """One way through a piece of a program: what it has written, how it ended, and with which exception."""

    __slots__ = ("flow", "raised", "written")

    def __init__(self, flow: int = 0) -> None:
        self.flow = flow
        self.raised: Ended | None = None
        self.written: Log = {}


class Memory:
    """Conditions, the count of steps and the log of writes.

    ``exact``: the program is followed to the letter, once, from its first statement to its last. Otherwise it is looked through for what it
    may do: all of its ways, its functions in any order.
    """

    exact = False
    most_steps = MOST_STEPS

    def __init__(self) -> None:
        self.risks = 0  # how much was done that may have raised an exception
        self.raised: Ended | None = None
        self.conditions: list[str] = []
        self.outcome = 0  # how much has come of the program, in whatever the recogniser counts
        self.steps = 0
        self.rewritten: set[tuple[int, Any]] = set()  # what was written more than once on one way
        self._logs: list[Log] = []
        self.kept = 0

    def step(self) -> None:
        """Count one piece of work. Raises :class:`Exhausted` where it is too much."""
        self.steps += 1
        if self.steps > self.most_steps:
            raise Exhausted

    def spend(self, size: int) -> None:
        """Count work on something large. Raises :class:`Exhausted`."""
        if size > _LARGE:
            self.steps += size // _LARGE
            self.step()

    def store(self, mapping: dict[Any, Any], key: Any, value: Any) -> None:
        """Write, so that it can be taken back."""
        if self._logs:
            place, log = (id(mapping), key), self._logs[-1]
            if place in log:
                self.rewritten.add(place)
            else:
                log[place] = (mapping, key, mapping.get(key, MISSING))
        if value is MISSING:
            mapping.pop(key, None)
        else:
            mapping[key] = value

    def keeps(self, log: Log) -> bool:
        """Whether what is written is noted in ``log``."""
        return any(each is log for each in self._logs)

    def keep(self, log: Log) -> None:
        """Note from now on in ``log`` what stood where something is written, until the end."""
        self.kept += 1
        self._logs.insert(0, log)

    @contextmanager
    def branch(self, condition: str) -> Iterator[Branch]:
        """One way that may be taken: what is written in it is taken back at its end and can be found in the branch."""
        branch = Branch()
        log: Log = {}
        self._logs.append(log)
        mark = len(self.conditions)
        if condition:
            self.conditions.append(condition)
        try:
            yield branch
        finally:
            del self.conditions[mark:]
            self._logs.pop()
            branch.written = taken_back(log)

    def join(self, ways: list[tuple[str, Branch]], local: dict[Any, Any]) -> None:
        """Go on after one of several ways was taken, each with its condition. Variables in ``local`` matter only for ways that get here."""
        places = {place: (mapping, key) for _, way in ways for place, (mapping, key, _) in way.written.items()}
        for place, (mapping, key) in places.items():
            before = mapping.get(key, MISSING)
            outcomes: list[tuple[str, Any]] = []
            for condition, way in ways:
                if way.flow < RETURNED or (mapping is not local and way.flow != ENDED):
                    outcomes.append((condition, way.written[place][2] if place in way.written else before))
            if outcomes:
                merged = self.merged(key, outcomes)
                self.store(mapping, key, merged)
                if isinstance(merged, Unknown):
                    self.lost([value for _, value in outcomes])

    def merged(self, key: Any, outcomes: list[tuple[str, Any]]) -> Any:
        """What stands under ``key`` behind several ways, each with its condition and what it has written there."""
        return (_merged_exactly if self.exact else _merged)(key, outcomes)

    def lost(self, values: list[Value]) -> None:
        """Values that can be one of too many to be told apart any more."""
        raise NotImplementedError

    def doubt(self, reason: str, path: str, line: int) -> None:
        """Note why not everything is known."""
        raise NotImplementedError


GOES_ON, BROKEN, CONTINUED, RETURNED, ENDED = range(5)
"""How a way can end: it goes on, with a loop's break or continue, with a return, with the end of the program."""


def _merged(key: Any, outcomes: list[tuple[str, Any]]) -> Any:
    if key == COMPLETE:
        known = {value for _, value in outcomes}
        return True if known == {True} else ALIKE if known <= {True, ALIKE} else False
    if key == ITEMS:
        return _merged_items(outcomes)
    if key == ENTRIES:
        return _merged_entries(outcomes)
    return choice(outcomes)


def _merged_exactly(key: Any, outcomes: list[tuple[str, Any]]) -> Any:
    if len(outcomes) == 1:
        return outcomes[0][1]
    if key == KIND:
        return outcomes[0][1] if len({value for _, value in outcomes}) == 1 else "listing"
    if key == COMPLETE:
        return all(value is True for _, value in outcomes)
    if key == ITEMS:
        return _joined_items([(condition, value) for condition, value in outcomes if isinstance(value, list)])
    if key == ENTRIES:
        return _joined_entries([(condition, value) for condition, value in outcomes if isinstance(value, dict)])
    return choice(outcomes)


def _joined_items(lists: list[tuple[str, list[Value]]]) -> list[Value]:
    """A list that is one of several: what they begin and end with alike is in it, the rest may be."""
    shortest = min(len(value) for _, value in lists)
    first = lists[0][1]
    begin = end = 0
    while begin < shortest and all(same(value[begin], first[begin]) for _, value in lists):
        begin += 1
    while end < shortest - begin and all(same(value[-1 - end], first[-1 - end]) for _, value in lists):
        end += 1
    rests = [(condition, value[begin : len(value) - end]) for condition, value in lists]
    if len({len(rest) for _, rest in rests}) == 1:
        middle = [_one_of([(condition, rest[at]) for condition, rest in rests]) for at in range(len(rests[0][1]))]
    else:
        middle = [each if is_maybe(each) else Choice(((condition, each),)) for condition, rest in rests for each in rest]
    return [*first[:begin], *middle, *first[len(first) - end :]]


def _one_of(options: list[tuple[str, Value]]) -> Value:
    """An item that is one of several, and may be missing where one of them may be."""
    made = choice([each.alternatives[0] if is_maybe(each) else (condition, each) for condition, each in options])
    return Choice((("", made),)) if any(is_maybe(each) for _, each in options) else made


def _joined_entries(mappings: list[tuple[str, dict[Any, Value]]]) -> dict[Any, Value]:
    found: dict[Any, Value] = {}
    for key in dict.fromkeys(key for _, value in mappings for key in value):
        options = [(condition, value[key]) for condition, value in mappings if key in value]
        made = _one_of(options)
        found[key] = made if len(options) == len(mappings) or is_maybe(made) else Choice((("", made),))
    return found


def _merged_items(outcomes: list[tuple[str, Any]]) -> list[Value]:
    lists = [(condition, value) for condition, value in outcomes if isinstance(value, list)]
    items: list[Value] = []
    for condition, value in lists:
        for item in value:
            if any(same(item, each) for each in items):
                continue
            everywhere = all(any(same(item, each) for each in other) for _, other in lists)
            items.append(item if everywhere or not condition or isinstance(item, Choice) else Choice(((condition, item),)))
    return items[:MOST_ITEMS]


def _merged_entries(outcomes: list[tuple[str, Any]]) -> dict[Any, Value]:
    mappings = [(condition, value) for condition, value in outcomes if isinstance(value, dict)]
    keys = dict.fromkeys(key for _, value in mappings for key in value)
    return {key: choice([(condition, value[key]) for condition, value in mappings if key in value]) for key in keys}

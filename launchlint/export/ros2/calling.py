"""What functions of a launch file in Python give when launch calls them, in place of the functions.

A function can do anything with the context that it is called with. In a declarative file stands what it gave, and what it set, when it was
called as the file is exported; whether that depends on anything shows where it is called in another configuration.
"""

from __future__ import annotations

from typing import NamedTuple

from launchlint.dialects.door import named
from launchlint.export.ros2.comparing import normal
from launchlint.model import ROS2, Unknown
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Description, Text, unknown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from launchlint.evaluate.session import Session
    from launchlint.source import Place
    from launchlint.syntax.ros2.description import Action, Call, Condition
    from launchlint.syntax.ros2.live import LiveContext
    from launchlint.syntax.ros2.reading import Reading

    Pairs = tuple[tuple[str, str], ...]

DEEPEST = 5
"""Functions that give functions."""


class Called(NamedTuple):
    """``description`` has no functions any more, but for those that were never called; ``varying`` are the places of those that give
    something else in another configuration.
    """

    description: Description
    varying: tuple[Place, ...]


def called(session: Session, file: str, reading: Reading, configurations: Iterable[Pairs]) -> Called:
    """The description of ``file``, a launch file in Python, with what its functions give in the first of ``configurations``."""
    given = list(configurations)
    varying: dict[Place, None] = {}
    description = reading.description
    for _ in range(DEEPEST):
        if not any(isinstance(each, described.Opaque) for each in _all(description.actions)):
            break
        records = [_record(session, file, reading, description, pairs) for pairs in given]
        calls = list(records[0])
        description = description._replace(actions=_replaced(description.actions, records[0], {}))
        for key in calls:
            first, place = records[0][key]
            if any(key in other and not _same(first, other[key][0]) for other in records[1:]):
                varying[place] = None
    return Called(description, tuple(varying))


_Record = dict[int, "tuple[tuple[Action, ...], Place]"]


def _record(session: Session, file: str, reading: Reading, description: Description, pairs: Pairs) -> _Record:
    """By the number of each function in the description what it gave when it was first called."""
    record: _Record = {}
    numbers: dict[int, int] = {}
    actions = _replaced(description.actions, {}, numbers, record)
    watched = session.with_reading(file, reading._replace(description=description._replace(actions=actions)))
    named(ROS2).evaluate(watched, file, pairs)
    return record


def _replaced(actions: tuple[Action, ...], made: _Record, numbers: dict[int, int], record: _Record | None = None) -> tuple[Action, ...]:
    """``actions`` with what is ``made`` in place of functions, or with functions that put it into ``record``."""
    found: list[Action] = []
    for action in actions:
        if isinstance(action, (described.Group, described.Timer)):
            found.append(action._replace(actions=_replaced(action.actions, made, numbers, record)))
            continue
        if not isinstance(action, described.Opaque):
            found.append(action)
            continue
        number = numbers[len(numbers)] = len(numbers)
        if record is not None:
            found.append(action._replace(call=_watching(action, number, record)))
        elif number in made:
            given, place = made[number]
            if action.condition is None:
                found += given
            else:
                found.append(described.Group(given, False, True, (), place, action.condition))
        else:
            found.append(action)
    return tuple(found)


def _watching(action: described.Opaque, number: int, record: _Record) -> Call:
    def call(context: LiveContext) -> tuple[Action, ...]:
        watcher = _Watcher(context, action.place)
        given = action.call(watcher)
        record.setdefault(number, ((*watcher.set, *given), action.place))
        return given

    return call


class _Watcher:
    """A live context that notes what is set in it."""

    def __init__(self, context: LiveContext, place: Place) -> None:
        self._context = context
        self._place = place
        self.set: list[Action] = []

    @property
    def launch(self) -> object:
        """As the context."""
        return self._context.launch

    def spend(self, steps: int) -> None:
        """As the context."""
        self._context.spend(steps)

    def perform(self, text: Text) -> str | Unknown:
        """As the context."""
        return self._context.perform(text)

    def holds(self, condition: Condition) -> bool | None:
        """As the context."""
        return self._context.holds(condition)

    def configuration(self, name: str) -> str | Unknown | None:
        """As the context."""
        return self._context.configuration(name)

    def configurations(self) -> dict[str, str | Unknown] | None:
        """As the context."""
        return self._context.configurations()

    def configure(self, name: str, value: str | Unknown) -> None:
        """As the context, and noted."""
        self._context.configure(name, value)
        self.set.append(described.Let(self._text(name), self._text(value), self._place))

    def variable(self, name: str) -> str | Unknown | None:
        """As the context."""
        return self._context.variable(name)

    def environment(self) -> dict[str, str | Unknown | None]:
        """As the context."""
        return self._context.environment()

    def set_variable(self, name: str, value: str | Unknown | None) -> None:
        """As the context, and noted."""
        self._context.set_variable(name, value)
        if value is None:
            self.set.append(described.UnsetEnvironment(self._text(name), self._place))
        else:
            self.set.append(described.SetEnvironment(self._text(name), self._text(value), self._place))

    def _text(self, value: str | Unknown) -> Text:
        return unknown(value.reason, self._place) if isinstance(value, Unknown) else Text((value,) if value else (), self._place)


def _all(actions: Iterable[Action]) -> Iterable[Action]:
    for action in actions:
        yield action
        if isinstance(action, (described.Group, described.Timer)):
            yield from _all(action.actions)


def _same(one: tuple[Action, ...], other: tuple[Action, ...]) -> bool:
    return normal(one) == normal(other)

"""What functions of a launch file in Python give when launch calls them, in place of the functions.

A function can do anything with the context that it is called with. In a declarative file stands what it gave, and what it set, when it was
called as the file is exported. What it asked the context for, it may depend on.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from launchlint.dialects.door import named
from launchlint.model import ROS2, Unknown
from launchlint.named_tuple import NamedTuple
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

_ASKED = {"var": "the arg", "env": "the environment variable"}
DEEPEST = 5
"""Functions that give functions."""


class Called(NamedTuple):
    """``description`` has no functions any more, but for those that were never called. ``asked`` are the places of those that asked for
    something, each with what that was.
    """

    description: Description
    asked: tuple[tuple[Place, tuple[str, ...]], ...]


def called(session: Session, file: str, reading: Reading, given: Pairs) -> Called:
    """The description of ``file``, a launch file in Python, with what its functions give when it is started with ``given``."""
    asked: dict[Place, tuple[str, ...]] = {}
    description = reading.description
    for _ in range(DEEPEST):
        if not any(isinstance(each, described.Opaque) for each in _all(description.actions)):
            break
        record = _record(session, file, reading, description, given)
        description = description._replace(actions=_replaced(description.actions, record, count()))
        asked.update((each.place, each.asked) for each in record.values() if each.asked)
    return Called(description, tuple(asked.items()))


class _Given(NamedTuple):
    """What a function gave when it was first called."""

    actions: tuple[Action, ...]
    place: Place
    asked: tuple[str, ...]


_Record = dict[int, _Given]


def _record(session: Session, file: str, reading: Reading, description: Description, pairs: Pairs) -> _Record:
    """By the number of each function in the description what it gave when it was first called."""
    record: _Record = {}
    actions = _replaced(description.actions, {}, count(), record)
    watched = session.with_reading(file, reading._replace(description=description._replace(actions=actions)))
    named(ROS2).evaluate(watched, file, pairs)
    return record


def _replaced(actions: tuple[Action, ...], made: _Record, numbers: Iterator[int], record: _Record | None = None) -> tuple[Action, ...]:
    """``actions`` with what is ``made`` in place of functions, or with functions that put it into ``record``."""
    found: list[Action] = []
    for action in actions:
        if isinstance(action, (described.Group, described.Timer)):
            found.append(action._replace(actions=_replaced(action.actions, made, numbers, record)))
            continue
        if not isinstance(action, described.Opaque):
            found.append(action)
            continue
        number = next(numbers)
        if record is not None:
            found.append(action._replace(call=_watching(action, number, record)))
        elif number in made:
            given = made[number]
            if action.condition is None:
                found += given.actions
            else:
                found.append(described.Group(given.actions, False, True, (), given.place, action.condition))
        else:
            found.append(action)
    return tuple(found)


def _watching(action: described.Opaque, number: int, record: _Record) -> Call:
    def call(context: LiveContext) -> tuple[Action, ...]:
        watcher = _Watcher(context, action.place)
        given = action.call(watcher)
        record.setdefault(number, _Given((*watcher.set, *given), action.place, tuple(watcher.asked)))
        return given

    return call


class _Watcher:
    """A live context that notes what is set in it, and what it is asked for."""

    def __init__(self, context: LiveContext, place: Place) -> None:
        self._context = context
        self._place = place
        self.set: list[Action] = []
        self.asked: dict[str, None] = {}

    @property
    def launch(self) -> object:
        """As the context."""
        return self._context.launch

    def unsettle(self) -> None:
        """As the context."""
        self._context.unsettle()

    def spend(self, steps: int) -> None:
        """As the context."""
        self._context.spend(steps)

    def perform(self, text: Text) -> str | Unknown:
        """As the context."""
        self._ask(text)
        return self._context.perform(text)

    def holds(self, condition: Condition) -> bool | None:
        """As the context."""
        if condition.kind in ("if", "unless"):
            self._ask(condition.operands[0])
        else:
            self.asked[f"the arg {condition.operands[0].literal}"] = None
        return self._context.holds(condition)

    def configuration(self, name: str) -> str | Unknown | None:
        """As the context."""
        self.asked[f"the arg {name}"] = None
        return self._context.configuration(name)

    def configurations(self) -> dict[str, str | Unknown] | None:
        """As the context."""
        self.asked["all args"] = None
        return self._context.configurations()

    def configure(self, name: str, value: str | Unknown) -> None:
        """As the context, and noted."""
        self._context.configure(name, value)
        self.set.append(described.Let(self._text(name), self._text(value), self._place))

    def variable(self, name: str) -> str | Unknown | None:
        """As the context."""
        self.asked[f"the environment variable {name}"] = None
        return self._context.variable(name)

    def environment(self) -> dict[str, str | Unknown | None]:
        """As the context."""
        return self._context.environment()

    def remember(self) -> None:
        """As the context."""
        self._context.remember()

    def set_variable(self, name: str, value: str | Unknown | None) -> None:
        """As the context, and noted."""
        self._context.set_variable(name, value)
        if value is None:
            self.set.append(described.UnsetEnvironment(self._text(name), self._place))
        else:
            self.set.append(described.SetEnvironment(self._text(name), self._text(value), self._place))

    def _ask(self, text: Text) -> None:
        """Note the args and variables that stand in a text."""
        waiting = [text]
        while waiting:
            for piece in waiting.pop().pieces:
                if isinstance(piece, str):
                    continue
                kind = _ASKED.get(piece.name)
                if kind is not None:
                    name = piece.arguments[0].literal if piece.arguments else None
                    self.asked[f"{kind} {name or piece.place.text}"] = None
                waiting.extend(piece.arguments)

    def _text(self, value: str | Unknown) -> Text:
        return unknown(value.reason, self._place) if isinstance(value, Unknown) else Text((value,) if value else (), self._place)


def _all(actions: Iterable[Action]) -> Iterable[Action]:
    for action in actions:
        yield action
        if isinstance(action, (described.Group, described.Timer)):
            yield from _all(action.actions)

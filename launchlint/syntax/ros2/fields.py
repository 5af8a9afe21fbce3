"""What was read of an entity, before an action is made of it."""

from __future__ import annotations

from launchlint.source import Place
from launchlint.syntax.ros2.description import Condition, Pair, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeVar

    T = TypeVar("T")


class Fields:
    """Attributes and named children by name, ``if`` for the condition, ``actions`` for the rest; ``place`` is the entity's."""

    __slots__ = ("_read", "place")

    def __init__(self, place: Place) -> None:
        self._read: dict[str, object] = {}
        self.place = place

    def put(self, name: str, value: object) -> None:
        """Remember what was read; None says that there is nothing."""
        self._read[name] = value

    def get(self, name: str, kind: type[T]) -> T | None:
        """What was read under ``name``, if it is of this kind."""
        value = self._read.get(name)
        return value if isinstance(value, kind) else None

    def many(self, name: str, kind: type[T]) -> tuple[T, ...]:
        """As :meth:`get`, for what is a tuple."""
        return tuple(each for each in self.get(name, tuple) or () if isinstance(each, kind))

    def text(self, name: str) -> Text | None:
        """A text; None where it was not given or could not be read."""
        return self.get(name, Text)

    def must(self, name: str) -> Text:
        """A text that has to be there. Where it is not, launch has refused the file, and this one says nothing: see ``Substitution``."""
        from launchlint.syntax.ros2.description import Substitution

        return self.text(name) or Text((Substitution("", (), self.place),), self.place)

    @property
    def condition(self) -> Condition | None:
        """The condition."""
        return self.get("if", Condition)

    def pairs(self, name: str) -> tuple[Pair, ...]:
        """The children ``name``, which have a name and a value."""
        return tuple(Pair(each.must("name"), each.must("value"), each.place) for each in self.many(name, Fields))

"""``<for>`` and ``<for_each>``: what stands in them comes once for each turn, with the values of the turn in it.

Launch makes a copy of the actions for each turn, and says what ``$(index …)`` and ``$(for-var …)`` are by what is in force when they are
performed. Here they are written into the copy. So a launch file that is included in a loop does not see them: what it asks for is unknown.
"""

from __future__ import annotations

from typing import Any

from launchlint.named_tuple import NamedTuple
from launchlint.source import Origin, Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Action, Substitution, Text
from launchlint.syntax.ros2.looping import FOR_VARIABLE, INDEX, INDEX_OF_LOOP, Refused, TooMany, turns

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from launchlint.syntax.ros2.live import LiveContext


class Loop(NamedTuple):
    """What launch calls for a loop: ``actions`` in turns. ``kind`` is the class of launch, ``over`` the length or the sets of values.

    ``name`` is what a ``<for>`` calls its number.
    """

    kind: str
    over: Text
    name: str | None
    actions: tuple[Action, ...]
    place: Place

    def __call__(self, live: LiveContext) -> tuple[Action, ...]:
        """The actions of all turns. Raises Stopped."""
        found = live.perform(self.over)
        if not isinstance(found, str):
            return (described.Open(found.reason, self.place),)
        try:
            given = turns(self.kind, found)
        except Refused as refused:
            from launchlint.syntax.ros2.python.problems import StopsWithError

            place = self.over.place
            problem = StopsWithError(
                origin=Origin(place), refused=True, error=refused.error, what=refused.what, stated=False, called=True, action=self.kind
            )
            return (described.Fails(problem, place),)
        except TooMany:
            return (described.Open(f"{self.kind} goes through too much to be followed", self.place),)
        return tuple(described.Turn(_with(self.actions, self._named(values)), self.place) for values in given)

    def _named(self, values: Mapping[str, Any]) -> dict[str, str]:
        """The values of a turn as its substitutions give them."""
        if self.name is not None:
            return {self.name: str(values[INDEX])}
        return {name: str(value) for name, value in values.items()}


def is_loop(action: described.Opaque) -> bool:
    """Whether it is a loop of XML or YAML, and no function of a program: all that it may come to can be seen."""
    return isinstance(action.call, Loop)


def _with(part: Any, values: Mapping[str, str]) -> Any:
    """A copy of a part of a description, with ``values`` in it."""
    if isinstance(part, Place) or not isinstance(part, tuple):
        return part
    if isinstance(part, Text):
        return Text(tuple(_joined(piece for each in part.pieces for piece in _pieces(each, values))), part.place)
    items = [_with(each, values) for each in part]
    return tuple(items) if type(part) is tuple else type(part)(*items)


def _joined(pieces: Iterable[str | Substitution]) -> list[str | Substitution]:
    """Pieces with strings in a row as one: a text of nothing else is a literal."""
    found: list[str | Substitution] = []
    for piece in pieces:
        if isinstance(piece, str) and found and isinstance(found[-1], str):
            found[-1] += piece
        else:
            found.append(piece)
    return found


def _pieces(piece: str | Substitution, values: Mapping[str, str]) -> tuple[str | Substitution, ...]:
    """What comes in the place of a piece of a text."""
    if isinstance(piece, str):
        return (piece,)
    made: Substitution = _with(piece, values)
    name = made.arguments[0].literal if made.name in (FOR_VARIABLE, INDEX_OF_LOOP) and made.arguments else None
    return (made,) if name is None or name not in values else (values[name],)

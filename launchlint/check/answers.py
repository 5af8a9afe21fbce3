"""What packages answered (:mod:`launchlint.workspace.questions`), as a cache keeps it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from launchlint.named_tuple import NamedTuple

_PLAIN = (str, int, bool, type(None))


class KeptAnswer(NamedTuple):
    """The state of an answer, the names of all shared looks that it hangs on, and what was found, where that can be kept.

    That is one JSON value, or none.
    """

    state: str
    names: Sequence[str]
    written: Sequence[Any]

    @property
    def has_found(self) -> bool:
        """Whether it is known what was found."""
        return bool(self.written)

    @property
    def found(self) -> Any:
        """What was found. Raises TypeError, ValueError, KeyError or IndexError where somebody else wrote it."""
        return _read(self.written[0])

    def with_found(self, found: object) -> KeptAnswer:
        """The same with what was found, where that is made of nothing but texts, numbers and collections of them."""
        try:
            return self._replace(written=[_written(found)])
        except TypeError:
            return self


def answers_to_json(answers: Mapping[str, KeptAnswer]) -> list[Any]:
    """Answers by question, as JSON values."""
    numbers = {name: number for number, name in enumerate(dict.fromkeys(name for each in answers.values() for name in each.names))}
    written = {
        question: [each.state, [numbers[name] for name in each.names], *each.written] for question, each in answers.items()
    }  # fmt: skip
    return [list(numbers), written]


def answers_from_json(value: Any) -> dict[str, KeptAnswer]:
    """The inverse. Raises TypeError, ValueError or IndexError for anything else."""
    names, answers = value
    return {
        question: KeptAnswer(state, [names[number] for number in numbers], found) for question, (state, numbers, *found) in answers.items()
    }


def _written(found: object) -> Any:
    """As JSON values. Raises TypeError for what would not come back as it was: its type may be another one."""
    kind = type(found)
    if kind in _PLAIN:
        return found
    if isinstance(found, (tuple, list)) and kind in (tuple, list):
        return [kind.__name__, *map(_written, found)]
    if isinstance(found, (set, frozenset)) and kind in (set, frozenset) and all(type(each) is str for each in found):
        return [kind.__name__, *sorted(found)]
    if isinstance(found, dict) and kind is dict:
        return ["dict", *([_written(key), _written(value)] for key, value in found.items())]
    raise TypeError


def _read(written: Any) -> Any:
    if not isinstance(written, list):
        return written
    kind, *values = written
    if kind == "dict":
        return {_read(key): _read(value) for key, value in values}
    return _KINDS[kind](map(_read, values))


_KINDS: Mapping[str, Any] = {"tuple": tuple, "list": list, "set": set, "frozenset": frozenset}

"""Values of a followed program as Python's own objects and back, so that Python itself works out what a pure function makes of them.

Only strings, numbers, ``None``, and lists, tuples, sets and dicts of them have such an object; nothing followed is ever run with it.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launchlint.python.values import MOST_EXACT, Key, Map, Seq, Value

LARGEST_TEXT = 1 << 20
LARGEST_NUMBER = 1 << 4096
DEEPEST_VALUE = 40
SIMPLE = (str, int, float, bool, type(None))
_MAKE: dict[str, Any] = {"list": list, "tuple": tuple, "set": set, "frozenset": frozenset}


class NotPlain(Exception):
    """A value is not known as a whole, or is none of Python's own."""


def plain(value: Value) -> Any:
    """The object that a value is. Raises :class:`NotPlain`."""
    return _Plain().of(value, 0)


class _Plain:
    def __init__(self) -> None:
        self.left = MOST_EXACT

    def of(self, value: Value, depth: int) -> Any:
        if isinstance(value, SIMPLE):
            return value
        self.left -= 1
        if depth > DEEPEST_VALUE or self.left < 0:
            raise NotPlain
        if isinstance(value, Seq) and value.complete and value.kind in _MAKE:
            items = [self.of(each, depth + 1) for each in value.items]
            try:
                return _MAKE[value.kind](items)
            except TypeError:
                raise NotPlain from None
        if isinstance(value, Map) and value.complete:
            return {self._key(key): self.of(each, depth + 1) for key, each in value.entries.items()}
        raise NotPlain

    def _key(self, key: Value) -> Any:
        if isinstance(key, Key):
            return key.items
        if isinstance(key, SIMPLE):
            return key
        raise NotPlain


def value_of(made: Any, depth: int = 0) -> Value:
    """The value that an object of Python is. Raises :class:`NotPlain` where there is none, or it is too large."""
    if isinstance(made, str):
        if len(made) > LARGEST_TEXT:
            raise NotPlain
        return made
    if type(made) is int and abs(made) >= LARGEST_NUMBER:
        raise NotPlain
    if type(made) in SIMPLE:
        return made
    if depth > DEEPEST_VALUE:
        raise NotPlain
    for kind, type_ in _MAKE.items():
        if type(made) is type_:  # the order of a set is not the program's
            items = sorted(made, key=lambda each: (type(each).__name__, str(each))) if kind in ("set", "frozenset") else made
            return Seq(values_of(items, depth), kind=kind)
    if type(made) is dict:
        return Map({key_of(value_of(key, depth + 1)): value_of(each, depth + 1) for key, each in made.items()})
    raise NotPlain


def values_of(made: Iterable[Any], depth: int = 0) -> list[Value]:
    """The values of several objects. Raises :class:`NotPlain`."""
    found = [value_of(each, depth + 1) for each in made]
    if len(found) > MOST_EXACT:
        raise NotPlain
    return found


def key_of(value: Value) -> Any:
    """What a value is as the key of a followed dict: a tuple becomes a :class:`Key`. Raises :class:`NotPlain`."""
    if isinstance(value, Seq):
        if value.kind != "tuple":
            raise NotPlain
        return Key(plain(value))
    return value


def of_key(key: Any) -> Value:
    """The value that a key of a followed dict is."""
    return value_of(key.items) if isinstance(key, Key) else key

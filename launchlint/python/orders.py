"""Lists in an order that is nobody's, as of the names in a directory, and what does not hang on that order."""

from __future__ import annotations

from itertools import permutations

from launchlint.python.letter import LATER
from launchlint.python.values import UNORDERED, Handle, Instance, Map, Seq, Value, same

_ALL_UP_TO = 3
_DEEPEST = 8


def is_in_any_order(value: Value) -> bool:
    """Whether a value is a list of several known items whose order is nobody's."""
    return isinstance(value, Seq) and value.kind in UNORDERED and LATER not in value.content and value.is_sure and len(value.items) > 1


def orders(items: list[Value]) -> list[list[Value]]:
    """The orders in which items may come; of many of them not all, but some that have no item at the same place."""
    if len(items) <= _ALL_UP_TO:
        return [list(each) for each in permutations(items)]
    half = len(items) // 2
    return [items, items[::-1], [*items[half:], *items[:half]]]


def alike(one: Value, other: Value, depth: int = 0) -> bool:
    """Whether two values were made in the same way of the same."""
    if same(one, other):
        return True
    if type(one) is not type(other) or depth > _DEEPEST:
        return False
    if isinstance(one, Seq):
        return one.kind == other.kind and one.complete is other.complete and _alike_items(one.items, other.items, depth)
    if isinstance(one, list):
        return _alike_items(one, other, depth)
    if isinstance(one, Map):
        return one.complete is other.complete and _alike_entries(one.entries, other.entries, depth)
    if isinstance(one, dict):
        return _alike_entries(one, other, depth)
    if isinstance(one, Handle):
        return one.kind == other.kind and _alike_entries(one.state, other.state, depth)
    if isinstance(one, Instance):
        return one.type is other.type and _alike_entries(one.attributes, other.attributes, depth)
    if isinstance(one, tuple):
        return len(one) == len(other) and all(alike(first, second, depth + 1) for first, second in zip(one, other, strict=True))
    return bool(one == other)


def _alike_items(one: list[Value], other: list[Value], depth: int) -> bool:
    return len(one) == len(other) and all(alike(first, second, depth + 1) for first, second in zip(one, other, strict=True))


def _alike_entries(one: dict[Value, Value], other: dict[Value, Value], depth: int) -> bool:
    return one.keys() == other.keys() and all(alike(value, other[key], depth + 1) for key, value in one.items())


def are_permuted(one: list[Value], other: list[Value]) -> bool:
    """Whether two lists hold the same in different orders."""
    left = list(other)
    for each in one:
        at = next((at for at, candidate in enumerate(left) if alike(each, candidate)), None)
        if at is None:
            return False
        del left[at]
    return not left

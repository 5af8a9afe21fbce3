"""How two names on the graph are related: whether one may have been meant for the other."""

from __future__ import annotations

from collections.abc import Set
from functools import lru_cache

from launchlint.late import late
from launchlint.spelling import one_slip, same_digits

SLIP, NAMESPACE, WORDS, SIBLING, TWIN = "slip", "namespace", "words", "sibling", "twin"
RELATIONS = (SLIP, NAMESPACE, WORDS, SIBLING)
"""The relations that may be a mistake, the closest first."""
_DIRECTIONS = frozenset(
    frozenset(pair)
    for pair in (("from", "to"), ("rx", "tx"), ("receive", "send"), ("received", "sent"), ("recv", "send"), ("incoming", "outgoing"))
)
_SIDES = frozenset((*_DIRECTIONS, frozenset(("in", "out")), frozenset(("input", "output"))))
"""Of namespaces: what a device hears and what it says, as ``/fmu/in`` and ``/fmu/out`` of a flight controller."""
MOST_KEPT = 1 << 15
"""Pairs of names whose relation is kept: the same ones meet in each configuration of a launch, and in each launch of a robot."""
_SHORTEST_SLIP = 4
_SHORTEST_WORD = 3
_NO_DIGITS = dict.fromkeys(map(ord, "0123456789"))
_SEPARATORS = late("[/_]")


@lru_cache(maxsize=MOST_KEPT)
def relation(left: str, right: str) -> str:
    """How two different full names are related.

    ``slip``: one letter apart (a digit is no letter: it tells robots and cameras apart). ``namespace``: the same last part, and the
    namespace of one is the other's without something, as in ``/ns/x`` and ``/x``, or ``/a/b/x`` and ``/a/x``. ``words``: namespaces so
    related or equal, and the last part of one begins or ends with that of the other, as in ``radius_cmd_vel``. ``sibling``: the
    same last part in other namespaces. ``twin``: they differ in numbers only or in a mark such as ``_l`` and ``_r``, as those of two
    robots or cameras do, or are the two directions of one line to the outside: ``from_can_bus`` and ``to_can_bus``; or their namespaces are
    these, ``/fmu/in`` and ``/fmu/out``, or begin to differ in a number, as those of two robots do. Empty: none of these.
    """
    if left == right:
        return ""
    if _letters(left) == _letters(right) or _differ_in_a_mark(left, right) or _are_two_directions(left, right):
        return TWIN
    *outer, last = left[1:].split("/")
    *other, end = right[1:].split("/")
    if _differ_in_one_of(_SIDES, outer, other) or _are_of_twins(outer, other):
        return TWIN
    if last == end:
        if _is_within(outer, other) or _is_within(other, outer):
            return NAMESPACE
        return SLIP if _is_slip(left, right) else SIBLING
    if min(len(last), len(end)) >= _SHORTEST_SLIP and _is_slip(left, right):
        return SLIP
    if _is_within(outer, other) or _is_within(other, outer):
        words, more = sorted((last.split("_"), end.split("_")), key=len)
        if len(words) < len(more) and words in (more[: len(words)], more[-len(words) :]):
            return WORDS
    return ""


def _is_within(parts: list[str], all_parts: list[str]) -> bool:
    """Whether ``parts`` is left when something is taken out of ``all_parts``."""
    remaining = iter(all_parts)
    return all(part in remaining for part in parts)


def _differ_in_a_mark(left: str, right: str) -> bool:
    """Whether words of one or two letters are all that differs, as in ``pos_x`` and ``pos_y``."""
    words, others = _SEPARATORS.split(left), _SEPARATORS.split(right)
    if len(words) != len(others):
        return False
    return all(word == other or max(len(word), len(other)) < _SHORTEST_WORD for word, other in zip(words, others, strict=True))


def _are_two_directions(left: str, right: str) -> bool:
    return _differ_in_one_of(_DIRECTIONS, _SEPARATORS.split(left), _SEPARATORS.split(right))


def _are_of_twins(outer: list[str], other: list[str]) -> bool:
    """Whether the first namespaces that differ do so in their numbers only: what is below is that of one robot or of another."""
    first = next((pair for pair in zip(outer, other, strict=False) if pair[0] != pair[1]), None)
    return first is not None and _letters(first[0]) == _letters(first[1])


def _differ_in_one_of(pairs: Set[frozenset[str]], parts: list[str], others: list[str]) -> bool:
    """Whether all that differs is one part, and the two are one of the ``pairs``."""
    apart = [frozenset(pair) for pair in zip(parts, others, strict=False) if pair[0] != pair[1]]
    return len(parts) == len(others) and len(apart) == 1 and apart[0] in pairs


def _is_slip(left: str, right: str) -> bool:
    if abs(len(left) - len(right)) > 1 or not same_digits(left, right):
        return False
    # Most names are nothing alike, which is said at once: after one slip one of the two halves still agrees.
    half = min(len(left), len(right)) // 2 - 1
    if left[:half].casefold() != right[:half].casefold() and left[-half:].casefold() != right[-half:].casefold():
        return False
    return one_slip(left, (right,)) is not None


def _letters(name: str) -> str:
    return name.translate(_NO_DIGITS)

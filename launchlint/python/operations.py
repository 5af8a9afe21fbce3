"""Operators on values that are known: what Python makes of them, or MISSING where it cannot be told from the values alone."""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable
from typing import Any

from launchlint.python.failures import failure, of_python
from launchlint.python.plain import LARGEST_NUMBER, LARGEST_TEXT, SIMPLE, NotPlain, key_of, plain, value_of
from launchlint.python.values import (
    ENTRIES,
    MISSING,
    MOST_EXACT,
    Bound,
    Choice,
    Class,
    External,
    Failure,
    Function,
    Handle,
    Instance,
    Map,
    Module,
    Outside,
    Partial,
    Seq,
    Text,
    Unknown,
    Value,
)

_OPERATORS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
    ast.LShift: operator.lshift,
    ast.RShift: operator.rshift,
}
_ORDER: dict[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}
_UNARY: dict[type[ast.unaryop], Callable[[Any], Any]] = {ast.USub: operator.neg, ast.UAdd: operator.pos, ast.Invert: operator.invert}
_THINGS = (Class, Function, Handle, Instance, Module, Partial, Failure)
"""What is equal to itself only, where its class does not say otherwise."""
_MOST_DIGITS = re.compile(r"\d{5}")
LONGEST_INTEGER = 4096


def binary(left: Value, operation: type[ast.operator], right: Value) -> Value:
    """``left operation right``. Raises Raised."""
    if (
        isinstance(left, Seq)
        and isinstance(right, Seq)
        and operation is ast.Add
        and left.kind == right.kind
        and left.kind in ("list", "tuple")
    ):
        if len(left.items) + len(right.items) > MOST_EXACT:
            return MISSING
        return Seq([*left.items, *right.items], left.complete and right.complete, kind=left.kind)
    if operation is ast.Mult and isinstance(right, int) and isinstance(left, Seq) and left.kind in ("list", "tuple"):
        return _repeated(left, right)
    if operation is ast.Mult and isinstance(left, int) and isinstance(right, Seq) and right.kind in ("list", "tuple"):
        return _repeated(right, left)
    if operation is ast.BitOr and isinstance(left, Map) and isinstance(right, Map):
        return Map({**left.entries, **right.entries}, left.complete and right.complete)
    if operation is ast.Mod and isinstance(left, str):
        return formatted(left, right)
    try:
        one, other = plain(left), plain(right)
        if not _is_bounded(one, operation, other):
            return MISSING
        made = _OPERATORS[operation](one, other)
        return MISSING if isinstance(made, complex) else value_of(made)
    except (NotPlain, KeyError):
        return MISSING
    except (ArithmeticError, TypeError, ValueError) as error:
        raise of_python(error) from None


def _repeated(items: Seq, times: int) -> Value:
    if not items.complete or len(items.items) * times > MOST_EXACT:
        return MISSING
    return Seq(items.items * times, kind=items.kind)


def _is_bounded(one: Any, operation: type[ast.operator], other: Any) -> bool:
    """Whether the result is of a size that is worked out."""
    if operation is ast.Mult:
        for text, times in ((one, other), (other, one)):
            if isinstance(text, str) and isinstance(times, int) and len(text) * times > LARGEST_TEXT:
                return False
        return not (_is_whole(one) and _is_whole(other)) or one.bit_length() + other.bit_length() <= LONGEST_INTEGER
    if operation is ast.Pow and _is_whole(one) and _is_whole(other):
        return bool(-64 <= other <= LONGEST_INTEGER and one.bit_length() * abs(other) <= LONGEST_INTEGER)
    if operation is ast.LShift and _is_whole(one) and _is_whole(other):
        return bool(one.bit_length() + other <= LONGEST_INTEGER)
    if operation is ast.Add and isinstance(one, str) and isinstance(other, str):
        return len(one) + len(other) <= LARGEST_TEXT
    return not isinstance(one, int) or abs(one) < LARGEST_NUMBER


def _is_whole(value: Any) -> bool:
    return isinstance(value, int)


def formatted(pattern: str, value: Value) -> Value:
    """``pattern % value``. Raises Raised."""
    if _MOST_DIGITS.search(pattern) or len(pattern) > LARGEST_TEXT:
        return MISSING
    try:
        given = plain(value)
        if "*" in pattern and any(
            isinstance(each, int) and abs(each) > 9_999 for each in (given if isinstance(given, tuple) else (given,))
        ):
            return MISSING
        return MISSING if has_set(given) else value_of(pattern % given)
    except NotPlain:
        return MISSING
    except (ArithmeticError, TypeError, ValueError, KeyError) as error:
        raise of_python(error) from None


def shown(value: Value, spec: str, conversion: str) -> Value:
    """A value in an f-string or ``format``. Raises Raised."""
    if _MOST_DIGITS.search(spec):
        return MISSING
    try:
        given = plain(value)
        if has_set(given):
            return MISSING
        if conversion:
            given = repr(given) if conversion == "r" else str(given) if conversion == "s" else ascii(given)
        return value_of(format(given, spec))
    except NotPlain:
        return MISSING
    except (ArithmeticError, TypeError, ValueError) as error:
        raise of_python(error) from None


def has_set(given: Any) -> bool:
    """Whether there is a set in it, whose order nobody knows."""
    if isinstance(given, (set, frozenset)):
        return len(given) > 1
    if isinstance(given, dict):
        return any(has_set(each) for each in given.values())
    return isinstance(given, (list, tuple)) and any(has_set(each) for each in given)


def unary(operation: type[ast.unaryop], value: Value) -> Value:
    """``-value`` and the like. Raises Raised."""
    try:
        return value_of(_UNARY[operation](plain(value)))
    except (NotPlain, KeyError):
        return MISSING
    except TypeError as error:
        raise of_python(error) from None


def equal(one: Value, other: Value, depth: int = 0) -> bool | None:
    """``one == other``; None where that is not known."""
    if depth > 20 or isinstance(one, (Unknown, Choice)) or isinstance(other, (Unknown, Choice)):
        return None
    if isinstance(one, SIMPLE) and isinstance(other, SIMPLE):
        return bool(one == other)
    if one is other:
        return True
    if isinstance(one, (Text, Outside)) or isinstance(other, (Text, Outside)):
        return None if isinstance(one, (Text, Outside, str)) and isinstance(other, (Text, Outside, str)) else _apart(one, other)
    if isinstance(one, Seq) and isinstance(other, Seq):
        return _equal_items(one, other, depth)
    if isinstance(one, Map) and isinstance(other, Map):
        return _equal_entries(one, other, depth)
    if isinstance(one, External) and isinstance(other, External):
        return True if one == other else None
    return _apart(one, other)


def _apart(one: Value, other: Value) -> bool | None:
    """Whether two values of different kinds are equal."""
    for each in (one, other):
        if isinstance(each, Instance) and any(not isinstance(base, Class) or "__eq__" in base.attributes for base in each.type.order):
            return None
        if isinstance(each, (External, Outside, Bound)) or not isinstance(each, (*_THINGS, *SIMPLE, Seq, Map, Text)):
            return None
    return False


def _equal_items(one: Seq, other: Seq, depth: int) -> bool | None:
    if not one.is_sure or not other.is_sure or {"iterator", "view", "listing"} & {one.kind, other.kind}:
        return None
    sets = ("set", "frozenset")
    if one.kind in sets and other.kind in sets:
        try:
            return bool(plain(one) == plain(other))
        except NotPlain:
            return None
    if one.kind != other.kind or len(one.items) != len(other.items):
        return False
    answers = [equal(first, second, depth + 1) for first, second in zip(one.items, other.items, strict=True)]
    return False if False in answers else (None if None in answers else True)


def _equal_entries(one: Map, other: Map, depth: int) -> bool | None:
    if not one.complete or not other.complete:
        return None
    if one.entries.keys() != other.entries.keys():
        return None if any(isinstance(each, Text) for each in (*one.entries, *other.entries)) else False
    answers = [equal(each, other.content[ENTRIES][key], depth + 1) for key, each in one.entries.items()]
    return False if False in answers else (None if None in answers else True)


def contained(one: Value, many: Value) -> bool | None:
    """``one in many``; None where that is not known. Raises Raised."""
    if isinstance(many, str) and isinstance(one, str):
        return one in many
    if isinstance(many, Seq):
        if many.kind in ("set", "frozenset") and (isinstance(one, Map) or (isinstance(one, Seq) and one.kind == "list")):
            raise failure("TypeError", "unhashable type")
        answers = [equal(one, each) for each in many.items]
        return True if True in answers else (None if None in answers or not many.is_sure else False)
    if isinstance(many, Map):
        try:
            key = key_of(one)
            if not isinstance(key, (*SIMPLE, External)) and not hasattr(key, "items"):
                return None
            return (
                True
                if key in many.entries
                else (False if many.complete and not any(isinstance(each, Text) for each in many.entries) else None)
            )
        except (NotPlain, TypeError):
            return None
    return None


def ordered(left: Value, operation: type[ast.cmpop], right: Value) -> bool | None:
    """``left < right`` and the like; None where that is not known. Raises Raised."""
    try:
        return bool(_ORDER[operation](plain(left), plain(right)))
    except (NotPlain, KeyError):
        return None
    except TypeError as error:
        raise of_python(error) from None


def identical(one: Value, other: Value) -> bool | None:
    """``one is other``; None where that is not known."""
    if isinstance(one, (Unknown, Choice)) or isinstance(other, (Unknown, Choice)):
        return None
    if one is None or other is None or isinstance(one, bool) or isinstance(other, bool):
        known = (*SIMPLE, *_THINGS, Seq, Map, Text, External, Bound)
        if not isinstance(one, known) or not isinstance(other, known):
            return None
        return type(one) is type(other) and bool(one == other)
    if isinstance(one, (Seq, Map, *_THINGS)) or isinstance(other, (Seq, Map, *_THINGS)):
        empty = isinstance(one, Seq) and isinstance(other, Seq) and one.kind == other.kind == "tuple"
        return None if empty else one is other
    return None

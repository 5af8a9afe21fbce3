"""How large a value is, and how large it would become: asked before anything is computed."""

from __future__ import annotations

import re
from typing import Any

from launchlint.evaluate.expression.errors import UnknownValue

MOST_STEPS = 20_000
#: Size of one value: its characters, or its elements with all that they hold.
LARGEST_VALUE = 1_000_000
#: Size of everything an expression looks at and makes, together.
MOST_WORK = 4_000_000
LARGEST_BITS = 10_000
LARGEST_WIDTH = 10_000
LARGEST_COUNTED = 1_000

DICT_VIEWS: tuple[type[Any], ...] = (type({}.keys()), type({}.values()), type({}.items()))
ATOMS: tuple[type, ...] = (bool, float, type(None))
SETS: tuple[type[Any], ...] = (set, frozenset)
CONTAINERS: tuple[type[Any], ...] = (list, tuple, *SETS, *DICT_VIEWS)

_DIGITS = re.compile(r"\d+")
_PERCENT = re.compile(r"%(?:\([^()]*\))?[#0\- +]*(\*|\d+)?(?:\.(\*|\d+)?)?")


class Function:
    """Something that can be called; ``type_`` is the type it stands for, as ``isinstance`` needs it."""

    __slots__ = ("call", "name", "type_")

    def __init__(self, name: str, call: Any, type_: type | None = None) -> None:
        self.name = name
        self.call = call
        self.type_ = type_


class Stream:
    """What can be gone through once: a generator, ``zip``, ``map`` and their like. Every item taken is counted."""

    __slots__ = ("items",)

    def __init__(self, items: Any) -> None:
        self.items = items


def too_large(what: str) -> UnknownValue:
    """The answer to an expression that would need more room or time than we give it."""
    return UnknownValue(f"{what} would be larger than launchlint is willing to compute")


def size_of(value: Any, functions: bool = False) -> int:
    """Size of a plain value, all that it holds included.

    Raises UnknownValue over the bounds and for what is not a plain value; with ``functions``, functions inside containers are let through.
    """
    kind: type[Any] = type(value)
    if kind is str:
        size = len(value) + 1
        if size > LARGEST_VALUE:
            raise too_large("the text")
        return size
    if kind in ATOMS:
        return 1
    if kind is int:
        if value.bit_length() > LARGEST_BITS:
            raise too_large("the number")
        return 1
    if kind is range:
        if not -LARGEST_VALUE <= value.start <= LARGEST_VALUE or not -LARGEST_VALUE <= value.stop <= LARGEST_VALUE:
            raise too_large("the range")
        return 1
    if kind is Function and functions:
        return 1
    if kind is dict or kind in CONTAINERS:
        return _size_of_all(value, functions)
    raise UnknownValue(f"a value of type {kind.__name__} is not something launchlint computes with")


def _size_of_all(value: Any, functions: bool) -> int:
    size = 1
    for item in value:
        size += size_of(item, functions)
        if size > LARGEST_VALUE:
            break
    if type(value) is dict:
        for item in value.values():
            size += size_of(item, functions)
            if size > LARGEST_VALUE:
                break
    if size > LARGEST_VALUE:
        raise too_large("the list")
    return size


def check_order(value: Any) -> None:
    """Refuse a set whose order Python chooses anew on every start, wherever it stands in ``value``."""
    if isinstance(value, SETS):
        if len(value) > 1:
            raise UnknownValue("the order of a set is different each time")
    elif isinstance(value, dict):
        for key, item in value.items():
            check_order(key)
            check_order(item)
    elif type(value) in CONTAINERS:
        for item in value:
            check_order(item)


def check_power(base: Any, exponent: Any) -> None:
    """``base ** exponent``: of integers, the bits of the result are known beforehand."""
    whole = isinstance(base, int) and isinstance(exponent, int) and exponent > 0 and abs(base) > 1
    if whole and (exponent > LARGEST_BITS or base.bit_length() * exponent > LARGEST_BITS):
        raise too_large("the power")


def check_shift(value: object, places: object) -> None:
    """``value << places``."""
    if isinstance(value, int) and isinstance(places, int) and value and places + value.bit_length() > LARGEST_BITS:
        raise too_large("the shifted number")


def check_product(left: object, right: object) -> None:
    """``left * right``, repetition of a text or list included."""
    for value, times in ((left, right), (right, left)):
        if isinstance(times, int) and isinstance(value, (str, list, tuple)) and times > 0 and size_of(value, True) * times > LARGEST_VALUE:
            raise too_large("the repeated text or list")


def check_width(specification: str) -> int:
    """Largest number in a format specification (a width, a precision), which must be within the bounds."""
    widest = 0
    for digits in _DIGITS.findall(specification):
        if len(digits) > 5 or int(digits) > LARGEST_WIDTH:
            raise too_large("the formatted text")
        widest = max(widest, int(digits))
    return widest


def percent_size(template: str, values: object) -> int:
    """At most how long ``template % values`` becomes."""
    simple = "((" not in template
    if not simple:
        check_width(template)
    fields, widest, starred = 0, 0, False
    for field in _PERCENT.finditer(template):
        fields += 1
        for number in field.groups(default=""):
            starred = starred or number == "*"
            widest = max(widest, check_width(number))
    if starred:
        widths = [abs(value) for value in (values if isinstance(values, tuple) else (values,)) if isinstance(value, int)]
        widest = max(widest, *widths, 0)
        if widest > LARGEST_WIDTH:
            raise too_large("the formatted text")
    return len(template) + fields * (widest + shown_size(values)) + (0 if simple else LARGEST_VALUE // 2)


def format_size(template: str, values: object) -> int:
    """At most how long ``template.format(…)`` becomes; fields that look into a value or at its attributes are not covered."""
    import string

    size, largest = len(template), shown_size(values)
    for _literal, field, specification, _conversion in string.Formatter().parse(template):
        if field is None:
            continue
        if "." in field or "[" in field:
            raise UnknownValue("a format field that looks into its value is not covered")
        if "{" in (specification or ""):
            raise UnknownValue("a format specification made by another field is not covered")
        size += check_width(specification or "") + largest
        if size > LARGEST_VALUE:
            raise too_large("the formatted text")
    return size


def shown_size(value: Any) -> int:
    """At most how long ``repr(value)`` is: a character may become ten, a number has some 3,000 digits at most."""
    kind = type(value)
    if isinstance(value, str):
        return 10 * len(value) + 2
    if isinstance(value, int):
        return value.bit_length() // 3 + 5
    if kind is dict:
        return 2 + sum(shown_size(key) + shown_size(item) + 4 for key, item in value.items())
    if kind in CONTAINERS:
        return 20 + sum(shown_size(item) + 2 for item in value)
    return 400  # a float with "%f" has up to 309 digits

"""What rcl takes the text of a scalar for.

Source: ``rcl_yaml_param_parser/src/parse.c`` (``get_value``), which uses strtoll with base 0 and strtod of the C library. They are no
YAML: ``010`` is 8, ``08`` is 8.0, ``1e3`` and ``inf`` are doubles, ``y`` is true; ``1_000``, ``0o10`` and ``12:30`` are strings.
"""

from __future__ import annotations

import re

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    Type = Literal["bool", "int", "double", "str", "bool[]", "int[]", "double[]", "str[]", "none"]
    Scalar = bool | int | float | str

STR_TAG = "tag:yaml.org,2002:str"

_TRUE = frozenset(("Y", "y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"))
_FALSE = frozenset(("N", "n", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"))
_SIGNS = frozenset("0123456789+-.iInN \t\n\v\f\r")
"""What a number can begin with."""
_INTEGER = re.compile(r"[ \t\n\v\f\r]*([+-]?)(?:0[xX]([0-9a-fA-F]+)|(0[0-7]*)|([1-9][0-9]*))")
_DECIMAL = re.compile(r"[ \t\n\v\f\r]*([+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)")
_HEXADECIMAL = re.compile(r"[ \t\n\v\f\r]*([+-]?0[xX](?:[0-9a-fA-F]+(?:\.[0-9a-fA-F]*)?|\.[0-9a-fA-F]+)(?:[pP][+-]?[0-9]+)?)")
_WORD = re.compile(r"[ \t\n\v\f\r]*([+-]?)(inf(?:inity)?|nan(?:\([A-Za-z0-9_]*\))?)", re.IGNORECASE)
_YAML_WORDS = frozenset(f"{sign}.{word}" for sign in ("", "+", "-") for word in ("inf", "Inf", "INF")) | {".nan", ".NaN", ".NAN"}
_SMALLEST = 2.2250738585072014e-308


class ScalarValue(NamedTuple):
    """What one scalar is."""

    type: Literal["bool", "int", "double", "str"]
    data: Scalar


class Value(NamedTuple):
    """What a parameter is set to: ``data`` is a plain value, a tuple of them for the types with ``[]``, and None for ``none``."""

    type: Type
    data: Scalar | tuple[Scalar, ...] | None


NONE = Value("none", None)
"""A parameter that has a name and no value: rcl makes it of an empty list."""


def scalar(text: str, quoted: bool = False, tag: str | None = None) -> ScalarValue:
    """The value of a scalar that YAML reads as ``text``; a block text (``|``, ``>``) is not ``quoted``."""
    text = text.partition("\0")[0]
    if quoted or tag == STR_TAG:
        return ScalarValue("str", text)
    if text in _TRUE:
        return ScalarValue("bool", True)
    if text in _FALSE:
        return ScalarValue("bool", False)
    if text[:1] in _SIGNS:
        number = _integer(text)
        if number is not None:
            return ScalarValue("int", number)
        real = _real(text)
        if real is not None:
            return ScalarValue("double", real)
    return ScalarValue("str", text)


def _integer(text: str) -> int | None:
    match = _INTEGER.fullmatch(text)
    if match is None or len(text) > 1_000:
        return None
    sign, hexadecimal, octal, decimal = match.groups()
    number = int(hexadecimal, 16) if hexadecimal else int(octal, 8) if octal else int(decimal)
    number = -number if sign == "-" else number
    return number if -(2**63) <= number < 2**63 else None


def _real(text: str) -> float | None:
    """What strtod makes of the whole text; None also where it says that the number is beyond a double, large or small."""
    if text in _YAML_WORDS:
        return float(text.replace(".", ""))
    match = _WORD.fullmatch(text)
    if match is not None:
        return float(match[1] + match[2][:3])
    match = _DECIMAL.fullmatch(text)
    if match is not None:
        number, digits = float(match[1]), match[1].lower().partition("e")[0]
    else:
        match = _HEXADECIMAL.fullmatch(text)
        if match is None:
            return None
        try:
            number, digits = float.fromhex(match[1]), match[1].lower().partition("p")[0].partition("x")[2]
        except OverflowError:
            return None
    if number in (float("inf"), float("-inf")) or (abs(number) < _SMALLEST and re.search("[1-9a-f]", digits)):
        return None
    return number

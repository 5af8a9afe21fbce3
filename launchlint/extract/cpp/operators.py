"""Literals and operators: the text and the numbers that names are made of."""

from __future__ import annotations

import re
from functools import lru_cache

from launchlint.extract.cpp.naming import braced, is_whole, template, together
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import UNKNOWN, Callable, Cell, Null, Number, Text, Thing, Value, choices, plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_ESCAPES = {"n": "\n", "t": "\t", "0": "", "r": "", "\\": "\\", '"': '"', "'": "'", "/": "/"}
LONGEST_TEXT = 2_000
_STREAMS = ("stringstream", "ostringstream")


def literal(node: Node) -> Value:
    """The text of a string literal."""
    if node.kind == "raw_string_literal":
        content = node.child("raw_string_content")
        return Text(braced(content.text if content else "")[:LONGEST_TEXT])
    return _literal(node.text)


@lru_cache(maxsize=4096)
def _literal(text: str) -> Text:
    return Text(braced(unescaped(text[text.find('"') + 1 : text.rfind('"')]))[:LONGEST_TEXT])


def unescaped(text: str) -> str:
    """The text that a literal with escapes stands for."""
    return re.sub(r"\\(.)", lambda match: _ESCAPES.get(match[1], match[1]), text) if "\\" in text else text


@lru_cache(maxsize=2048)
def number(text: str) -> Value:
    """The value of a number literal."""
    plain_text = text.replace("'", "").rstrip("fFlLuU") if not text.lower().startswith("0x") else text.rstrip("lLuU")
    if len(plain_text) > 40:
        return UNKNOWN
    try:
        if any(char in plain_text for char in ".eE") and not plain_text.lower().startswith("0x"):
            return Number(float(plain_text))
        if text[-1:] in "fF" and not plain_text.lower().startswith("0x"):
            return Number(float(plain_text))
        if len(plain_text) > 1 and plain_text[0] == "0" and plain_text.isdigit():
            return Number(int(plain_text, 8))
        return Number(int(plain_text, 0))
    except ValueError:
        return UNKNOWN


def combined(machine: Machine, sign: str, left: Value, right: Value) -> Value:
    """The value of ``left sign right``."""
    if sign == "<<" and isinstance(left, Thing):
        if left.type.last in _STREAMS:
            cell = left.fields.setdefault("<text>", Cell(Text("")))
            machine.write(cell, together(cell.value, right))
        return left
    if sign == "%" and isinstance(left, Thing) and left.type.last == "format":
        cell = left.fields.setdefault("<text>", Cell(UNKNOWN))
        if isinstance(cell.value, Text):
            machine.write(cell, Text(filled(cell.value.template, template(right))))
        return left
    if sign == "+":
        texts = [each for side in (left, right) for _, each in choices(side) if isinstance(each, Text)]
        if texts:
            found = together(left, right)
            return found if not isinstance(found, Text) or len(found.template) <= LONGEST_TEXT else UNKNOWN
    if sign in ("==", "!="):
        return _equal(left, right, sign == "==")
    if sign in ("&&", "||"):
        if isinstance(right, Number) and bool(right.value) is (sign == "||"):
            return Number(bool(right.value))
        return UNKNOWN
    if isinstance(left, Number) and isinstance(right, Number):
        return _arithmetic(sign, left.value, right.value)
    return UNKNOWN


def filled(text: str, value: str) -> str:
    """A format with its first place filled in (boost::format, printf)."""
    match = re.search(r"%(?:\d+%|\d+\$\w|[-+ #0]*([1-9]\d*|)(?:\.\d+)?(?:hh|h|ll|l|z)?[a-zA-Z])", text)
    if match is None:
        return text
    if match[0].startswith("%0") and match[1] and value.isdigit():
        value = value.zfill(min(int(match[1][:2]), 20))
    return text[: match.start()] + value + text[match.end() :]


def _equal(left: Value, right: Value, wanted: bool) -> Value:
    if any(isinstance(each, Text) and not is_whole(each) for each in (left, right)):
        return UNKNOWN  # the name of a node, and of its namespace, is known where it is launched
    first, second = plain(left), plain(right)
    if isinstance(left, Null) or isinstance(right, Null):
        other = right if isinstance(left, Null) else left
        return (
            Number((isinstance(other, Null)) is wanted)
            if isinstance(other, (Null, Thing, Callable)) and isinstance(other, Null)
            else UNKNOWN
        )
    if first is None or second is None or isinstance(left, Text) is not isinstance(right, Text):
        return UNKNOWN
    if isinstance(left, Number) and isinstance(right, Number):
        return Number((left.value == right.value) is wanted)
    return Number((first == second) is wanted)


def _arithmetic(sign: str, left: float, right: float) -> Value:
    if abs(left) > 1e15 or abs(right) > 1e15:
        return UNKNOWN
    whole = isinstance(left, int) and isinstance(right, int)
    if sign in ("+", "-", "*"):
        return Number(left + right if sign == "+" else left - right if sign == "-" else left * right)
    if sign == "/" and right:
        return Number(int(left / right) if whole else left / right)
    if sign == "%" and whole and right:
        return Number(int(left) % int(right))
    if sign in ("<", ">", "<=", ">="):
        return Number({"<": left < right, ">": left > right, "<=": left <= right, ">=": left >= right}[sign])
    return UNKNOWN

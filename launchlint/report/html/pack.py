"""The page's data as small JSON: lists of objects become columns, in which equal values stand once. ``js/unpack.js`` is the reverse.

A list of objects is written ``{"$rows": COUNT, "columns": {KEY: COLUMN}}``. A column is a list of cells, ``{"$all": CELL}`` where all are
the same, or ``{"$of": LIST, "$at": INDEXES}``: the distinct cells, and which of them each row has. The indexes are numbers, or, where
they are small, the characters of one string (:data:`DIGITS`); -1 or ``.`` stands for a row without that key. In a list
``{"$front": [TEXT, …]}`` each text says with its first character (of DIGITS) how much of the text before it begins in the same way.

The page's data is several lines: the first is all of it but the :data:`PARTS` of entry files, which follow in a line for each, and the
library, which is the last line: what nobody opens is not even read.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

DIGITS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-"
"""Digits for small numbers, one character each."""
PARTS = ("containers", "nodes", "channels", "connections", "params")
"""What of an entry file stands in its own line."""
LAST = "library"
"""What stands in the last line."""
_text = json.encoder.encode_basestring
_json = json.JSONEncoder(ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode


def script(data: Mapping[str, Any]) -> str:
    """The page's data as the content of a ``<script>`` element: JSON in which nothing can end the element or begin another.

    ``<``, ``>`` and ``&`` stand in strings only, so their escapes mean the same; U+2028 and U+2029 end lines for JavaScript.
    """
    heads = [{key: value for key, value in entry.items() if key not in PARTS} for entry in data["entries"]]
    head = {key: heads if key == "entries" else value for key, value in data.items() if key != LAST}
    text = "\n".join([packed(head), *(packed({key: entry[key] for key in PARTS}) for entry in data["entries"]), packed(data[LAST])])
    for character in "<>&\u2028\u2029":
        text = text.replace(character, f"\\u{ord(character):04x}")
    return text


def packed(value: Any) -> str:
    """``value``, plain JSON, in the small form; time and size grow with its size."""
    if isinstance(value, str):
        return _text(value)
    if type(value) is int:
        return str(value)
    if type(value) is bool:
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{" + ",".join(f"{_text(key)}:{packed(item)}" for key, item in value.items()) + "}"
    if not isinstance(value, (list, tuple)):
        return _json(value)
    if len(value) > 1 and all(isinstance(item, dict) for item in value):
        return _table(value)
    return "[" + ",".join(map(packed, value)) + "]"


def _table(rows: Sequence[Mapping[str, Any]]) -> str:
    first = rows[0].keys()
    keys = first if all(row.keys() == first for row in rows) else dict.fromkeys(key for row in rows for key in row)
    columns = ",".join(f"{_text(key)}:{_column([row.get(key, _MISSING) for row in rows])}" for key in keys)
    return f'{{"$rows":{len(rows)},"columns":{{{columns}}}}}'


_MISSING = object()
_TEXTS, _INTEGERS = {str}, {int}


def _column(cells: Sequence[Any]) -> str:
    """A column of plain JSON values; :data:`_MISSING` stands for one that is not there."""
    present = [cell for cell in cells if cell is not _MISSING]
    are_texts = set(map(type, present)) == _TEXTS
    # Texts are told apart as they are, everything else as it is written: True is not 1.
    written = present if are_texts else list(map(_cell, present))
    distinct = list(dict.fromkeys(written))
    whole = len(present) == len(cells)
    if len(distinct) == 1 and whole:
        return f'{{"$all":{_text(distinct[0]) if are_texts else distinct[0]}}}'
    list_ = _texts if are_texts else _values
    if len(distinct) == len(cells):
        return list_(distinct)
    numbers = {cell: number for number, cell in enumerate(distinct)}
    following = iter(written)
    at = [-1 if cell is _MISSING else numbers[next(following)] for cell in cells]
    is_short = len(distinct) < len(DIGITS)
    indexes = f'"{"".join("." if number < 0 else DIGITS[number] for number in at)}"' if is_short else f"[{','.join(map(str, at))}]"
    shared = f'{{"$of":{list_(distinct)},"$at":{indexes}}}'
    if not whole or 2 * len(distinct) <= len(cells):
        return shared
    plain = list_(written)
    return plain if len(plain) <= len(shared) else shared


def _cell(value: Any) -> str:
    """The same as :func:`packed`, quicker for what most cells are: lists without objects in them."""
    if type(value) is list or type(value) is tuple:
        if not value:
            return "[]"
        kinds = set(map(type, value))
        if kinds == _INTEGERS:
            return f"[{','.join(map(str, value))}]"
        if kinds == _TEXTS:
            return f"[{','.join(map(_text, value))}]"
        text = _json(value)
        return packed(value) if "{" in text else text
    return packed(value)


def _values(cells: Sequence[str]) -> str:
    """A list of cells that are JSON already."""
    return f"[{','.join(cells)}]"


def _texts(texts: Sequence[str]) -> str:
    """A list of texts; where they begin alike, without what each has in common with the one before."""
    plain = f"[{','.join(map(_text, texts))}]"
    if len(texts) < 2:
        return plain
    before, shared = "", 0
    rests = []
    for text in texts:
        shared = _common(before, text, shared) if text[:1] == before[:1] else 0
        rests.append(_text(f"{DIGITS[shared]}{text[shared:]}"))
        before = text
    front = f'{{"$front":[{",".join(rests)}]}}'
    return front if len(front) < len(plain) else plain


def _common(one: str, other: str, likely: int) -> int:
    """How many characters both begin with, of those that a digit can count and JavaScript counts as one; sooner if it is ``likely``."""
    least, most = 0, min(len(one), len(other), len(DIGITS) - 1)
    if likely <= most and one[:likely] == other[:likely]:
        least = likely
        if likely < most and one[likely] != other[likely]:
            most = likely
    while least < most:
        middle = (least + most + 1) // 2
        if one[least:middle] == other[least:middle]:
            least = middle
        else:
            most = middle - 1
    shared = one[:least]
    return least if shared.isascii() else next((at for at, each in enumerate(shared) if each > "\uffff"), least)

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
    if isinstance(value, dict):
        return "{" + ",".join(f"{_text(key)}:{packed(item)}" for key, item in value.items()) + "}"
    if not isinstance(value, (list, tuple)):
        return _json(value)
    if len(value) > 1 and all(isinstance(item, dict) for item in value):
        return _table(value)
    return "[" + ",".join(map(packed, value)) + "]"


def _table(rows: Sequence[Mapping[str, Any]]) -> str:
    keys = dict.fromkeys(key for row in rows for key in row)
    columns = ",".join(f"{_text(key)}:{_column([None if key not in row else packed(row[key]) for row in rows])}" for key in keys)
    return f'{{"$rows":{len(rows)},"columns":{{{columns}}}}}'


def _column(cells: Sequence[str | None]) -> str:
    """A column whose cells are JSON already; None stands for a missing one."""
    distinct = list(dict.fromkeys(cell for cell in cells if cell is not None))
    present = [cell for cell in cells if cell is not None]
    if len(distinct) == 1 and len(present) == len(cells):
        return f'{{"$all":{distinct[0]}}}'
    numbers = {cell: number for number, cell in enumerate(distinct)}
    at = [-1 if cell is None else numbers[cell] for cell in cells]
    if len(distinct) < len(DIGITS):
        indexes = f'"{"".join("." if number < 0 else DIGITS[number] for number in at)}"'
    else:
        indexes = f"[{','.join(map(str, at))}]"
    shared = f'{{"$of":{_list(distinct)},"$at":{indexes}}}'
    plain = _list(present) if len(present) == len(cells) else ""
    return plain if plain and len(plain) <= len(shared) else shared


def _list(cells: Sequence[str]) -> str:
    """A list of cells; where they are texts that begin alike, without what they have in common with the one before."""
    plain = f"[{','.join(cells)}]"
    if len(cells) < 2 or not all(cell.startswith('"') for cell in cells):
        return plain
    before = ""
    texts = []
    for cell in cells:
        text = json.loads(cell)
        shared = _common(before, text)
        texts.append(_text(f"{DIGITS[shared]}{text[shared:]}"))
        before = text
    front = f'{{"$front":[{",".join(texts)}]}}'
    return front if len(front) < len(plain) else plain


def _common(one: str, other: str) -> int:
    """How many characters both begin with, of those that a digit can count and JavaScript counts as one."""
    least, most = 0, min(len(one), len(other), len(DIGITS) - 1)
    while least < most:
        middle = (least + most + 1) // 2
        if one[:middle] == other[:middle]:
            least = middle
        else:
            most = middle - 1
    shared = one[:least]
    return least if shared.isascii() else next((at for at, each in enumerate(shared) if each > "\uffff"), least)

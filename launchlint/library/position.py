"""Where something stands in a JSON text: looked for only when there is something to say about it."""

from __future__ import annotations

import json
from collections.abc import Sequence


def position(text: str, path: Sequence[str | int]) -> tuple[int, int]:
    """Line and column (from 1) of what ``path`` leads to in a JSON text; of the innermost thing on the way where it does not exist.

    A key is meant where the last step is one that only the validator dislikes; its value stands behind it.
    """
    at = _skip(text, 0)
    for step in path:
        found = _member(text, at, step) if isinstance(step, str) else _item(text, at, step)
        if found is None:
            break
        at = found
    line = text.count("\n", 0, at) + 1
    return line, at - (text.rfind("\n", 0, at) + 1) + 1


_DECODER = json.JSONDecoder()


def _skip(text: str, at: int) -> int:
    while text[at : at + 1] in (" ", "\t", "\n", "\r"):
        at += 1
    return at


def _member(text: str, at: int, key: str) -> int | None:
    """Where the value of ``key`` begins in the object at ``at``; of equal keys the last, as the reader does."""
    found = None
    at = _skip(text, at + 1)
    while text[at : at + 1] == '"':
        name, at = _DECODER.raw_decode(text, at)
        at = _skip(text, _skip(text, at) + 1)
        if name == key:
            found = at
        at = _skip(text, _DECODER.raw_decode(text, at)[1])
        at = _skip(text, at + 1) if text[at : at + 1] == "," else at
    return found


def _item(text: str, at: int, index: int) -> int | None:
    at = _skip(text, at + 1)
    for _ in range(index):
        if text[at : at + 1] in ("", "]"):
            return None
        at = _skip(text, _skip(text, _DECODER.raw_decode(text, at)[1]) + 1)
    return at

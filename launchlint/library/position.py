"""Where something stands in a JSON text: looked for only when there is something to say about it."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Sequence

from launchlint.late import late

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.library.validate import Fault

_DECODER = json.JSONDecoder()
_BLANKS = late(r"[ \t\n\r]*")
_TOKEN = late(r'"(?:[^"\\]|\\.)*(?:"|\\?\Z)|NaN|-?Infinity|-?[0-9]+(?:\.[0-9]+)?(?:[eE][-+]?[0-9]+)?', re.DOTALL)
_ESCAPE = late(r"\\(?:u[dD][89abAB]..\\u[dD][c-fC-F]..|(u[dD][89a-fA-F]..)|.)", re.DOTALL)

LONGEST_NUMBER = 4_300
"""Digits of a whole number that Python reads."""


def located(text: str, path: str, found: Iterable[Fault]) -> list[str]:
    """What is wrong with the library at ``path``, each as ``path:line:column: message``."""
    places = Places(text)
    lines = []
    for fault in found:
        line, column = line_and_column(text, places.find(fault.path))
        lines.append(f"{path}:{line}:{column}: {fault.message}")
    return lines


def line_and_column(text: str, at: int) -> tuple[int, int]:
    """Line and column, from 1, of a character."""
    return text.count("\n", 0, at) + 1, at - (text.rfind("\n", 0, at) + 1) + 1


def unreadable_number(text: str) -> tuple[int, str] | None:
    """Where the first number of a JSON text stands that is none (NaN), too long, or too large to be held, and what it is."""
    for token in _TOKEN.finditer(text):
        word = token[0]
        if word[0] != '"' and (
            word[-1] in "Ny" or (len(word) > LONGEST_NUMBER if word.lstrip("-").isdecimal() else "inf" in str(float(word)))
        ):
            return token.start(), word
    return None


def lone_surrogate(text: str) -> int | None:
    r"""Where a JSON text has half of a character, such as ``\ud800`` alone: no encoding can hold it."""
    if "\\ud" not in text and "\\uD" not in text:
        return None
    return next((escape.start() for escape in _ESCAPE.finditer(text) if escape[1]), None)


class Places:
    """Where things stand in one JSON text. Each list and mapping on the way is read once, however often it is asked for."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._read: dict[int, dict[str | int, int]] = {}

    def find(self, path: Sequence[str | int]) -> int:
        """Where what ``path`` leads to begins; where it does not exist, the innermost thing on the way.

        A key is meant where the last step is one that only the validator dislikes; its value stands behind it.
        """
        at = self._skip(0)
        for step in path:
            if at not in self._read:
                self._read[at] = self._members(at)
            inner = self._read[at].get(step)
            if inner is None:
                break
            at = inner
        return at

    def _members(self, at: int) -> dict[str | int, int]:
        """Where each member of the list or mapping at ``at`` begins; of equal keys the last, as the reader does."""
        text, found = self._text, dict[str | int, int]()
        opening = text[at : at + 1]
        if opening not in ("{", "["):
            return found
        at = self._skip(at + 1)
        try:
            while text[at : at + 1] not in ("", "}", "]"):
                key: str | int = len(found)
                if opening == "{":
                    key, at = _DECODER.raw_decode(text, at)
                    at = self._skip(self._skip(at) + 1)
                found[key] = at
                at = self._skip(_DECODER.raw_decode(text, at)[1])
                at = self._skip(at + 1) if text[at : at + 1] == "," else at
        except (RecursionError, ValueError):  # nested so deep that there is no room for one level more
            pass
        return found

    def _skip(self, at: int) -> int:
        found = _BLANKS.match(self._text, at)
        return at if found is None else found.end()

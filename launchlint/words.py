"""Splitting a line into words as a shell does, in time that grows with its length."""

from __future__ import annotations

import re

from launchlint.late import late

_PIECE = late(
    r"""[ \t\r\n]+
    | (?P<plain>[^ \t\r\n'"\\]+)
    | '(?P<single>[^']*)'
    | "(?P<double>[^"\\]*(?:\\.[^"\\]*)*)"
    | \\(?P<escaped>.)""",
    re.DOTALL | re.VERBOSE,
)
_IN_QUOTES = late(r'\\(["\\])')


def split_words(text: str) -> list[str]:
    """The words of ``text``, exactly as Python's ``shlex.split`` gives them, with which roslaunch splits ``args``, ``launch-prefix`` and
    ``command``; that one takes minutes for a megabyte.

    Raises ValueError, with the words of shlex, for a quote that is not closed and for a backslash at the end.
    """
    words: list[str] = []
    parts: list[str] | None = None
    at = 0
    while at < len(text):
        match = _PIECE.match(text, at)
        if match is None:
            raise ValueError(_reason(text, at))
        at = match.end()
        kind = match.lastgroup
        if kind is None:
            if parts is not None:
                words.append("".join(parts))
            parts = None
            continue
        piece = match[kind]
        parts = [] if parts is None else parts
        parts.append(_IN_QUOTES.sub(r"\1", piece) if kind == "double" else piece)
    if parts is not None:
        words.append("".join(parts))
    return words


def _reason(text: str, at: int) -> str:
    """Why nothing matches there: a quote without an end, or a backslash that is the last character."""
    backslashes = len(text) - len(text.rstrip("\\"))
    return "No escaped character" if text[at] != "'" and backslashes % 2 else "No closing quotation"

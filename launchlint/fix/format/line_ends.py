"""The kinds of line ends: all become LF while a text is worked on, and what prevailed when it is written."""

from __future__ import annotations

import re

_LINE_END = re.compile(r"\r\n|\r")


def with_line_feeds(text: str) -> str:
    """``text`` with LF for CRLF and CR, as every XML parser reads it (XML 1.0, 2.11)."""
    return _LINE_END.sub("\n", text) if "\r" in text else text


def prevailing_line_end(text: str) -> str:
    """The kind of line end that is most frequent in ``text``; LF where there is none, or as many of it as of another."""
    windows = text.count("\r\n")
    counts = {"\n": text.count("\n") - windows, "\r\n": windows, "\r": text.count("\r") - windows}
    return max(counts, key=lambda kind: counts[kind])

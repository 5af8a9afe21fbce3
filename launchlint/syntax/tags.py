"""A tolerant look at one piece of broken XML: which tag, comment or text is it, and what attributes were meant."""

from __future__ import annotations

import re
from typing import Literal

from launchlint.named_tuple import NamedTuple
from launchlint.source import Span

NAME = re.compile(r"[^\s<>/=\"'&;]+")
CONFLICT = re.compile(r"(?:<{7}|={7}|>{7})(?=[ \r\n]|$)")
UNRESOLVED = "an unresolved merge conflict"
_SPACE = re.compile(r"[ \t\r\n]*")
_ATTRIBUTE_NAME = re.compile(r"""[^\s=/><]+""")
_TAG_NAME = re.compile(r"""[^\s=/>"'<]+""")


class Verdict(NamedTuple):
    """What is wrong, where, and what to show with it."""

    message: str
    span: Span
    hint: str = ""
    related: tuple[tuple[Span, str], ...] = ()
    opened: str = ""
    closed: str = ""


def conflict_verdict(span: Span) -> Verdict:
    """The verdict for a line that a merge left behind."""
    return Verdict(UNRESOLVED, span, "choose one side and remove the lines with <<<<<<<, ======= and >>>>>>>")


class Token(NamedTuple):
    """One piece of the text; ``name`` and ``closing`` only of a tag. ``end`` is where it ends or, never closed, the end of the text."""

    kind: Literal["tag", "comment", "text", "other"]
    start: int
    end: int
    name: str = ""
    closing: bool = False


class Written(NamedTuple):
    """An attribute as far as it is one: ``value_start`` is -1 without a quoted value, ``value_end`` -1 if the quote is never closed."""

    name: str
    start: int
    end: int
    value_start: int
    value_end: int


def token_at(text: str, start: int, offset: int) -> Token:
    """The piece that holds ``offset``; ``start`` is a place at or before it where a piece begins."""
    if start > offset:
        start = text.rfind("<", 0, offset + 1)
    start = max(start, 0)
    while True:
        token = _token(text, start)
        if token.end > offset or token.end >= len(text) or token.end <= start:
            return token
        start = token.end


def _token(text: str, start: int) -> Token:
    if not text.startswith("<", start):
        end = text.find("<", start)
        return Token("text", start, len(text) if end < 0 else end)
    if text.startswith("<!--", start):
        return Token("comment", start, _after(text, "-->", start + 4))
    if text.startswith("<![CDATA[", start):
        return Token("other", start, _after(text, "]]>", start))
    if text.startswith("<?", start):
        return Token("other", start, _after(text, "?>", start))
    if text.startswith("<!", start):
        return Token("other", start, _after(text, ">", start))
    closing = text.startswith("</", start)
    name = _TAG_NAME.match(text, start + 1 + closing)
    if name is None or text[start + 1 + closing] in " \t\r\n":
        return Token("tag", start, min(start + 2, len(text)), "", closing)
    return Token("tag", start, _tag_end(text, name.end()), name[0], closing)


def _after(text: str, what: str, start: int) -> int:
    found = text.find(what, start)
    return len(text) if found < 0 else found + len(what)


def _tag_end(text: str, position: int) -> int:
    """The offset after the ``>`` of a tag, quotes respected."""
    quote = re.compile(r"[\"'>]")
    while (match := quote.search(text, position)) is not None:
        if match[0] == ">":
            return match.end()
        closing = text.find(match[0], match.end())
        if closing < 0:
            break
        position = closing + 1
    return len(text)


def attributes_of(text: str, token: Token) -> list[Written]:
    """The attributes of a tag, up to the first that is none or at most 1,000."""
    found: list[Written] = []
    position = token.start + 1 + token.closing + len(token.name)
    while len(found) < 1000:
        position = _SPACE.match(text, position).end()  # type: ignore[union-attr]  # matches the empty string
        name = _ATTRIBUTE_NAME.match(text, position)
        if name is None or position >= token.end:
            break
        after = _SPACE.match(text, name.end()).end()  # type: ignore[union-attr]
        quote = _SPACE.match(text, after + 1).end() if text.startswith("=", after) else -1  # type: ignore[union-attr]
        if quote < 0 or text[quote : quote + 1] not in ('"', "'"):
            found.append(Written(name[0], name.start(), name.end(), -1, -1))
            break
        end = text.find(text[quote], quote + 1)
        if end < 0:
            found.append(Written(name[0], name.start(), len(text), quote + 1, -1))
            break
        found.append(Written(name[0], name.start(), end + 1, quote + 1, end))
        position = end + 1
    return found

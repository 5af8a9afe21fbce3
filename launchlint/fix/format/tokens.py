"""A lossless reading of XML text: tags, text, comments and all else as they are written.

The text is known to be well-formed (:mod:`launchlint.syntax.parse` asks expat), so that a few patterns are enough. Joined in order, the
tokens are the text again.
"""

from __future__ import annotations

import re

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    Kind = Literal["start", "empty", "end", "text", "comment", "cdata", "instruction", "doctype"]

SPACE = " \t\n"
"""White space of XML, once line ends are LF."""

_TAG_NAME = re.compile(r"[^ \t\n/>]+")
_QUOTED = r"\"[^\"]*\"|'[^']*'"
_COMMENT = r"<!--.*?-->"
_INSTRUCTION = r"<\?.*?\?>"
_DECLARATION = rf"<![A-Z](?:[^\"'>]|{_QUOTED})*>"
_TOKEN = re.compile(
    rf"""
    (?P<text> [^<]+ )
    | (?P<comment> {_COMMENT} )
    | (?P<cdata> <!\[CDATA\[.*?\]\]> )
    | (?P<instruction> {_INSTRUCTION} )
    | (?P<doctype> <!DOCTYPE (?:[^\[\]"'>]|{_QUOTED})*
        (?: \[ (?: {_COMMENT} | {_INSTRUCTION} | {_DECLARATION} | [^\]<] )* \] [ \t\n]* )? > )
    | (?P<end> </[^>]*> )
    | (?P<start> <[^"'>]*(?:(?:{_QUOTED})[^"'>]*)*> )
    """,
    re.DOTALL | re.VERBOSE,
)


class Token(NamedTuple):
    """One piece of the text, as written.

    ``offset``: where it starts. ``name``: of a tag. ``partner``: of a start tag the number of its end tag, of an end tag that of its
    start tag; else -1.
    """

    kind: Kind
    offset: int
    text: str
    name: str = ""
    partner: int = -1


def tokens(text: str) -> list[Token]:
    """The tokens of a well-formed document whose line ends are LF.

    Raises:
        ValueError: the text is not well-formed after all.
    """
    found: list[Token] = []
    opened: list[int] = []
    position = 0
    while position < len(text):
        match = _TOKEN.match(text, position)
        if match is None:
            raise ValueError(f"no token of XML starts at offset {position}")
        kind: Kind = match.lastgroup  # type: ignore[assignment]  # the groups are the kinds
        written = match[0]
        if kind == "start":
            name = _name(written, 1)
            if written.endswith("/>"):
                kind = "empty"
            else:
                opened.append(len(found))
            found.append(Token(kind, position, written, name))
        elif kind == "end":
            if not opened:
                raise ValueError(f"an end tag too many at offset {position}")
            start = opened.pop()
            found[start] = found[start]._replace(partner=len(found))
            found.append(Token(kind, position, written, _name(written, 2), start))
        else:
            found.append(Token(kind, position, written))
        position = match.end()
    if opened:
        raise ValueError("a start tag without an end tag")
    return found


def _name(tag: str, start: int) -> str:
    match = _TAG_NAME.match(tag, start)
    return "" if match is None else match[0]

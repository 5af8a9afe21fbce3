"""The lexemes of remap, parameter and log level rules.

Source: ``rcl/src/rcl/lexer.c``. A token is made of letters, digits and single underscores and begins with no digit; ``x__y`` is two.
What no other lexeme begins with is an ``UNKNOWN``, which no rule may hold.
"""

from __future__ import annotations

import re

(TOKEN, SLASH, TILDE_SLASH, DOT, COLON, SEPARATOR, NODE, NAMESPACE, TOPIC_URL, SERVICE_URL) = (
    *("token", "slash", "tilde-slash", "dot", "colon", "separator"),
    *("node", "namespace", "topic-url", "service-url"),
)
(ONE, MANY, BACK_REFERENCE, UNKNOWN, END) = ("one", "many", "back-reference", "unknown", "end")

_LEXEMES = re.compile(
    rf"(?P<{SLASH}>/)"
    rf"|(?P<{DOT}>\.)"
    rf"|(?P<{SEPARATOR}>:=)"
    rf"|(?P<{COLON}>:)"
    rf"|(?P<{TILDE_SLASH.replace('-', '_')}>~/)"
    rf"|(?P<{NODE}>__(?:node|name))"
    rf"|(?P<{NAMESPACE}>__ns)"
    rf"|(?P<{TOPIC_URL.replace('-', '_')}>rostopic://)"
    rf"|(?P<{SERVICE_URL.replace('-', '_')}>rosservice://)"
    rf"|(?P<{TOKEN}>(?:[A-Za-z]|_(?!_))(?:[A-Za-z0-9]|(?<!_)_)*)"
    rf"|(?P<{MANY}>\*\*)"
    rf"|(?P<{ONE}>\*)"
    rf"|(?P<{BACK_REFERENCE.replace('-', '_')}>\\[1-9])"
    # Whatever else: after a beginning that could have become a lexeme, the first character that does not fit belongs to it.
    rf"|(?P<{UNKNOWN}>__(?:n(?:od?|am?)?)?.?|[\\~].?|.)",
    re.DOTALL,
)


class Lexemes:
    """A text as rcl's parsers walk through it: ``kind`` is that of the lexeme at ``at``."""

    __slots__ = ("_next", "at", "kind", "text")

    def __init__(self, text: str) -> None:
        self.text = text
        self._read(0)

    def _read(self, at: int) -> None:
        self.at = at
        match = _LEXEMES.match(self.text, at)
        self.kind = END if match is None else str(match.lastgroup).replace("_", "-")
        self._next = at if match is None else match.end()

    def following(self) -> str:
        """The kind of the lexeme behind this one."""
        match = _LEXEMES.match(self.text, self._next)
        return END if match is None else str(match.lastgroup).replace("_", "-")

    def take(self) -> str:
        """Go on behind this lexeme; its text."""
        taken = self.text[self.at : self._next]
        self._read(self._next)
        return taken

    def accept(self, *kinds: str) -> bool:
        """Go on if this lexeme is of one of these kinds."""
        if self.kind not in kinds:
            return False
        self.take()
        return True

    def until(self, at: int) -> str:
        """The text from ``at`` to here."""
        return self.text[at : self.at]

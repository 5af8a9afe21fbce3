"""Remap rules: ``[node:]from:=to``, ``[node:]__node:=name`` and ``[node:]__ns:=/namespace``.

Source: ``rcl/src/rcl/arguments.c`` (``_rcl_parse_remap_rule``) and ``remap.c``.
"""

from __future__ import annotations

import re
from functools import lru_cache

from launchlint.named_tuple import NamedTuple
from launchlint.rcl import lexer
from launchlint.rcl.lexer import Lexemes
from launchlint.rcl.refused import Refused
from launchlint.source import Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    Acts = Literal["topic", "service", "both", "node", "namespace"]


class Rule(NamedTuple):
    """One rule: what it ``acts`` on, the node it is for (None: any), and the two sides; ``match`` is empty for ``__node`` and ``__ns``."""

    acts: Acts
    node: str | None
    match: str
    replacement: str


_TOKEN = "(?:[A-Za-z]|_(?!_))(?:[A-Za-z0-9]|(?<!_)_)*"
_NAME = rf"(?:~?/)?{_TOKEN}(?:/{_TOKEN})*"
_PLAIN = re.compile(rf"({_NAME}):=({_NAME})")
"""What nearly all rules look like. They are as the lexemes say, which take far longer to tell."""


@lru_cache(maxsize=4096)  # what is set for all nodes is on each command line
def parse(text: str) -> Rule | Refused:
    """The rule that ``text`` stands for, or why rcl takes none from it."""
    plain = None if "__" in text else _PLAIN.fullmatch(text)
    return _parse(text) if plain is None else Rule("both", None, plain[1], plain[2])


def _parse(text: str) -> Rule | Refused:
    lexemes = Lexemes(text)
    node = None
    if lexemes.kind == lexer.TOKEN and lexemes.following() == lexer.COLON:
        node = lexemes.take()
        lexemes.take()
    if lexemes.accept(lexer.NODE):
        result = _node_name(lexemes, node)
    elif lexemes.accept(lexer.NAMESPACE):
        result = _namespace(lexemes, node)
    else:
        result = _names(lexemes, node)
    if isinstance(result, Rule) and lexemes.kind != lexer.END:
        return _refused(lexemes, "nothing can follow here")
    return result


def _node_name(lexemes: Lexemes, node: str | None) -> Rule | Refused:
    if not lexemes.accept(lexer.SEPARATOR):
        return _refused(lexemes, ":= must follow")
    if lexemes.kind != lexer.TOKEN:
        return _refused(lexemes, "a node name must follow, made of letters, digits and single underscores")
    return Rule("node", node, "", lexemes.take())


def _namespace(lexemes: Lexemes, node: str | None) -> Rule | Refused:
    if not lexemes.accept(lexer.SEPARATOR):
        return _refused(lexemes, ":= must follow")
    start = lexemes.at
    if not lexemes.accept(lexer.SLASH):
        return _refused(lexemes, "the namespace must begin with a slash")
    while lexemes.accept(lexer.TOKEN) and lexemes.accept(lexer.SLASH):
        pass
    return Rule("namespace", node, "", lexemes.until(start))


def _names(lexemes: Lexemes, node: str | None) -> Rule | Refused:
    acts: Acts = "both"
    if lexemes.accept(lexer.SERVICE_URL):
        acts = "service"
    elif lexemes.accept(lexer.TOPIC_URL):
        acts = "topic"
    match = _name(lexemes, lexer.SEPARATOR)
    if isinstance(match, Refused):
        return match
    lexemes.take()
    replacement = _name(lexemes, lexer.END)
    return replacement if isinstance(replacement, Refused) else Rule(acts, node, match, replacement)


def _name(lexemes: Lexemes, end: str) -> str | Refused:
    """A name of tokens with slashes between them, up to ``end``, which is not taken."""
    start = lexemes.at
    lexemes.accept(lexer.TILDE_SLASH, lexer.SLASH)
    while True:
        if not lexemes.accept(lexer.TOKEN):
            return _refused(lexemes, _WHY_NO_TOKEN.get(lexemes.kind) or _no_token(lexemes, start))
        if lexemes.kind == end:
            return lexemes.until(start)
        if not lexemes.accept(lexer.SLASH):
            return _refused(lexemes, _no_slash(lexemes))


_WHY_NO_TOKEN = {
    lexer.ONE: "wildcards are not implemented in remap rules",
    lexer.MANY: "wildcards are not implemented in remap rules",
    lexer.BACK_REFERENCE: "references to a wildcard are not implemented in remap rules",
    lexer.SLASH: "two slashes stand side by side",
}


def _no_token(lexemes: Lexemes, start: int) -> str:
    rest = lexemes.text[lexemes.at :]
    if lexemes.kind in (lexer.SEPARATOR, lexer.END):
        if lexemes.at == start:
            return "the name is empty"
        return "a name cannot end with a slash" if lexemes.text[lexemes.at - 1] == "/" else "a name is missing here"
    if rest[0].isdigit():
        return "no part of a name can begin with a digit"
    if rest[0] == "{":
        return "names in { } are not filled in by remap rules"
    if rest[0] == "~":
        return "~ stands at the beginning of a name only, with a slash behind it"
    if rest[:2] == "__":
        return "a name cannot begin with two underscores"
    return f"a name cannot hold {_shown(rest[0])}"


def _no_slash(lexemes: Lexemes) -> str:
    rest = lexemes.text[lexemes.at :]
    if lexemes.kind == lexer.END:
        return ":= is missing"
    if lexemes.kind == lexer.SEPARATOR:
        return "a second := stands here"
    if lexemes.kind == lexer.TOKEN and lexemes.text[lexemes.at - 1] == "_":
        return "a name cannot hold two underscores side by side"
    if lexemes.kind == lexer.COLON:
        return "a colon can stand behind the name of one node only"
    return f"a name cannot hold {_shown(rest[0])}"


def _shown(character: str) -> str:
    return "a blank" if character == " " else repr(character)


def _refused(lexemes: Lexemes, reason: str) -> Refused:
    return Refused(reason, Span(lexemes.at, min(lexemes.at + 1, len(lexemes.text))))

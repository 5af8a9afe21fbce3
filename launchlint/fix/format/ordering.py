"""Args at the start of their block, where that is proved to change nothing.

roslaunch reads a block from top to bottom: an ``<arg>`` can be used from its declaration on, and a ``<remap>`` acts on the nodes after it
(``roslaunch.xmlloader.XmlLoader._recurse_load``). So a remap stands before the nodes it affects already, and moving it past others
would change these; args that stand further down are the only ones that can go up.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from launchlint.fix.format.line_ends import prevailing_line_end
from launchlint.fix.format.tokens import SPACE, Token, tokens
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.decode import decode

MOST_TRIED = 100
"""Sets of moves that are tried for one file: each costs an evaluation of it in every configuration."""

_BLOCKS = ("launch", "group")
_OTHER = re.compile(r"[ \t]*<(?!arg[ \t\n/>]|[/!?])")
"""A line with an element that is no arg."""


class Move(NamedTuple):
    """The lines from ``start`` to ``end`` go up to ``target``."""

    start: int
    end: int
    target: int


def args_first(data: bytes, refusal: Callable[[bytes, bytes], str], found: Callable[[str], Iterator[Move]] | None = None) -> bytes:
    """A launch file with the args of each block, and the comments that belong to them, before all else in it.

    Args keep their order, so that each still stands behind those it uses. What would change anything in any configuration stays where
    it is: ``refusal`` says why one text must not become another, empty where it may. ``data`` is in normal form; the result may have blank
    lines too many. ``found`` says which args could go up in a text; without it, it is XML.
    """
    decoded = decode(data)
    text = decoded.text
    line_end = prevailing_line_end(text)

    def written(result: str) -> bytes:
        return decoded.bom + result.replace("\n", line_end).encode(decoded.encoding)

    text = text.replace(line_end, "\n")
    moves = _allowed(list((found or _moves)(text)), lambda some: not refusal(data, written(_moved(text, some))))
    return written(_moved(text, moves))


def _allowed(moves: list[Move], proved: Callable[[list[Move]], bool]) -> list[Move]:
    """As many of ``moves`` as can be proved together: all, else those of its halves, and again those that were left, while any is added."""
    accepted: list[Move] = []
    left = MOST_TRIED
    added = True
    while moves and added:
        added = False
        groups, moves = [moves], []
        while groups and left:
            group = groups.pop()
            left -= 1
            if proved([*accepted, *group]):
                accepted += group
                added = True
            elif len(group) > 1:
                half = len(group) // 2
                groups += [group[half:], group[:half]]
            else:
                moves += group
    return accepted


def _moved(text: str, moves: list[Move]) -> str:
    """``text`` after ``moves``; those with one target keep their order."""
    inserted: dict[int, list[str]] = {}
    for move in sorted(moves):
        inserted.setdefault(move.target, []).append(text[move.start : move.end])
    pieces: list[str] = []
    position = 0
    taken = {move.start: move.end for move in moves}
    for place in sorted({*inserted, *taken}):
        pieces.append(text[position:place])
        pieces += inserted.get(place, ())
        position = taken.get(place, place)
    pieces.append(text[position:])
    return "".join(pieces)


def _moves(text: str) -> Iterator[Move]:
    found = tokens(text)
    for number, token in enumerate(found):
        if token.kind == "start" and token.name in _BLOCKS:
            yield from _moves_in_block(text, found, number)


def _moves_in_block(text: str, found: list[Token], number: int) -> Iterator[Move]:
    """The args of one block that do not stand at its start, each with the comments right above it and behind it."""
    target = _line_end(text, found[number].offset + len(found[number].text))
    others = False  # something else than an arg has been seen
    begins: int | None = None  # where the comments begin that belong to what comes next
    moves: list[Move] = []
    position = number + 1
    while position < found[number].partner:
        token = found[position]
        if token.kind == "text":
            if token.text.strip(SPACE):
                return
            begins = None if token.text.count("\n") > 1 else begins
        elif token.kind == "comment":
            if "launchlint" in token.text:  # it may be about its place
                return
            start = _line_start(text, token.offset)
            if not text[start : token.offset].strip(SPACE):
                begins = start if begins is None else begins
        elif token.kind in ("start", "empty"):
            last = token if token.kind == "empty" else found[token.partner]
            end = _line_end(text, last.offset + len(last.text))
            if begins is None or _OTHER.match(text, end):  # comments may be about what follows, too: they stay
                begins = _line_start(text, token.offset)
            if token.name != "arg":
                others = True
            elif others:
                moves.append(Move(begins, end, target))
            else:
                target = end
            begins = None
            position = position if token.kind == "empty" else token.partner
        else:
            return
        position += 1
    yield from moves


def _line_start(text: str, offset: int) -> int:
    return text.rfind("\n", 0, offset) + 1


def _line_end(text: str, offset: int) -> int:
    found = text.find("\n", offset)
    return len(text) if found < 0 else found + 1

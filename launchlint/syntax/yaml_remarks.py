"""Comments of a file in YAML, a launch file or one of params, with what they stand before or behind."""

from __future__ import annotations

import re

from launchlint.named_tuple import NamedTuple
from launchlint.source import Source, Span
from launchlint.syntax.remarks import Remark

_COMMENT = re.compile(r"(?:^|(?<=[ \t]))#([^\r\n]*)", re.MULTILINE)
_ITEM = re.compile(r"[ \t]*-(?=[ \t\r\n]|$)")


class _Block(NamedTuple):
    """What begins in one line, by the numbers of its first and last line."""

    first: int
    last: int


def remarks(source: Source) -> list[Remark]:
    """The comments of a text in YAML.

    One in a line of its own covers what begins in the next line with more than a comment: a key or an item of a list with all that is
    indented deeper. One behind something covers what begins in its line. A ``#`` in a quoted text counts as well: it does no harm.
    """
    text = source.text
    if "#" not in text:
        return []
    starts = source.line_starts
    lines = [text[start:end] for start, end in zip(starts, [*starts[1:], len(text)], strict=True)]
    blocks = _blocks(lines)
    top = _top(lines)
    found: list[Remark] = []
    for match in _COMMENT.finditer(text):
        number = source.position(match.start()).line - 1
        block = blocks[number]
        covers = None
        if block is not None:
            end = starts[block.last] + len(lines[block.last].rstrip("\r\n"))
            covers = Span(starts[block.first] + _indent(lines[block.first]), end)
        found.append(Remark(match[1], Span(*match.span()), Span(*match.span(1)), covers, number < top))
    return found


def _top(lines: list[str]) -> int:
    """Where what stands on top ends: with the first action of a launch file, with the first key of any other."""
    written = (number for number, line in enumerate(lines) if line.strip() and line.lstrip()[0] not in "#%" and line.strip() != "---")
    first = next(written, len(lines))
    if first == len(lines) or not lines[first].startswith(("launch:", '"launch"', "'launch'")):
        return first
    return next((number for number, line in enumerate(lines) if _ITEM.match(line)), len(lines))


def _indent(line: str) -> int:
    return len(line) - len(line.lstrip(" "))


def _level(line: str) -> int:
    """Lower for what is further outside: the items of a list stand inside the key above them, also where they are not indented."""
    return 2 * _indent(line) + (_ITEM.match(line) is not None)


def _blocks(lines: list[str]) -> list[_Block | None]:
    """For each line what begins there; for one without anything, or with a comment only, what begins below."""
    found: list[_Block | None] = [None] * len(lines)
    below: list[tuple[int, int]] = []  # level, and first line, of what is still to come and can end a block
    filled = len(lines)
    next_filled: dict[int, int] = {}
    before: dict[int, int] = {}
    for number in range(len(lines) - 1, -1, -1):
        written = lines[number].strip()
        if not written or written.startswith("#"):
            found[number] = found[filled] if filled < len(lines) else None
            continue
        if filled < len(lines):
            before[filled] = number
        next_filled[number] = filled
        filled = number
        level = _level(lines[number])
        while below and below[-1][0] > level:
            below.pop()
        found[number] = _Block(number, below[-1][1] if below else len(lines))
        below.append((level, number))
    last = max(next_filled, default=0)
    ended = {number: block._replace(last=before.get(block.last, last)) for number, block in enumerate(found) if block is not None}
    return [None if block is None else ended[block.first] for block in found]

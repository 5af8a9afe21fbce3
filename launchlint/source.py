"""Text with places: what was read, and where in it something stands.

Offsets are counted in Unicode code points of the decoded text, from 0. Lines and
columns, as people and editors see them, are counted from 1; a tab is one column.
"""

from __future__ import annotations

import re
from bisect import bisect_right

from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_LINE_END = re.compile(r"\r\n|\n|\r")


class Span(NamedTuple):
    """A stretch of a text: ``start`` inclusive, ``end`` exclusive, in code points."""

    start: int
    end: int


class Position(NamedTuple):
    """A place as editors show it: both numbers from 1."""

    line: int
    column: int


class Source:
    """One text file as it was read.

    ``path`` is what people see (relative, with ``/``); ``file`` is the name under which
    the file was opened, as roslaunch would spell it; ``text`` is the decoded content with its line
    ends as they are on disk (a byte order mark is not part of it). ``resolved`` are the spans of which findings speak, as
    :class:`launchlint.finding.Location` has them.
    """

    __slots__ = ("_addresses", "_line_starts", "file", "path", "resolved", "text")

    def __init__(self, path: str, text: str, file: str | None = None) -> None:
        self.path = path
        self.text = text
        self.file = path if file is None else file
        self._line_starts: list[int] | None = None
        self._addresses: dict[int, str] = {}
        self.resolved: dict[Span, Any] = {}

    def __repr__(self) -> str:
        return f"Source({self.path!r})"

    @property
    def line_starts(self) -> list[int]:
        """Offset of the first character of every line; line ends are LF, CRLF and CR, as in XML."""
        if self._line_starts is None:
            self._line_starts = [0, *(match.end() for match in _LINE_END.finditer(self.text))]
        return self._line_starts

    def position(self, offset: int) -> Position:
        """Line and column of ``offset`` (which may be the end of the text)."""
        starts = self.line_starts
        line = bisect_right(starts, offset)
        return Position(line, offset - starts[line - 1] + 1)

    def address(self, offset: int) -> str:
        """``path:line:column`` of ``offset``, written once: a graph names few places, and these often."""
        known = self._addresses.get(offset)
        if known is None:
            line, column = self.position(offset)
            known = self._addresses[offset] = f"{self.path}:{line}:{column}"
        return known

    def offset(self, number: int, column: int) -> int:
        """The offset of a column of line ``number``, counted from 0 in bytes of UTF-8, as Python's syntax trees do; the end of the text
        where there is no such line.
        """
        starts = self.line_starts
        if not 1 <= number <= len(starts):
            return len(self.text)
        found = starts[number - 1] + column
        if self.text.isascii() and found < (starts[number] if number < len(starts) else len(self.text)) - 1:
            return found  # clear of the line end, and each character is one byte
        return starts[number - 1] + len(self.line(number).encode("utf-8", "replace")[:column].decode("utf-8", "ignore"))

    def line(self, number: int, longest: int | None = None) -> str:
        """Text of line ``number`` (from 1) without its line end, at most ``longest`` characters of it; empty where there is none."""
        starts = self.line_starts
        if not 1 <= number <= len(starts):
            return ""
        end = starts[number] if number < len(starts) else len(self.text)
        if longest is not None:
            end = min(end, starts[number - 1] + longest)
        return self.text[starts[number - 1] : end].rstrip("\r\n")

    def with_lines(self, span: Span) -> Span:
        """``span``; where it has its lines for itself, these whole, with their indentation and line end."""
        start, end = span
        line_start = self.line_starts[self.position(start).line - 1]
        line = self.position(end).line
        line_end = self.line_starts[line] if line < len(self.line_starts) else len(self.text)
        alone = not self.text[line_start:start].strip() and not self.text[end:line_end].strip()
        return Span(line_start, line_end) if alone else span


class Place(NamedTuple):
    """A span of a source: where something is written."""

    source: Source
    span: Span

    @property
    def key(self) -> tuple[str, int]:
        """Path and offset: the same for what is written at the same place of a file that was read twice."""
        return self.source.path, self.span.start

    @property
    def text(self) -> str:
        """What is written there."""
        return self.source.text[self.span.start : self.span.end]


class IncludeStep(NamedTuple):
    """One ``<include>`` on the way from the entry file to a place; ``parent`` is the step before it."""

    place: Place
    parent: IncludeStep | None

    def outermost_first(self) -> tuple[Place, ...]:
        """The include elements from the entry file down to this one."""
        steps: list[Place] = []
        step: IncludeStep | None = self
        while step is not None:
            steps.append(step.place)
            step = step.parent
        return tuple(reversed(steps))


class Origin(NamedTuple):
    """Where something comes from: the place it is written at, and the includes that led there."""

    place: Place
    step: IncludeStep | None = None

    @property
    def chain(self) -> tuple[Place, ...]:
        """The include elements that led to the place, outermost first; empty in the entry file itself."""
        return () if self.step is None else self.step.outermost_first()

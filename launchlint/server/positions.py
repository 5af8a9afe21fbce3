"""Between offsets of a text (code points) and positions of the protocol: lines, and bytes, UTF-16 units or code points in them, from 0."""

from __future__ import annotations

from bisect import bisect_right

from lsprotocol import types

from launchlint.source import Source, Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    Unit = Literal["utf-8", "utf-16", "utf-32"]


class Lines:
    """A text, and the unit in which its client counts."""

    def __init__(self, text: str, unit: Unit) -> None:
        self.text = text
        self._unit = unit
        self._starts = Source("", text).line_starts

    def position(self, offset: int) -> types.Position:
        """Where an offset is; one outside of the text is at its end."""
        offset = min(max(offset, 0), len(self.text))
        line = bisect_right(self._starts, offset) - 1
        return types.Position(line, self._units(self.text[self._starts[line] : offset]))

    def range(self, span: Span) -> types.Range:
        """Where a stretch is."""
        return types.Range(self.position(span.start), self.position(max(span.end, span.start)))

    def offset(self, position: types.Position) -> int:
        """The offset of a position; one behind the end of a line is at its end."""
        if position.line >= len(self._starts):
            return len(self.text)
        start = self._starts[max(position.line, 0)]
        line = self._line(max(position.line, 0))
        if line.isascii() or self._unit == "utf-32":
            return start + min(position.character, len(line))
        units = 0
        for number, letter in enumerate(line):
            if units >= position.character:
                return start + number
            units += self._units(letter)
        return start + len(line)

    def span(self, range_: types.Range) -> Span:
        """The stretch of a range."""
        return Span(self.offset(range_.start), self.offset(range_.end))

    def _line(self, number: int) -> str:
        end = self._starts[number + 1] if number + 1 < len(self._starts) else len(self.text)
        return self.text[self._starts[number] : end].rstrip("\r\n")

    def _units(self, text: str) -> int:
        if text.isascii() or self._unit == "utf-32":
            return len(text)
        if self._unit == "utf-8":
            return len(text.encode("utf-8", "surrogatepass"))
        return len(text.encode("utf-16-le", "surrogatepass")) // 2

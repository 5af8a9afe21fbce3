"""Where the lines of a YAML text begin in normal form.

A mapping stands one level deeper than its key, a list in the column of its key, and what follows a dash two columns behind it. Lines that a
value goes on in move with the line that it begins in, so that what they hold stays the same.
"""

from __future__ import annotations

import re

from launchlint.named_tuple import NamedTuple
from launchlint.source import Source
from launchlint.yaml.tree import MAPPING, SCALAR, SEQUENCE, Node

_DASH = "-"
_PROPERTIES = re.compile(r"(?:[&!]\S*[ \t]+)*")


class Unusual(Exception):
    """A form of YAML that people hardly write: its lines stay where they are."""


class Line(NamedTuple):
    """How a line is written: ``indent`` before it, ``gap`` in place of the blanks behind its dash (-1: as they are).

    ``inner``: it belongs to a value that began above, and nothing of it but its place may change.
    """

    indent: int
    gap: int = -1
    inner: bool = False


class Layout:
    """Fills :attr:`lines`, by number from 0, with the lines of a tree that begin something or go on with a value."""

    def __init__(self, source: Source, step: int) -> None:
        self.lines: dict[int, Line] = {}
        self._source = source
        self._text = source.text
        self._step = step

    def _line(self, offset: int) -> int:
        return self._source.position(offset).line - 1

    def _column(self, offset: int) -> int:
        return self._source.position(offset).column - 1

    def _is_first(self, offset: int) -> bool:
        start = self._source.line_starts[self._line(offset)]
        return not self._text[start:offset].strip(" ")

    def _is_block(self, node: Node) -> bool:
        properties = _PROPERTIES.match(self._text, node.start)
        at = node.start if properties is None else properties.end()
        return node.kind != SCALAR and self._text[at : at + 1] not in ("{", "[")

    def place(self, node: Node, column: int) -> None:
        """Put a node whose first line begins at ``column``.

        Raises:
            Unusual: its form is not known here.
        """
        if not self._is_block(node):
            self._go_on(self._line(node.start) + 1, node, column - self._column(node.start))
        elif node.kind == MAPPING:
            self._mapping(node, column)
        elif node.kind == SEQUENCE:
            self._sequence(node, column)

    def _mapping(self, node: Node, column: int) -> None:
        moved = column - self._column(node.start)
        for key, value in node.value:
            if key.kind != SCALAR or self._column(key.start) != self._column(node.start):
                raise Unusual  # a key with a question mark, or an anchor before the first one
            if self._line(key.start) != self._line(key.end):
                raise Unusual
            if self._is_first(key.start):
                self.lines[self._line(key.start)] = Line(column)
            elif key is not node.value[0][0]:
                raise Unusual
            if value.start < key.end:
                continue  # an alias: what it stands for begins above
            if not self._is_block(value):
                self._go_on(self._line(key.start) + 1, value, moved)
            elif self._line(value.start) == self._line(key.start):
                raise Unusual
            else:
                self.place(value, column if value.kind == SEQUENCE else column + self._step)

    def _sequence(self, node: Node, column: int) -> None:
        for item in node.value:
            dash = self._text.rfind(_DASH, node.start, item.start)
            between = self._text[dash + 1 : item.start]
            if dash < 0 or item.start == item.end or between.strip(" ") or not self._is_first(dash):
                raise Unusual
            self.lines[self._line(dash)] = Line(column, gap=1)
            self.place(item, column + len("- "))

    def _go_on(self, first: int, node: Node, moved: int) -> None:
        """The lines from ``first`` on in which a value goes on, or begins."""
        starts = self._source.line_starts
        for number in range(first, self._line(max(node.end - 1, node.start)) + 1):
            text = self._source.line(number + 1)
            if text.strip(" "):
                indent = len(text) - len(text.lstrip(" ")) + moved
                if indent < 0:
                    raise Unusual
                begins = starts[number] + len(text) - len(text.lstrip(" ")) == node.start
                self.lines[number] = Line(indent, inner=not begins)
            else:
                self.lines[number] = Line(len(text), inner=True)

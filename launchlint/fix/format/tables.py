"""Attributes that people put into columns, line below line, stay in columns."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from launchlint.fix.format.start_tag import Attribute, attributes_of, in_canonical_order
from launchlint.fix.format.style import Style
from launchlint.fix.format.tokens import SPACE, Token
from launchlint.named_tuple import NamedTuple

_PADDED = re.compile(r"""["'][ \t]{2,}[^ \t\n/>]""")


class _Row(NamedTuple):
    """An empty element in a line of its own: the number of its token, how deep it stands, and its attributes."""

    number: int
    depth: int
    tag: str
    attributes: Sequence[Attribute]


def in_columns(text: str, found: Sequence[Token], style: Style) -> dict[int, str]:
    """The start tags that belong to a table, by the number of their token, as they are written in normal form.

    A table is at least two empty elements of one name in lines that follow each other, whose attributes have the same names and begin at
    the same distance from the start of the tag. Those that do not fit into a line, or whose attributes change places, belong to none.
    """
    result: dict[int, str] = {}
    if _PADDED.search(text) is not None:
        for rows in _tables(found, style):
            result.update(_written(rows, style))
    return result


def _tables(found: Sequence[Token], style: Style) -> Iterator[list[_Row]]:
    rows: list[_Row] = []
    depth = line_feeds = 0
    for number, token in enumerate(found):
        if token.kind == "text" and not token.text.strip(SPACE):
            line_feeds += token.text.count("\n")
            continue
        if token.kind == "comment" and line_feeds == 0 and "\n" not in token.text:
            continue  # behind a row
        row = _row(number, depth, token, style) if token.kind == "empty" else None
        if row is None or line_feeds != 1 or (rows and not _below(rows[-1], row)):
            yield rows
            rows = []
        if row is not None:
            rows.append(row)
        line_feeds = 0
        depth += {"start": 1, "end": -1}.get(token.kind, 0)
    yield rows


def _below(above: _Row, row: _Row) -> bool:
    """Whether the attributes of a row stand right below those of the one above it, as far as both have any."""
    pairs = zip(above.attributes, row.attributes, strict=False)
    return above.tag == row.tag and all((one.name, one.distance) == (other.name, other.distance) for one, other in pairs)


def _row(number: int, depth: int, token: Token, style: Style) -> _Row | None:
    attributes = attributes_of(token)
    width = depth * style.indent + len(f"<{token.name}/>") + sum(1 + len(each.written) for each in attributes)
    if (
        "\n" in token.text
        or width > style.line_width
        or (style.sort_attributes and in_canonical_order(token.name, attributes) != attributes)
    ):
        return None
    return _Row(number, depth, token.name, attributes)


def _written(rows: list[_Row], style: Style) -> dict[int, str]:
    """The rows in columns that are as narrow as they can be; none where that is too wide for a line."""
    if len(rows) < 2:
        return {}
    lines = [f"<{row.tag}" for row in rows]
    for index in range(max(len(row.attributes) for row in rows)):
        # A column goes on as long as each row has it: where one lacks it, a new one begins below.
        has = [index < len(row.attributes) for row in rows]
        for filled, column in groupby(range(len(rows)), has.__getitem__):
            if filled:
                numbers = list(column)
                width = max(len(lines[number]) for number in numbers) + 1
                for number in numbers:
                    lines[number] = lines[number].ljust(width) + rows[number].attributes[index].written
    if rows[0].depth * style.indent + max(map(len, lines)) + len("/>") > style.line_width:
        return {}
    return {row.number: f"{line}/>" for row, line in zip(rows, lines, strict=True)}

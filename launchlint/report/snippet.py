"""A source line with carets below it, as it looks in a terminal."""

from __future__ import annotations

from launchlint.finding import Location
from launchlint.named_tuple import NamedTuple
from launchlint.report.escape import visible

_TAB = 4
_NARROWEST = 40
_CUT = "…"


class Snippet(NamedTuple):
    """A shown line and the line below it: ``carets`` start at column ``indent`` (from 0) of ``line``."""

    line: str
    indent: int
    carets: int


def snippet(location: Location, width: int) -> Snippet | None:
    """The line of ``location``, or ``None`` where there is nothing to show.

    It is escaped, its tabs are expanded, and it is cut around the carets to ``width`` columns. A span that goes on in the next line is
    underlined to the end of this one; an empty span gets one caret.
    """
    text = location.text
    if not text.strip():
        return None
    width = max(width, _NARROWEST)
    start = min(location.column - 1, len(text))
    end = len(text) if location.end_line > location.line else min(max(location.end_column - 1, start + 1), len(text))
    # Only this much of a line that may be megabytes long can be shown at all.
    first, last = max(0, start - width), min(end, start + width)
    before = _cells(text, first, start, 0)
    indent = sum(columns for _, columns in before)
    under = _cells(text, start, last, indent)
    carets = max(sum(columns for _, columns in under), 1)
    tail = _cells(text, last, last + width, indent + carets) if last == end else []
    total = indent + carets + sum(columns for _, columns in tail)
    complete = first == 0 and last + len(tail) == len(text)
    if complete and total <= width:
        return Snippet("".join(shown for shown, _ in before + under + tail).rstrip(), indent, carets)
    return _cut(before, under, tail, width, first > 0, last + len(tail) < len(text))


def _cut(
    before: list[tuple[str, int]], under: list[tuple[str, int]], tail: list[tuple[str, int]], width: int, more_left: bool, more_right: bool
) -> Snippet:
    carets = sum(columns for _, columns in under)
    left = max(width // 3, width - 2 - carets - sum(columns for _, columns in tail))
    kept: list[tuple[str, int]] = []
    indent = 0
    for cell in reversed(before):
        if indent + cell[1] > left:
            more_left = True
            break
        kept.append(cell)
        indent += cell[1]
    kept.reverse()
    line, used = "".join(shown for shown, _ in kept), indent
    if more_left:
        line, indent, used = _CUT + line, indent + 1, used + 1
    shown_carets = 0
    for number, (shown, columns) in enumerate(under + tail):
        if used + columns > width - 1:
            more_right = True
            break
        line += shown
        used += columns
        if number < len(under):
            shown_carets += columns
    return Snippet(line.rstrip() + (_CUT if more_right else ""), indent, max(shown_carets, 1))


def _cells(text: str, start: int, end: int, used: int) -> list[tuple[str, int]]:
    """Each character of ``text[start:end]`` as shown, with its columns; the first stands in column ``used`` (tab stops need it)."""
    cells: list[tuple[str, int]] = []
    for index in range(start, min(end, len(text))):
        character = text[index]
        if character == "\t":
            shown = " " * (_TAB - used % _TAB)
            columns = len(shown)
        elif character == "[" and text[index - 2 : index] == "##":
            shown, columns = "\\x5b", 4  # a command for GitHub, see visible()
        else:
            shown = visible(character)
            columns = _columns(character) if shown == character else len(shown)
        cells.append((shown, columns))
        used += columns
    return cells


def _columns(character: str) -> int:
    if character.isascii():
        return 1
    from unicodedata import category, east_asian_width  # of no use to a line in ASCII

    if east_asian_width(character) in "WF":
        return 2
    return 0 if category(character) in ("Mn", "Me") else 1

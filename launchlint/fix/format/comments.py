"""Comments of several lines: moved as a whole, so that their inner layout stays."""

from __future__ import annotations

from launchlint.fix.format.tokens import SPACE


def moved(text: str, by: int, tab: int) -> str:
    """``text`` with all lines but the first moved ``by`` columns, or as far to the left as they can go together.

    Tabs before a line count as ``tab`` blanks and become blanks; blanks after a line are left out.
    """
    first, *others = text.split("\n")
    if not others:
        return text
    parts = [_split(line, tab) for line in others]
    room = min((width for width, rest in parts if rest), default=0)
    by = max(by, -room)
    return "\n".join([first.rstrip(SPACE), *(" " * (width + by) + rest if rest else "" for width, rest in parts)])


def width_of(blanks: str, tab: int) -> int:
    """Columns that blanks and tabs at the start of a line take."""
    return len(blanks.expandtabs(tab))


def _split(line: str, tab: int) -> tuple[int, str]:
    """How far a line is indented, and the rest of it."""
    rest = line.lstrip(SPACE)
    return width_of(line[: len(line) - len(rest)], tab), rest.rstrip(SPACE)

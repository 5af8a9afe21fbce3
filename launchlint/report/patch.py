"""What an edit changes, as a unified diff for people."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.report.escape import visible

_RESET = "\x1b[0m"
_HEAD = "\x1b[1m"
_COLORS = {"@": "\x1b[36m", "-": "\x1b[31m", "+": "\x1b[32m"}
_NO_LINE_END = "\\ No newline at end of file"


def unified(path: str, before: str, after: str, *, color: bool) -> str:
    """The differences between two texts of the file ``path``; the empty string where there are none.

    Characters that could play tricks on a terminal, and the CR of line ends, are shown as escapes; tabs stay.
    """
    from difflib import unified_diff

    lines = unified_diff(_lines(before), _lines(after), f"a/{path}", f"b/{path}")
    return "".join(f"{_painted(line, head=number < 2) if color else line}\n" for number, each in enumerate(lines) for line in _shown(each))


def _lines(text: str) -> list[str]:
    """The lines with their LF, which the last one may lack (``str.splitlines`` would end lines at other characters too)."""
    lines = [f"{line}\n" for line in text.split("\n")]
    lines[-1] = lines[-1][:-1]
    return lines if lines[-1] else lines[:-1]


def _shown(line: str) -> Iterator[str]:
    yield "\t".join(visible(part) for part in line.removesuffix("\n").split("\t"))
    if not line.endswith("\n"):
        yield _NO_LINE_END


def _painted(line: str, *, head: bool) -> str:
    style = _HEAD if head else _COLORS.get(line[:1])
    return line if style is None else f"{style}{line}{_RESET}"

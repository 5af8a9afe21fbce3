"""The files that the page refers to, and the lines of them that it shows."""

from __future__ import annotations

from collections.abc import Callable

from launchlint.report.html.plain import Plain
from launchlint.source import Source

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

AROUND = 2
"""Lines shown before and after those of a finding."""

Place = list[int]
"""Index of the file, line and column from 1."""


class Places:
    """Gives files their numbers, and notes which lines of them are needed.

    ``source`` and ``base_source`` give the text of a file, by its shown path, as it is now and as it was at the revision compared with.
    """

    def __init__(self, plain: Plain, source: Callable[[str], Source | None], base_source: Callable[[str], Source | None]) -> None:
        self._plain = plain
        self._read = (source, base_source)
        self._numbers: dict[tuple[str, bool], int] = {}
        self._lines: dict[int, set[int]] = {}

    def file(self, path: str, *, base: bool = False) -> int:
        """The number of a file."""
        return self._numbers.setdefault((path, base), len(self._numbers))

    def at(self, path: str, line: int, column: int, *, last_line: int = 0, around: int = 0, base: bool = False) -> Place:
        """A place, whose line is shown; with ``last_line`` and ``around`` more lines are."""
        file = self.file(path, base=base)
        last = min(max(line, last_line), line + 3 * AROUND)
        self._lines.setdefault(file, set()).update(range(max(1, line - around), last + around + 1))
        return [file, line, column]

    def of(self, text: str, *, base: bool = False) -> Place | None:
        """The place that a topology spells ``path:line:column``; None for the empty one."""
        if not text:
            return None
        path, line, column = text.rsplit(":", 2)
        return self.at(path, int(line), int(column), base=base)

    def files(self) -> list[str]:
        """The paths, by number."""
        return [self._plain.path(path) for path, _ in self._numbers]

    def base_files(self) -> list[int]:
        """The numbers of the files that are meant as they were at the revision."""
        return [number for (_, base), number in self._numbers.items() if base]

    def lines(self) -> list[dict[str, Any]]:
        """The text of all lines that were asked for; files that cannot be read have none."""
        found: list[dict[str, Any]] = []
        for (path, base), number in self._numbers.items():
            source = self._read[base](path) if self._lines.get(number) else None
            if source is not None:
                last = len(source.line_starts)
                shown = [[line, Plain.line(source.line(line, 2 * 400))] for line in sorted(self._lines[number]) if line <= last]
                found.append({"file": number, "lines": shown})
        return found

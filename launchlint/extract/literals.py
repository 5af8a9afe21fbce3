"""The texts in source files that may be names on the graph, or ends of them."""

from __future__ import annotations

import re
from collections.abc import Iterable

from launchlint.workspace.looking import read_bytes

SOURCE_ENDS = frozenset({".py", ".cpp", ".cc", ".cxx", ".c++", ".C", ".c", ".cu", ".h", ".hpp", ".hh", ".hxx", ".inl", ".ipp", ".tpp", ""})
"""How the names of source files end; a script may end in nothing at all."""
MOST = 2_000
"""Texts of one program; with more of them nothing is said."""
_MOST_FILES = 600
_MOST_KEPT = 4_000

_TEXT = re.compile(rb"""(["'])([~/]?[A-Za-z][A-Za-z0-9_/]{1,99})\1""")
"""A whole string; what stands between two of them is no name, since it has blanks or commas."""


class Literals:
    """The texts in source files, each of which is looked through once for all the programs that read it."""

    def __init__(self) -> None:
        self._known: dict[tuple[int, int], frozenset[bytes]] = {}

    def among(self, paths: Iterable[str]) -> list[str]:
        """The texts in the files at ``paths`` that could be names, sorted; none where there are too many. Unreadable files are left out."""
        found: set[bytes] = set()
        for path in sorted(paths)[:_MOST_FILES]:
            try:
                found |= self._of(read_bytes(path))
            except OSError:
                continue
            if len(found) > MOST:
                return []
        return sorted(text.decode("ascii") for text in found)

    def _of(self, data: bytes) -> frozenset[bytes]:
        key = (len(data), hash(data))
        known = self._known.get(key)
        if known is None:
            if len(self._known) >= _MOST_KEPT:
                self._known.clear()
            known = self._known[key] = frozenset(match[1] for match in _TEXT.findall(data))
        return known

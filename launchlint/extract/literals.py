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

_TEXT = re.compile(rb"""(["'])([~/]?[A-Za-z][A-Za-z0-9_/]{1,99})\1""")
"""A whole string; what stands between two of them is no name, since it has blanks or commas."""


def literals(paths: Iterable[str]) -> list[str]:
    """The texts in the files at ``paths`` that could be names, sorted; none where there are too many. Unreadable files are left out."""
    found: set[bytes] = set()
    for path in sorted(paths)[:_MOST_FILES]:
        try:
            data = read_bytes(path)
        except OSError:
            continue
        found.update(match[1] for match in _TEXT.findall(data))
        if len(found) > MOST:
            return []
    return sorted(text.decode("ascii") for text in found)

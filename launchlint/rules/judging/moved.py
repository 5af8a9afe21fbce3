"""Files that are looked for in one directory and lie in another one: it is the directory that is wrong, and that is told once."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from launchlint.finding import Finding

_MOVED = "moved "
_MOST_NAMED = 3


def moved(path: str, meant: str) -> str:
    """The cause of all that is looked for where ``path`` should be and lies elsewhere, as ``meant`` does; else empty."""
    directory, name = posixpath.split(posixpath.normpath(path))
    right, other = posixpath.split(meant)
    return f"{_MOVED}{directory}" if name == other and right else ""


def told_as_moved(told: Finding, files: Sequence[str], what: str) -> Finding:
    """``told``, which speaks for all findings of one cause, with the ``files`` that these are about; ``what`` they are, in words."""
    names = list(dict.fromkeys(files))
    if not told.cause.startswith(_MOVED) or len(names) < 2:
        return told
    more = f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
    return told._replace(
        message=f"{len(names)} {what} do not exist: {', '.join(names[:_MOST_NAMED])}{more}",
        help=f"{told.help.removesuffix('?')}, and so for the others?" if told.help.endswith("?") else told.help,
    )

"""Path patterns of the configuration (``exclude``, ``per-file-ignores``), after the manner of .gitignore.

``*`` and ``?`` stop at ``/``, ``**`` does not. A pattern without ``/`` names a file or directory at any depth; one with ``/`` is held
against the path from the configuration file's directory on. A directory stands for all that is in it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache


def matches(pattern: str, path: str) -> bool:
    """Whether ``path`` (relative to the configuration file's directory, with ``/``) is the pattern's, or lies in a directory that is."""
    return _compiled(pattern).fullmatch(path) is not None


def matches_any(patterns: Iterable[str], path: str) -> bool:
    """Whether one of ``patterns`` matches."""
    return any(matches(pattern, path) for pattern in patterns)


@lru_cache(maxsize=256)
def _compiled(pattern: str) -> re.Pattern[str]:
    text = pattern.removeprefix("./").rstrip("/")
    anchored = "/" in text
    text = re.sub(r"/{2,}", "/", text.lstrip("/"))
    parts: list[str] = []
    for piece in re.findall(r"/\*\*/|\*\*/|/\*\*$|\*+|\?|\[!?\]?[^\]/]{0,200}\]|[^*?\[/]+|.", text, re.DOTALL):
        if piece in ("**/", "/**/"):
            parts.append(piece[: -len("**/")] + "(?:[^/]+/)*")
        elif piece == "/**":
            parts.append("/.*")
        elif piece.startswith("*"):
            # Equal neighbours would only make matching slow.
            if not parts or parts[-1] != "[^/]*":
                parts.append("[^/]*")
        elif piece == "?":
            parts.append("[^/]")
        elif len(piece) > 2 and piece.startswith("["):
            inner = piece[1:-1]
            negated = inner.startswith("!")
            inner = re.sub(r"([\\\[\]^&~|])", r"\\\1", inner.removeprefix("!"))
            parts.append(f"[{'^/' if negated else ''}{inner}]")
        else:
            parts.append(re.escape(piece))
    body = "".join(parts)
    try:
        return re.compile(("" if anchored else "(?:.*/)?") + f"(?:{body})(?:/.*)?", re.DOTALL)
    except re.error:
        return re.compile(re.escape(text))

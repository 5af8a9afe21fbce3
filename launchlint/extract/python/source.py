"""A Python file as a syntax tree that is safe to walk through."""

from __future__ import annotations

import ast
import codecs
import re
import warnings

from launchlint.extract.python.python2 import rewritten
from launchlint.workspace.looking import read_bytes

LARGEST_FILE = 1 << 20
"""In bytes."""
DEEPEST_TREE = 120
"""Levels of a syntax tree."""

_CODING = re.compile(rb"^[ \t\f]*#.*?coding[:=][ \t]*([-\w.]+)")


class SourceError(ValueError):
    """A file that cannot be followed; ``str(error)`` says why, as the end of a sentence that begins with its name."""


def parse(path: str) -> ast.Module:
    """The syntax tree of the file at ``path``, which may be Python 3 or Python 2.

    Raises:
        SourceError: it cannot be read, is too large, or is no Python.
    """
    try:
        data = read_bytes(path, LARGEST_FILE)
    except OSError as error:
        raise SourceError(f"cannot be read: {error.strerror or error}") from None
    return parse_text(_decoded(data))


def parse_text(text: str) -> ast.Module:
    """The syntax tree of Python source. Raises :class:`SourceError`."""
    try:
        tree = _tree(text)
    except SyntaxError as error:
        try:
            tree = _tree(rewritten(text))
        except (SyntaxError, ValueError):
            raise SourceError(f"is not Python: line {error.lineno or 0}: {error.msg}") from None
    level: list[ast.AST] = [tree]
    for _ in range(DEEPEST_TREE):
        level = [child for node in level for child in ast.iter_child_nodes(node)]
        if not level:
            return tree
    raise SourceError("is nested too deep")


def _tree(text: str) -> ast.Module:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # invalid escapes are common in old sources
            return ast.parse(text)
    except (RecursionError, MemoryError):
        raise SourceError("is nested too deep") from None
    except SyntaxError:
        raise
    except ValueError as error:  # null bytes, numbers with too many digits
        raise SourceError(f"is not Python: {error}") from None


def _decoded(data: bytes) -> str:
    for line in data.split(b"\n", 2)[:2]:
        match = _CODING.match(line)
        if match is not None:
            try:
                codec = codecs.lookup(match[1].decode("ascii", "replace"))
                if codec.name not in ("utf-8", "ascii", "iso8859-1", "iso8859-15", "cp1252", "euc_jp", "shift_jis", "gbk", "gb2312"):
                    break
                return _uncoded(data.decode(codec.name, "replace"))
            except LookupError:
                break
    return _uncoded(data.decode("utf-8-sig", "replace"))


def _uncoded(text: str) -> str:
    """Without a byte order mark."""
    return text.removeprefix("\ufeff")

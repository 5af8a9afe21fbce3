"""Places in files that no launch file is read from: a script, a ``package.xml``."""

from __future__ import annotations

import posixpath

from launchlint.source import Place, Source, Span
from launchlint.workspace.looking import read_bytes


def root_of(source: Source) -> str:
    """The directory that the shown paths of a run are relative to, from a launch file of it; empty where that cannot be told."""
    absolute, path = posixpath.abspath(source.file), source.path
    if posixpath.isabs(path) or not absolute.endswith("/" + path):
        return ""
    return absolute[: -len(path)].rstrip("/") or "/"


def shown(file: str, root: str) -> str:
    """The path people see for ``file``: relative to ``root`` where it lies inside, with ``/``."""
    absolute = posixpath.abspath(file)
    inside = root.rstrip("/") + "/"
    return absolute[len(inside) :] if root and absolute.startswith(inside) else absolute


def is_inside(file: str, directories: tuple[str, ...]) -> bool:
    """Whether ``file`` lies below one of ``directories`` (absolute)."""
    absolute = posixpath.abspath(file)
    return any(absolute.startswith(each.rstrip("/") + "/") for each in directories)


def line_of(file: str, root: str, line: int = 1) -> Place:
    """The text of line ``line`` of ``file`` as a place; the start of the file where it cannot be read or has no such line."""
    try:
        text = read_bytes(file).decode("utf-8", "replace").removeprefix("\ufeff")
    except OSError:
        text = ""
    source = Source(shown(file, root), text, file)
    written = source.line(line)
    start = source.line_starts[line - 1] + len(written) - len(written.lstrip()) if written.strip() else 0
    return Place(source, Span(start, start + len(written.strip())))

"""Leaving out what only looks like a launch file, and what nobody here reads.

That are files of other programs with the same ending (Eclipse has ``.launch`` files, too), even where they hold a ``<launch>`` somewhere;
and launch files in Python, which would have to be run.
"""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence
from typing import NamedTuple

from launchlint.check.options import EntryRequest
from launchlint.evaluate.session import Session
from launchlint.workspace.discovery import PYTHON_END, holds_python, is_in_python


class SortedOut(NamedTuple):
    """Requests for launch files, and the paths of others: ``python`` launch files, ``other`` files with the name of their root."""

    kept: list[EntryRequest]
    python: tuple[str, ...]
    other: tuple[tuple[str, str], ...]


def sort_out(requests: Sequence[EntryRequest], named: Collection[str], session: Session) -> SortedOut:
    """Tell launch files that can be read from others. Files in ``named`` (absolute) were asked for by name, and stay whatever they hold."""
    from launchlint.workspace.launch_root import other_root

    kept: list[EntryRequest] = []
    python: dict[str, None] = {}
    other: dict[str, str] = {}
    for request in requests:
        if is_in_python(request.at) and os.path.abspath(request.at) not in named and _describes_nothing(request.at, session):
            continue
        if is_in_python(request.at) and session.in_python(request.at) is None:
            python[session.shown(request.at)] = None
            continue
        data = None if is_in_python(request.at) else session.read(request.file).data
        if data is not None and holds_python(request.at, data):
            if session.in_python(request.at) is not None:
                kept.append(request)
                continue
            python[session.shown(request.at)] = None
            continue
        root = None if data is None or os.path.abspath(request.at) in named else other_root(data)
        if root is not None:
            other[session.shown(request.at)] = root
        else:
            kept.append(request)
    return SortedOut(kept, tuple(python), tuple(other.items()))


def _describes_nothing(path: str, session: Session) -> bool:
    """Whether a file in Python has the name of a launch file, and is a test for launch_testing, or a module that others import."""
    data = session.read(path).data
    if data is None or b"generate_launch_description" in data:
        return False
    return b"generate_test_description" in data or not path.endswith(PYTHON_END)

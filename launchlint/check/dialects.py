"""Leaving out what only looks like a launch file: files of other programs with the same ending (Eclipse has ``.launch`` files, too)."""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence

from launchlint.check.options import EntryRequest
from launchlint.evaluate.session import Session
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.discovery import PYTHON_END, is_program


class SortedOut(NamedTuple):
    """Requests for launch files, and the paths of others, each with the name of its root; empty where that is ``launch``."""

    kept: list[EntryRequest]
    other: tuple[tuple[str, str], ...]


def sort_out(requests: Sequence[EntryRequest], named: Collection[str], session: Session) -> SortedOut:
    """Tell launch files from others. Files in ``named`` (absolute) were asked for by name, and stay whatever they hold."""
    from launchlint.workspace.launch_root import names_no_program, other_root

    kept: list[EntryRequest] = []
    other: dict[str, str] = {}
    for request in requests:
        if request.at.endswith(".py"):
            if os.path.abspath(request.at) in named or not _describes_nothing(request.at, session):
                kept.append(request)
            continue
        data = session.read(request.file).data
        is_other = data is not None and os.path.abspath(request.at) not in named and not is_program(request.at, data)
        root = other_root(data) if data is not None and is_other else None
        if root is None and data is not None and is_other and names_no_program(data):
            root = ""
        if root is not None:
            other[session.shown(request.at)] = root
        else:
            kept.append(request)
    return SortedOut(kept, tuple(other.items()))


def _describes_nothing(path: str, session: Session) -> bool:
    """Whether a file in Python has the name of a launch file, and is a test for launch_testing, or a module that others import."""
    data = session.read(path).data
    if data is None or b"generate_launch_description" in data:
        return False
    return b"generate_test_description" in data or not path.endswith(PYTHON_END)

"""Leaving out what only looks like a launch file: files of other programs with the same ending (Eclipse has ``.launch`` files, too)."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Sequence
from contextlib import suppress

from launchlint.check.options import EntryRequest
from launchlint.evaluate.session import Session
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.discovery import PYTHON_END, absolute, is_program

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeVar

    Made = TypeVar("Made")


class SortedOut(NamedTuple):
    """Requests for launch files, and the paths of others, each with the name of its root; empty where that is ``launch``."""

    kept: list[EntryRequest]
    other: tuple[tuple[str, str], ...]


def sort_out(requests: Sequence[EntryRequest], named: Collection[str], session: Session) -> SortedOut:
    """Tell launch files from others. Files in ``named`` (absolute) were asked for by name, and stay whatever they hold."""
    kept: list[EntryRequest] = []
    other: dict[str, str] = {}
    for request in requests:
        if named and os.path.abspath(request.at) in named:
            kept.append(request)
        elif request.at.endswith(".py"):
            if not _found(request, "describes nothing", _describes_nothing, session):
                kept.append(request)
        else:
            root = _found(request, "root", _other_root, session)
            if root is None:
                kept.append(request)
            else:
                other[session.shown(request.at)] = root
    return SortedOut(kept, tuple(other.items()))


def _found(request: EntryRequest, kind: str, find: Callable[[str, bytes], Made | None], session: Session) -> Made | None:
    """What ``find`` finds in a file, now or in an earlier run; None where it cannot be read."""
    held = session.packages.held
    if held is not None and request.file == request.at:
        with suppress(OSError):
            file = absolute(request.file, os.getcwd())
            found: Made | None = held.fact(file, kind, lambda data: find(file, data), _same, _same)
            return found
    data = session.read(request.file).data
    return None if data is None else find(request.at, data)


def _same(value: Any) -> Any:
    return value


def _other_root(path: str, data: bytes) -> str | None:
    """The root of what is no launch file, empty where that is ``launch``; None for a launch file."""
    from launchlint.workspace.launch_root import names_no_program, other_root

    if is_program(path, data):
        return None
    root = other_root(data)
    return "" if root is None and names_no_program(data) else root


def _describes_nothing(path: str, data: bytes) -> bool:
    """Whether a file in Python has the name of a launch file, and is a test for launch_testing, or a module that others import."""
    if b"generate_launch_description" in data:
        return False
    return b"generate_test_description" in data or not path.endswith(PYTHON_END)

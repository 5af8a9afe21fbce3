"""Looking around on disk: whether something is there, and what a directory holds.

What rules look at beside launch files passes through here and is noted, since the result cache must know what a result hangs on.
"""

from __future__ import annotations

import os
from _thread import _local
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TypeVar

MOST_NAMES = 2_000
"""Directory entries that are looked at: a directory may be of any size, and all of this is only for hints."""

LARGEST_FILE = 1 << 20
"""Bytes: as :data:`launchlint.workspace.reading.LARGEST_FILE`."""
_MANY = 50
ALL_BELOW = "**"
_OF_NPM = "node_modules"
_PYTHON_ENVIRONMENT = "pyvenv.cfg"
PART = "//"
"""Between a file and the part of its text that matters (:func:`launchlint.workspace.texts.parts`): it stands in no absolute path."""

T = TypeVar("T")


class _Looked(set[str]):
    """What was looked at. ``wholes`` are large sets of which all has been added, by identity: a whole workspace is noted often."""

    def __init__(self) -> None:
        super().__init__()
        self.wholes: dict[int, frozenset[str]] = {}

    def update(self, *several: Iterable[str]) -> None:
        """Add what is in ``several``."""
        for paths in several:
            if not isinstance(paths, frozenset) or len(paths) < _MANY:
                super().update(paths)
            elif id(paths) not in self.wholes:
                super().update(paths)
                self.wholes[id(paths)] = paths

    def clear(self) -> None:
        """Forget all."""
        super().clear()
        self.wholes.clear()


class _Account(_local):
    """What a thread looked at: by everything, then by each piece of work inside of another that is watched."""

    def __init__(self) -> None:
        self.noted: list[_Looked] = [_Looked()]


_account = _Account()


def exists(path: str) -> bool:
    """Whether there is anything at ``path``."""
    return os.path.exists(_note(path))


def is_file(path: str) -> bool:
    """Whether there is a file at ``path``."""
    return os.path.isfile(_note(path))


def is_directory(path: str) -> bool:
    """Whether there is a directory at ``path``."""
    return os.path.isdir(_note(path))


def names(directory: str) -> list[str]:
    """The names in ``directory``, sorted; none where it cannot be read. Of a very large one only some are looked at."""
    try:
        return sorted(os.listdir(_note(directory or os.curdir)))[:MOST_NAMES]
    except (OSError, ValueError):
        return []


def walk(directory: str, most: int) -> Iterator[tuple[str, list[str]]]:
    """Each directory at and below ``directory`` with the names in it, in order. Ends after ``most``.

    Hidden ones and links are left out, and what npm or pip installed there: it is somebody else's, and there is much of it.
    """
    waiting = [directory]
    while waiting and most > 0:
        most -= 1
        current = waiting.pop()
        found = names(current)
        if _PYTHON_ENVIRONMENT in found:
            continue
        yield current, found
        below = [os.path.join(current, name) for name in found if not name.startswith(".") and name != _OF_NPM]
        waiting += [each for each in reversed(below) if os.path.isdir(each) and not os.path.islink(each)]


def start(path: str) -> bytes | None:
    """The first two bytes of a file; ``None`` where it cannot be read."""
    try:
        descriptor = os.open(_note(path), os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
    except (OSError, ValueError):
        return None
    try:
        return os.read(descriptor, 2)
    except OSError:
        return None
    finally:
        os.close(descriptor)


def content(path: str) -> bytes | None:
    """All of a small file; ``None`` where there is none that can be read."""
    from launchlint.workspace.reading import read_bytes

    try:
        return read_bytes(_note(path))
    except OSError:
        return None


def read_bytes(path: str, largest: int = LARGEST_FILE) -> bytes:
    """As :func:`launchlint.workspace.reading.read_bytes`."""
    from launchlint.workspace import reading

    return reading.read_bytes(_note(path), largest)


def note_tree(directory: str) -> None:
    """Note that which files there are below ``directory``, and which of them can be run, matters."""
    _account.noted[-1].add(os.path.join(os.path.abspath(directory), ALL_BELOW))


def noted() -> frozenset[str]:
    """What was looked at since this was called last; absolute paths."""
    taken = frozenset(_account.noted[-1])
    _account.noted[-1].clear()
    return taken


def watched(work: Callable[[], T]) -> tuple[T, frozenset[str]]:
    """What ``work`` gives, and what it looked at; that stays noted."""
    _account.noted.append(_Looked())
    try:
        result = work()
    finally:
        looked = frozenset(_account.noted.pop())
        note(looked)
    return result, looked


class _Deaf(_Looked):
    """An account in which nothing is noted."""

    def add(self, _: str) -> None:
        """Nothing."""

    def update(self, *_: Iterable[str]) -> None:
        """Nothing."""


@contextmanager
def unnoted() -> Iterator[None]:
    """While it lasts nothing is noted: what is looked at is of no concern to whatever this thread works on."""
    _account.noted.append(_Deaf())
    try:
        yield
    finally:
        _account.noted.pop()


def note(paths: Iterable[str]) -> None:
    """Note ``paths`` (absolute) again."""
    _account.noted[-1].update(paths)


def state(path: str) -> str:
    """Equal for equal answers of all functions here: what is at ``path``, the content of a small file, or the names in a directory."""
    from hashlib import sha1

    from launchlint.workspace.reading import read_bytes

    file, _, part = path.partition(PART)
    try:
        if file and part:
            from launchlint.workspace.text_parts import part_of

            listed = "\0".join(part_of(file, part)).encode("utf-8", "surrogateescape")
            return f"part {sha1(listed, usedforsecurity=False).hexdigest()}"
        if path.endswith(os.sep + ALL_BELOW):
            return f"tree {sha1(_tree(path[: -len(ALL_BELOW)]), usedforsecurity=False).hexdigest()}"
        if os.path.isdir(path):
            listed = "\0".join(sorted(os.listdir(path))).encode("utf-8", "surrogateescape")
            return f"directory {sha1(listed, usedforsecurity=False).hexdigest()}"
        if not os.path.exists(path):
            return ""
        return f"file {sha1(read_bytes(path), usedforsecurity=False).hexdigest()}"
    except (OSError, ValueError) as error:
        return f"{type(error).__name__} {getattr(error, 'errno', '')} {error.args[-1] if error.args else ''}"


def content_state(path: str) -> str:
    """As :func:`state`, sooner, for a small file; empty for all else."""
    from hashlib import sha1

    from launchlint.workspace.reading import read_bytes

    try:
        return f"file {sha1(read_bytes(path), usedforsecurity=False).hexdigest()}"
    except (OSError, ValueError):
        return ""


def _tree(directory: str) -> bytes:
    from launchlint.workspace.listing import files_of

    files, complete = files_of(directory)
    return "\0".join([f"{name} {mode & 0o111}" for name, mode in files.items()] + [str(complete)]).encode("utf-8", "surrogateescape")


def _note(path: str) -> str:
    _account.noted[-1].add(os.path.abspath(path))
    return path

"""What was read of programs, kept in a directory: one file each, written as a whole or not at all.

Whatever is wrong with a file or the directory, it is as if nothing had been kept.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress

from launchlint.atomic import seal
from launchlint.knowledge.entry import Known

MOST_FILES = 20_000
"""Programs that are kept; with more the older half is forgotten."""
LARGEST_FILE = 8 << 20
_BROKEN = (ValueError, TypeError, KeyError, IndexError, AttributeError, RecursionError)


class Store:
    """The directory in which programs are kept. ``directory`` None: for this run only, in memory."""

    def __init__(self, directory: str | None) -> None:
        self._directory = directory
        self._counted = False

    def get(self, name: str) -> Known | None:
        """What is kept under ``name``, whether or not it is still true."""
        if self._directory is None:
            return None
        try:
            with open(os.path.join(self._directory, f"{name}.json"), encoding="utf-8", errors="surrogateescape") as file:
                text = file.read(LARGEST_FILE)
            if text[:40] != seal(name, text[40:]):
                return None
            program, reason, looks = json.loads(text[40:])
            return Known(program, reason, tuple((path, state) for path, state in looks))
        except (OSError, *_BROKEN):
            return None

    def put(self, name: str, known: Known) -> None:
        """Keep what is known."""
        if self._directory is None:
            return
        text = json.dumps([known.program, known.reason, known.looks], separators=(",", ":"))
        try:
            os.makedirs(self._directory, mode=0o700, exist_ok=True)
            self._forget()
            path = os.path.join(self._directory, f".{name}.{os.getpid()}.new")
            try:
                with open(path, "x", encoding="utf-8") as file:
                    file.write(seal(name, text) + text)
                os.replace(path, os.path.join(self._directory, f"{name}.json"))
            except OSError:
                with suppress(OSError):
                    os.unlink(path)
        except OSError:
            return

    @contextmanager
    def alone(self, name: str) -> Iterator[None]:
        """Of several processes one at a time reads a program; the others find it kept afterwards."""
        if self._directory is None:
            yield
            return
        descriptor = -1
        try:
            import fcntl

            os.makedirs(self._directory, mode=0o700, exist_ok=True)
            # Few files, each for many names: who holds one never asks for a second.
            descriptor = os.open(os.path.join(self._directory, f".{name[:2]}.lock"), os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
            fcntl.flock(descriptor, fcntl.LOCK_EX)
        except (OSError, ImportError):
            pass  # then it may be read twice, which gives the same
        try:
            yield
        finally:
            if descriptor >= 0:
                os.close(descriptor)

    def _forget(self) -> None:
        """Make room, once in a run."""
        if self._counted or self._directory is None:
            return
        self._counted = True
        with os.scandir(self._directory) as scan:
            files = [entry for entry in scan if entry.name.endswith((".json", ".new"))]
        if len(files) > MOST_FILES:
            files.sort(key=lambda entry: (entry.stat(follow_symlinks=False).st_mtime, entry.name))
            for entry in files[: len(files) // 2]:
                with suppress(OSError):
                    os.unlink(entry.path)

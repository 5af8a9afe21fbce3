"""How far a long run is: shown on a terminal only, and only after a second."""

from __future__ import annotations

import sys
import time

DELAY = 1.0
"""Seconds before anything is shown."""


class ProgressBar:
    """A line on standard error that is written over and over."""

    __slots__ = ("_begin", "_shown", "_total")

    def __init__(self, total: int) -> None:
        self._total = total
        self._begin = time.monotonic()
        self._shown = False

    def show(self, done: int) -> None:
        """``done`` of all entry files are done."""
        elapsed = time.monotonic() - self._begin
        if elapsed < DELAY:
            return
        self._shown = True
        left = elapsed / max(done, 1) * (self._total - done)
        bar = "#" * (30 * done // self._total)
        sys.stderr.write(f"\r[{bar:30}] {done}/{self._total} launch files, {left:.0f} s left \x1b[K")
        sys.stderr.flush()

    def clear(self) -> None:
        """Take the line away again."""
        if self._shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()

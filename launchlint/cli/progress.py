"""How far a long run is: shown on a terminal only, and only after a second."""

from __future__ import annotations

import sys
import time

DELAY = 1.0
"""Seconds before anything is shown."""


class LateBar:
    """A bar for work of which it turns out only later how much there is."""

    __slots__ = ("_bar", "_what")

    def __init__(self, what: str) -> None:
        self._bar: ProgressBar | None = None
        self._what = what

    def show(self, done: int, total: int) -> None:
        """``done`` of ``total`` are done; the bar goes when all are."""
        if self._bar is None:
            self._bar = ProgressBar(total, self._what)
        self._bar.show(done)
        if done == total:
            self.clear()

    def clear(self) -> None:
        """Take the line away again."""
        if self._bar is not None:
            self._bar.clear()


class ProgressBar:
    """A line on standard error that is written over and over."""

    __slots__ = ("_begin", "_shown", "_total", "_what")

    def __init__(self, total: int, what: str = "launch files") -> None:
        self._total = total
        self._what = what
        self._begin = time.monotonic()
        self._shown = False

    def show(self, done: int, now: str = "") -> None:
        """``done`` of all are done; ``now`` says what is being done."""
        elapsed = time.monotonic() - self._begin
        if elapsed < DELAY:
            return
        self._shown = True
        left = elapsed / max(done, 1) * (self._total - done)
        bar = "#" * (30 * done // self._total)
        sys.stderr.write(f"\r[{bar:30}] {done}/{self._total} {self._what}, {left:.0f} s left {now}\x1b[K")
        sys.stderr.flush()

    def clear(self) -> None:
        """Take the line away again."""
        if self._shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()

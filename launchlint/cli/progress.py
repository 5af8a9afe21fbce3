"""How far a long run is: shown on a terminal only, and only after a second."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

DELAY = 1.0
"""Seconds before anything is shown."""


@contextmanager
def progress_bar(total: int, *, quiet: bool = False) -> Iterator[Callable[[int], None] | None]:
    """A function to call with the number of entry files done; None where nobody would see it."""
    if quiet or total < 2 or not sys.stderr.isatty():
        yield None
        return
    begin = time.monotonic()
    shown = False

    def show(done: int) -> None:
        nonlocal shown
        elapsed = time.monotonic() - begin
        if elapsed < DELAY:
            return
        shown = True
        left = elapsed / done * (total - done)
        bar = "#" * (30 * done // total)
        sys.stderr.write(f"\r[{bar:30}] {done}/{total} launch files, {left:.0f} s left \x1b[K")
        sys.stderr.flush()

    try:
        yield show
    finally:
        if shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()

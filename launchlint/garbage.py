"""When Python looks for garbage in circles, of which launchlint makes next to none."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

NEW_OBJECTS = 200_000
"""Objects made between two looks; with the 700 of Python the looks take a fifth of all time."""


@contextmanager
def seldom_looked_for() -> Iterator[None]:
    """Let Python look less often than it does by itself."""
    before = gc.get_threshold()
    gc.set_threshold(NEW_OBJECTS, *before[1:])
    try:
        yield
    finally:
        gc.set_threshold(*before)


def left_to_the_system() -> None:
    """At the end of the process: all that is left goes with it, so that nobody need look through it."""
    gc.freeze()

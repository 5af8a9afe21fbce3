"""When Python looks for garbage in circles, of which launchlint makes next to none."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

NEW_OBJECTS = 200_000
"""Objects made between two looks; with the 700 of Python the looks take a fifth of all time."""
WORTH_A_LOOK = 50_000
"""Objects made since the last look, among which :func:`look` looks in some 40 ms."""
MOST_OBJECTS = 400_000
"""Objects made before Python looks by itself where that is left to :func:`look`: some thirty texts of 300 nodes, typed without a breath."""


@contextmanager
def seldom_looked_for() -> Iterator[None]:
    """Let Python look less often than it does by itself."""
    before = gc.get_threshold()
    gc.set_threshold(NEW_OBJECTS, *before[1:])
    try:
        yield
    finally:
        gc.set_threshold(*before)


@contextmanager
def left_to_quiet_moments() -> Iterator[None]:
    """Leave it to :func:`look`: somebody waits for what is worked out between two of them. What there is now is never looked through."""
    before = gc.get_threshold()
    gc.freeze()
    gc.set_threshold(MOST_OBJECTS, *before[1:])
    try:
        yield
    finally:
        gc.set_threshold(*before)
        gc.unfreeze()


@contextmanager
def made_to_stay() -> Iterator[None]:
    """What is made now, from what was kept on disk, is no garbage: nobody looks through it until :func:`let_go`."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        if was_on:
            gc.enable()


def let_go() -> None:
    """What was made to stay may go."""
    gc.unfreeze()


def look(*, thoroughly: bool) -> None:
    """Look among all objects, or only among new ones, where there are enough of these."""
    if thoroughly:
        gc.collect()
    elif gc.get_count()[0] > WORTH_A_LOOK:
        gc.collect(0)


def left_to_the_system() -> None:
    """At the end of the process: all that is left goes with it, so that nobody need look through it."""
    gc.freeze()

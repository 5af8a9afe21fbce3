"""Which args would have to be given another value for something to change: as many as configurations can be tried for, and no more.

In a chain of args, each made from the one before, the last depends on all: kept whole, the sets would grow with the square of the file.
"""

from __future__ import annotations

from collections.abc import Iterable

MOST_STEERING = 64
"""Args that something is said to depend on. More configurations than that are not tried either."""


def steering(sets: Iterable[Iterable[str]]) -> frozenset[str]:
    """The union of ``sets``; the first names in the order of the alphabet where there are more than :data:`MOST_STEERING`."""
    union: frozenset[str] = frozenset().union(*sets)
    return union if len(union) <= MOST_STEERING else frozenset(sorted(union)[:MOST_STEERING])

"""A number and what it counts, in words: ``1 node``, ``2 nodes``."""

from __future__ import annotations


def counted(number: int, one: str, many: str = "", *, thousands: str = "") -> str:
    """``1 node``, ``2 nodes``; ``many`` where that is not ``one`` with an s. ``thousands`` may be a comma: ``1,234 nodes``."""
    return f"{number:{thousands}} {one if number == 1 else many or one + 's'}"

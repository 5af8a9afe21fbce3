"""Numbers and lists in words: ``1 node``, ``2 nodes``; ``a, b and 3 more``."""

from __future__ import annotations

from collections.abc import Sequence


def counted(number: int, one: str, many: str = "", *, thousands: str = "") -> str:
    """``1 node``, ``2 nodes``; ``many`` where that is not ``one`` with an s. ``thousands`` may be a comma: ``1,234 nodes``."""
    return f"{number:{thousands}} {one if number == 1 else many or one + 's'}"


def listed(names: Sequence[str], most: int) -> str:
    """The first ``most`` names, and how many more there are: ``a, b and 3 more``."""
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")

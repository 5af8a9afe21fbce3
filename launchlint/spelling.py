"""Did you mean: the closest of the names that exist."""

from __future__ import annotations

from collections.abc import Iterable


def distance(left: str, right: str, limit: int = 3) -> int:
    """Damerau-Levenshtein distance (insert, delete, replace, swap neighbours), at most ``limit`` + 1."""
    if left == right:
        return 0
    if abs(len(left) - len(right)) > limit:
        return limit + 1
    before: list[int] = []
    previous = list(range(len(right) + 1))
    for row, char in enumerate(left, 1):
        current = [row]
        for column, other in enumerate(right, 1):
            cost = min(previous[column] + 1, current[column - 1] + 1, previous[column - 1] + (char != other))
            if row > 1 and column > 1 and char == right[column - 2] and left[row - 2] == other:
                cost = min(cost, before[column - 2] + 1)
            current.append(cost)
        if min(current) > limit:
            return limit + 1
        before, previous = previous, current
    return previous[-1]


def closest(name: str, names: Iterable[str]) -> str | None:
    """The name of ``names`` that ``name`` is most likely a slip for; ``None`` where none is near enough.

    Near enough is one slip in a name of up to four letters, two in one of up to eight, three in a longer one. Letter case and
    the difference between ``-`` and ``_`` count as one slip together. Of several, the nearest and then alphabetically first.
    """
    if not name:
        return None
    limit = 1 if len(name) <= 4 else 2 if len(name) <= 8 else 3
    folded = _fold(name)
    letters = frozenset(name)
    best: tuple[int, str] | None = None
    for candidate in names:
        if candidate == name or not candidate:
            continue
        if _fold(candidate) == folded:
            apart = 1
        elif abs(len(candidate) - len(name)) > limit or len(letters.difference(candidate)) > limit:
            continue  # one slip changes the length by one and takes away one letter at most
        else:
            apart = distance(name, candidate, limit)
        if apart <= limit and apart < len(candidate) and (best is None or (apart, candidate) < best):
            best = (apart, candidate)
    return None if best is None else best[1]


def one_slip(name: str, names: Iterable[str]) -> str | None:
    """The only name of ``names`` that is exactly one slip away; ``None`` where there is none or more than one."""
    folded = _fold(name)
    near = {other for other in names if other != name and (_fold(other) == folded or distance(name, other, 1) == 1)}
    return near.pop() if len(near) == 1 else None


def surely(name: str, names: Iterable[str]) -> str | None:
    """The name that ``name`` must be a slip for: the only one that is one slip away. A name of one or two letters may be anything."""
    return one_slip(name, names) if len(name) > 2 else None


def did_you_mean(name: str, names: Iterable[str]) -> str:
    """A help text, ``did you mean …?``, or the empty string."""
    near = closest(name, names)
    return "" if near is None else f"did you mean {near}?"


def _fold(name: str) -> str:
    return name.casefold().replace("-", "_")

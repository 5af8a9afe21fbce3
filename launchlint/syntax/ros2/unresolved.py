"""What of a program could not be told without running it: said where it stands in what it describes."""

from __future__ import annotations

from collections.abc import Iterable

from launchlint.named_tuple import NamedTuple
from launchlint.source import Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Substitution

MOST_SAID = 200
"""Reasons that are kept of one file."""


class Unresolved(NamedTuple):
    """What could not be told of a launch file in Python, and why."""

    place: Place
    reason: str


def unresolved(actions: Iterable[object]) -> list[Unresolved]:
    """What is not known in actions, and why: each place once."""
    found: dict[tuple[tuple[str, int], str], Unresolved] = {}
    waiting: list[object] = [tuple(actions)]
    while waiting and len(found) < MOST_SAID:
        each = waiting.pop()
        if isinstance(each, Place) or not isinstance(each, tuple):
            continue
        reason = ""
        if isinstance(each, Substitution) and each.name == described.NOT_KNOWN and len(each.arguments) == 1:
            reason = each.arguments[0].literal or ""
        elif isinstance(each, (described.Maybe, described.Open)):
            reason = each.reason
        if reason and isinstance(each, (Substitution, described.Maybe, described.Open)):
            found.setdefault((each.place.key, reason), Unresolved(each.place, reason))
        waiting.extend(reversed(each))
    return sorted(found.values(), key=lambda said: (said.place.source.path, said.place.span.start))

"""Who includes whom."""

from __future__ import annotations

import os

from launchlint.ide.navigation import target_of_place
from launchlint.ide.view import Snapshot, Target
from launchlint.named_tuple import NamedTuple


class Call(NamedTuple):
    """A launch file (absolute), and the includes that lead from one to the other."""

    file: str
    at: tuple[Target, ...]


def _includes(snapshot: Snapshot) -> dict[tuple[str, str], dict[Target, None]]:
    found: dict[tuple[str, str], dict[Target, None]] = {}
    for entry in snapshot.entries:
        for configuration in entry.configurations:
            for include in configuration.evaluation.launch.includes:
                if include.source is not None:
                    place = include.origin.place
                    edge = (os.path.abspath(place.source.file), os.path.abspath(include.source.file))
                    found.setdefault(edge, {})[target_of_place(snapshot, place)] = None
    return found


def incoming(snapshot: Snapshot, file: str) -> list[Call]:
    """The files that include ``file`` (absolute)."""
    return [Call(source, tuple(at)) for (source, target), at in sorted(_includes(snapshot).items()) if target == file]


def outgoing(snapshot: Snapshot, file: str) -> list[Call]:
    """The files that ``file`` (absolute) includes."""
    return [Call(target, tuple(at)) for (source, target), at in sorted(_includes(snapshot).items()) if source == file]

"""How much was seen: of how many nodes it is known what they do, and why not of the rest."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from launchlint.plural import counted

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Unseen(NamedTuple):
    """A program of which nothing is known, why, and how many nodes run it."""

    program: str
    reason: str
    nodes: int


class Sight(NamedTuple):
    """Nodes that entry files start without args, those of them that are known, and the programs of the others, sorted."""

    nodes: int = 0
    known: int = 0
    unseen: tuple[Unseen, ...] = ()

    @property
    def brief(self) -> str:
        """For the end of a line: *12 of 15 nodes known*."""
        return f"{self.known} of {counted(self.nodes, 'node')} known"

    def as_object(self) -> dict[str, Any]:
        """For JSON."""
        return {"nodes": self.nodes, "known": self.known, "unknown": [each._asdict() for each in self.unseen]}


LONGEST_TEXT = 300
"""Characters of a name or reason: a launch file may hold one of megabytes."""
NOTHING = Sight()
"""Where nobody looked, or there was nothing to see."""


def together(sights: Iterable[Sight]) -> Sight:
    """What is seen of several entry files."""
    listed = list(sights)
    unseen = once(each for sight in listed for each in sight.unseen)
    return Sight(sum(each.nodes for each in listed), sum(each.known for each in listed), unseen)


def once(unseen: Iterable[tuple[str, str, int]]) -> tuple[Unseen, ...]:
    """Each program and reason once."""
    found: dict[tuple[str, str], int] = {}
    for program, reason, nodes in unseen:
        key = (_shortened(program), _shortened(reason))
        found[key] = found.get(key, 0) + nodes
    return tuple(Unseen(*key, found[key]) for key in sorted(found))


def reason_beside(program: str, reason: str) -> str:
    """The reason why ``program`` is not known, for one who has just read its name."""
    return reason.replace(f"the nodelet class {program}", "it").replace(program, "it")


def _shortened(text: str) -> str:
    return text if len(text) <= LONGEST_TEXT else f"{text[: LONGEST_TEXT - 1]}…"

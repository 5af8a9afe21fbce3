"""How much was seen: of how many nodes it is known what they do, and why not of the rest."""

from __future__ import annotations

from collections.abc import Iterable

from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Unseen(NamedTuple):
    """A program of which nothing is known, why, and how many nodes run it."""

    program: str
    reason: str
    nodes: int


class Followed(NamedTuple):
    """A launch file in Python: whether what it does is ``resolved``, ``partly`` or ``not``, and why, each reason with its line."""

    path: str
    state: str
    reasons: tuple[tuple[int, str], ...]


class Sight(NamedTuple):
    """Nodes that entry files start without args, those of them that are known, and the programs of the others, sorted.

    ``followed`` are the launch files in Python; ``distros`` the distributions that files of the repository name, and for which launch files
    were therefore read, each with such a file.
    """

    nodes: int = 0
    known: int = 0
    unseen: tuple[Unseen, ...] = ()
    followed: tuple[Followed, ...] = ()
    distros: tuple[tuple[str, str], ...] = ()

    @property
    def brief(self) -> str:
        """For the end of a line: *12 of 15 nodes known*."""
        return f"{self.known} of {counted(self.nodes, 'node')} known"

    def as_object(self) -> dict[str, Any]:
        """For JSON."""
        found = {"nodes": self.nodes, "known": self.known, "unknown": [each._asdict() for each in self.unseen]}
        if self.followed:
            found["python"] = [_as_object(each) for each in self.followed]
        if self.distros:
            found["distros"] = [{"name": name, "named_by": file} for name, file in self.distros]
        return found


LONGEST_TEXT = 300
"""Characters of a name or reason: a launch file may hold one of megabytes."""
NOTHING = Sight()
"""Where nobody looked, or there was nothing to see."""


def together(sights: Iterable[Sight]) -> Sight:
    """What is seen of several entry files."""
    listed = list(sights)
    unseen = once(each for sight in listed for each in sight.unseen)
    followed = {each.path: each for sight in listed for each in sight.followed}
    distros = sorted({each for sight in listed for each in sight.distros})
    known = sum(each.known for each in listed)
    return Sight(sum(each.nodes for each in listed), known, unseen, tuple(followed[path] for path in sorted(followed)), tuple(distros))


def once(unseen: Iterable[tuple[str, str, int]]) -> tuple[Unseen, ...]:
    """Each program and reason once."""
    found: dict[tuple[str, str], int] = {}
    for program, reason, nodes in unseen:
        key = (shortened(program), shortened(reason))
        found[key] = found.get(key, 0) + nodes
    return tuple(Unseen(*key, found[key]) for key in sorted(found))


def _as_object(followed: Followed) -> dict[str, Any]:
    reasons = [{"line": line, "reason": reason} for line, reason in followed.reasons]
    return {"file": followed.path, "state": followed.state, "reasons": reasons}


def reason_beside(program: str, reason: str) -> str:
    """The reason why ``program`` is not known, for one who has just read its name."""
    return reason.replace(f"the nodelet class {program}", "it").replace(program, "it")


def shortened(text: str) -> str:
    """A name or reason that is not too long to be shown."""
    return text if len(text) <= LONGEST_TEXT else f"{text[: LONGEST_TEXT - 1]}…"

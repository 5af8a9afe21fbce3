"""What rules have found to be in order, as results hold it: entry files that include the same file have much of it in common."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.named_tuple import NamedTuple
from launchlint.rules.rule import Fine


class InOrder(NamedTuple):
    """The places (offsets) in a file at which a rule has found nothing wrong; see :class:`launchlint.rules.rule.Fine`."""

    rule: str
    path: str
    topic: str
    starts: frozenset[int]

    @property
    def each(self) -> Iterator[Fine]:
        """What is in order at each place."""
        return (Fine(self.rule, self.path, start, self.topic) for start in sorted(self.starts))


def grouped(fine: Iterable[Fine]) -> tuple[InOrder, ...]:
    """The same, by rule, file and topic."""
    groups: dict[tuple[str, str, str], set[int]] = {}
    for each in fine:
        groups.setdefault((each.rule, each.path, each.topic), set()).add(each.start)
    return tuple(InOrder(*group, frozenset(starts)) for group, starts in groups.items())


class Together:
    """What is in order in any of several entry files."""

    def __init__(self) -> None:
        self._starts: dict[tuple[str, str, str], set[int]] = {}
        self._seen: set[int] = set()
        self._groups: list[InOrder] = []

    def add(self, groups: Iterable[InOrder]) -> None:
        """What is in order in one more entry file."""
        for group in groups:
            if id(group) not in self._seen:  # many results hold the same one; it is kept, so that no other gets its identity
                self._seen.add(id(group))
                self._groups.append(group)
                self._starts.setdefault(group[:3], set()).update(group.starts)

    def has(self, rule: str, path: str, start: int) -> bool:
        """Whether a place is in order, whatever the topic is that the rule speaks of."""
        return start in self._starts.get((rule, path, ""), ())


def to_text(group: InOrder) -> str:
    """A group as one text: read in one go, and soon compared."""
    starts = " ".join(map(str, sorted(group.starts)))
    return f"{group.rule}\n{starts}\n{len(group.topic)}\n{group.topic}{group.path}"


def from_text(text: str) -> InOrder:
    """The inverse of :func:`to_text`. Raises ValueError."""
    rule, starts, length, more = text.split("\n", 3)
    return InOrder(rule, more[int(length) :], more[: int(length)], frozenset(map(int, starts.split())))


class ReadOnce(dict[str, InOrder]):
    """Groups by their texts, each read once."""

    def __missing__(self, text: str) -> InOrder:
        group = self[text] = from_text(text)
        return group

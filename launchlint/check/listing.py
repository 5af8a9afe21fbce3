"""How many findings of one rule are listed: a file of 100,000 wrong tags is one mistake, made often, and must not hold up the run."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from launchlint.finding import Finding

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeVar

    Found = TypeVar("Found")

MOST_LISTED = 1_000
"""Findings of one rule in one configuration of an entry file, and in one file by itself."""


class Listing:
    """What was told so far, of one configuration of an entry file or of one file by itself."""

    def __init__(self) -> None:
        self._told: Counter[str] = Counter()
        self._more: dict[str, Finding] = {}

    def is_full(self, rule: str) -> bool:
        """Whether nothing more of the rule ``rule`` is listed: it need not be asked any more."""
        return rule in self._more

    def listed(self, found: Iterable[Found]) -> Iterator[Found]:
        """``found`` up to the first finding that is too many of its rule; nothing behind it is asked for."""
        for each in found:
            if isinstance(each, Finding):
                self._told[each.rule] += 1
                if self._told[each.rule] > MOST_LISTED:
                    self._more.setdefault(each.rule, each)
                    return
            yield each

    def left_out(self, selected: Iterable[str]) -> Iterator[Finding]:
        """For each rule that had more to say, a finding where it stopped, if the rule that says so is ``selected``."""
        from launchlint.rules.args import evaluation_bound

        if self._more and evaluation_bound.RULE.id in selected:
            yield from (evaluation_bound.left_out(each, MOST_LISTED) for each in self._more.values())

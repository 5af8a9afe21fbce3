"""One cause, one finding: what many findings say for one and the same reason is told once, at one of their places.

Suppressions, baselines and fixes work on the single findings; this is the last step before people see them. A rule whose module has a
function ``together`` says itself what several of its findings of one cause (worst first) come to; else the first of them speaks for all.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from launchlint.check.fragments import FRAGMENT, told_together
from launchlint.finding import Finding
from launchlint.order import most_severe_first, ordered
from launchlint.rules.judging.joined import joined, spokesman
from launchlint.rules.registry import find


def told_once(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """``findings`` in report order; one for all of one :attr:`Finding.cause`, with the places of the others."""
    result: list[Finding] = []
    alike: dict[str, list[Finding]] = {}
    for finding in ordered(findings):
        if not finding.cause:
            result.append(finding)
            continue
        alike.setdefault(finding.cause, []).append(finding)
    if not alike:
        return tuple(result)
    return tuple(ordered([*result, *map(_told, alike.values())]))


def _told(findings: Sequence[Finding]) -> Finding:
    """One finding for ``findings``, as the rule of the one that speaks for them says."""
    first = spokesman(findings)
    if len(findings) == 1:
        return first
    if first.cause.startswith(FRAGMENT):
        return told_together(most_severe_first(findings))
    rule = find(first.rule)
    together: Callable[[Sequence[Finding]], Finding] | None = None if rule is None else getattr(rule.load(), "together", None)
    return joined(findings) if together is None else together(most_severe_first(findings))

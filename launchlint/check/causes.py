"""One cause, one finding: what many findings say for one and the same reason is told once, at one of their places.

Suppressions, baselines and fixes work on the single findings; this is the last step before people see them. A rule whose module has a
function ``together`` says itself what several of its findings of one cause (worst first) come to; else the first of them speaks for all.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise

from launchlint.finding import Edit, Finding, Fix, Related
from launchlint.order import most_severe_first, ordered
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
    return tuple(ordered([*result, *map(_joined, alike.values())]))


def _joined(findings: Sequence[Finding]) -> Finding:
    """The worst of ``findings``, of these the one that shows most and then the first, with the others as related places."""
    first = min(findings, key=lambda finding: (-int(finding.severity), -len(finding.related)))
    others = [finding for finding in findings if finding is not first]
    if not others:
        return first
    rule = find(first.rule)
    together: Callable[[Sequence[Finding]], Finding] | None = None if rule is None else getattr(rule.load(), "together", None)
    if together is not None:
        return together(most_severe_first(findings))
    related = {item.location: item for item in first.related}
    new = [finding for finding in others if finding.location not in related]
    for finding in others:
        related.setdefault(finding.location, Related(finding.location, finding.label or finding.message))
        for item in finding.related:
            related.setdefault(item.location, item)
    places = f" (and at {len(new)} more place{'' if len(new) == 1 else 's'})" if new else ""
    return first._replace(
        message=f"{first.message}{places}",
        related=tuple(related.values()),
        entries=max(finding.entries for finding in findings),
        fix=_joined_fix([first, *others]),
    )


def _joined_fix(findings: Sequence[Finding]) -> Fix | None:
    """All repairs as one; none where one rule can repair some of the places only, or where two repairs change the same text."""
    fixes = [finding.fix for finding in findings if finding.fix is not None]
    repairing = {finding.rule for finding in findings if finding.fix is not None}
    if not fixes or any(finding.fix is None and finding.rule in repairing for finding in findings):
        return None
    edits = sorted({edit for fix in fixes for edit in fix.edits})
    if any(_overlap(one, other) for one, other in pairwise(edits)):
        return None
    changes = next((fix.changes for fix in fixes if fix.changes), "")
    return Fix(f"{fixes[0].message}, and the others alike", all(fix.safe for fix in fixes), tuple(edits), changes)


def _overlap(one: Edit, other: Edit) -> bool:
    return one.path == other.path and (other.start < one.end or (one.start == other.start and one.end == other.end))

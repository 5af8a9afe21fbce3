"""One cause, one finding: what many findings of a rule say for one and the same reason is told once, at the first of their places.

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
    """``findings`` in report order; one for all of one rule and :attr:`Finding.cause`, with the places of the others."""
    result: list[Finding] = []
    alike: dict[tuple[str, str], list[Finding]] = {}
    for finding in ordered(findings):
        if not finding.cause:
            result.append(finding)
            continue
        key = (finding.rule, finding.cause)
        if key not in alike:
            alike[key] = []
        alike[key].append(finding)
    if not alike:
        return tuple(result)
    return tuple(ordered([*result, *map(_joined, alike.values())]))


def _joined(findings: Sequence[Finding]) -> Finding:
    """The worst of ``findings``, the first of these, with the others as related places."""
    first = min(findings, key=lambda finding: -int(finding.severity))
    others = [finding for finding in findings if finding is not first]
    if not others:
        return first
    rule = find(first.rule)
    together: Callable[[Sequence[Finding]], Finding] | None = None if rule is None else getattr(rule.load(), "together", None)
    if together is not None:
        return together(most_severe_first(findings))
    related = {item.location: item for item in first.related}
    for finding in others:
        related.setdefault(finding.location, Related(finding.location, finding.label or finding.message))
        for item in finding.related:
            related.setdefault(item.location, item)
    places = f"{len(others)} more place{'' if len(others) == 1 else 's'}"
    return first._replace(
        message=f"{first.message} (and at {places})",
        related=tuple(related.values()),
        entries=max(finding.entries for finding in findings),
        fix=_joined_fix([first, *others]),
    )


def _joined_fix(findings: Sequence[Finding]) -> Fix | None:
    """All repairs as one; none where one of the findings has none, or where two of them change the same text."""
    fixes = [finding.fix for finding in findings if finding.fix is not None]
    if len(fixes) < len(findings):
        return None
    edits = sorted({edit for fix in fixes for edit in fix.edits})
    if any(_overlap(one, other) for one, other in pairwise(edits)):
        return None
    changes = next((fix.changes for fix in fixes if fix.changes), "")
    return Fix(f"{fixes[0].message}, and the others alike", all(fix.safe for fix in fixes), tuple(edits), changes)


def _overlap(one: Edit, other: Edit) -> bool:
    return one.path == other.path and (other.start < one.end or (one.start == other.start and one.end == other.end))

"""What several findings of one cause come to, where their rule has nothing better to say: one of them, with the places of the others."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise

from launchlint.finding import Edit, Finding, Fix, Related, Severity
from launchlint.late import late

_ALIKE = ", and the others alike"
_MORE = late(r" \(and at (\d+) more places?\)$")


def spokesman(findings: Sequence[Finding]) -> Finding:
    """Of ``findings`` the worst, of these the one that shows most, of these the first."""
    return min(findings, key=lambda finding: (-int(finding.severity), -len(finding.related)))


def joined(findings: Sequence[Finding], first: Finding | None = None) -> Finding:
    """The :func:`spokesman` of ``findings`` (or the one given as ``first``) with the others as related places, and all repairs as one."""
    first = spokesman(findings) if first is None else first
    others = [finding for finding in findings if finding is not first]
    elsewhere = [finding for finding in others if finding.location != first.location]
    related = {item.location: item for item in first.related}
    new = {finding.location: finding for finding in reversed(elsewhere) if finding.location not in related}.values()
    for finding in elsewhere:
        related.setdefault(finding.location, Related(finding.location, finding.label or finding.message))
        for item in finding.related:
            related.setdefault(item.location, item)
    said, known = said_of(first)
    more = known + sum(1 + said_of(finding)[1] for finding in new)  # some of them may speak for several places already
    places = f" (and at {more} more place{'' if more == 1 else 's'})" if more else ""
    return first._replace(
        message=f"{said}{places}",
        related=tuple(related.values()),
        entries=max(finding.entries for finding in findings),
        fix=_joined_fix([first, *others]),
    )


def alike(findings: Iterable[Finding], kind: Callable[[Finding], object]) -> Iterable[list[Finding]]:
    """``findings`` of one level and one ``kind`` each, in the order in which the first of each comes."""
    found: dict[tuple[Severity, object], list[Finding]] = {}
    for finding in findings:
        found.setdefault((finding.severity, kind(finding)), []).append(finding)
    return found.values()


def said_of(finding: Finding) -> tuple[str, int]:
    """What a finding says, and of how many places more than its own."""
    found = _MORE.search(finding.message)
    return (finding.message, 0) if found is None else (finding.message[: found.start()], int(found[1]))


def led_by(findings: Sequence[Finding], *rules: str) -> Finding:
    """As :func:`joined`, told by the first finding of ``rules``, the cause of the others, at the level of the worst."""
    worst = spokesman(findings)
    first = next((each for each in findings if each.rule in rules), worst)
    told = joined(findings, first)
    notes = told.notes if told.rule == worst.rule else tuple(dict.fromkeys((*told.notes, *worst.notes[:1])))
    return told._replace(severity=worst.severity, notes=notes)


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
    message = fixes[0].message if len(fixes) == 1 or fixes[0].message.endswith(_ALIKE) else f"{fixes[0].message}{_ALIKE}"
    return Fix(message, all(fix.safe for fix in fixes), tuple(edits), changes)


def _overlap(one: Edit, other: Edit) -> bool:
    return one.path == other.path and (other.start < one.end or (one.start == other.start and one.end == other.end))

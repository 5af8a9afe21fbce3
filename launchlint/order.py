"""The order findings are told in: the same for any order they were found in."""

from __future__ import annotations

from collections.abc import Iterable

from launchlint.finding import Finding


def ordered(findings: Iterable[Finding]) -> list[Finding]:
    """``findings`` by file, place, rule and message; what is still equal then, by all the rest, so that the order is total."""
    return sorted(findings, key=total)


def most_severe_first(findings: Iterable[Finding]) -> list[Finding]:
    """``findings`` with errors before warnings before infos, and within a severity as :func:`ordered`."""
    return sorted(findings, key=lambda finding: (-int(finding.severity), total(finding)))


def total(finding: Finding) -> tuple[object, ...]:
    """What a finding is ordered by."""
    fix = () if finding.fix is None else tuple(finding.fix)
    told = (finding.label, finding.related, finding.chain, finding.notes, finding.help, finding.name)
    return (*finding.sort_key, finding.topic, *told, finding.entry, finding.arguments, finding.entries, finding.element, fix)

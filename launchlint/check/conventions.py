"""Environment variables that many launch files of a workspace read: they are a convention there, and no oversight.

How many do is worked out when everything has been checked: what is said of one launch file would else hang on all the others.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity

CONVENTION = 3
"""Launch files of a workspace that read a variable, from which it is no oversight."""
_UNSET = "LL209"
"""By its ID: nearly no run has a finding of this rule, and its module takes a while to load."""


def judged_by_conventions(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those of LL209 about variables that several launch files read as infos, and each such variable told of on its own."""
    counts: Mapping[str, int] | None = None
    for finding in findings:
        if finding.rule == _UNSET:
            if counts is None:
                from launchlint.workspace.variables import count_launch_files

                counts = count_launch_files(known.packages.workspaces)
            finding = _judged(finding, counts)
        yield finding


def _judged(finding: Finding, counts: Mapping[str, int]) -> Finding:
    from launchlint.rules.args.env_unset import RULE, slip_of

    if finding.severity is not RULE.severity or slip_of(finding.topic) is not None:
        return finding
    count = counts.get(finding.topic, 0)
    if count < CONVENTION:
        return finding._replace(cause=" ".join(word for word in finding.cause.split(" ") if counts.get(word, 0) < CONVENTION))
    reason = f"{count} launch files read it: it is a convention here"
    return finding._replace(severity=Severity.INFO, notes=(*finding.notes, reason), cause=f"{RULE.id} {finding.topic}")

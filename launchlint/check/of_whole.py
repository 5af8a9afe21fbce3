"""Ends that meet nobody in a file which others of the workspace include: what is missing there, the whole may have.

A launch file that another one includes is a part of it, even where it has no args. Where every file that shows a loose end when it is
started is included by one that does not show it, though it is read as far, whoever starts the whole has no such mistake; started alone,
the file may still lack what was meant. So that is worth knowing, and no more.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Set

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity

NOTE = "so it is where this is started alone: {} includes it, and shows nothing of the kind"
_ABSENT = frozenset(("LL612", "LL613", "LL614"))


def judged_by_whole(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those about missing partners as information that no launch file shows which includes the one that does."""
    refused = {entry.path for entry in known.entries if entry.refused}
    for finding in findings:
        if finding.severity is Severity.WARNING and finding.rule in _ABSENT:
            alone = known.reached.get(finding.key, frozenset())
            around = [_wholes(path, known, refused) - alone for path in sorted(alone)]
            if around and all(around):
                finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, NOTE.format(min(around[0]))))
        yield finding


def _wholes(path: str, known: Known, refused: Set[str]) -> Set[str]:
    """The entry files that lead to a launch file; of those that roslaunch refuses only those to files that it refuses."""
    around = known.included_by.get(path, frozenset())
    return around if path in refused else around - refused

"""Parts for launch files that nothing includes any more: what is missing there is one finding for a file, and nobody is stopped by it.

A file called ``x.launch.xml`` (of ROS 1: in ROS 2 every launch file in XML is), or in a directory ``include`` or ``includes``, is written
for other launch files to include, and is not started by itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from launchlint.check.known import Known
from launchlint.dialects.ros1 import DIALECT as ROS1_DIALECT
from launchlint.finding import Finding, Related, Severity
from launchlint.rules.judging.joined import joined

PREFIX = "fragment "
NOTE = "it is a part for other launch files by its name, and nothing here includes it"
_MISSING = frozenset(("LL303", "LL401", "LL502"))
_DIRECTORIES = frozenset(("include", "includes"))


def judged_by_inclusion(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, the errors about what is missing in such a file as warnings of one cause."""
    included: set[str] | None = None
    for finding in findings:
        path = finding.location.path
        if (
            finding.severity is Severity.ERROR
            and finding.rule in _MISSING
            and _is_part(finding)
            and known.reached.get(finding.key) == {path}
        ):
            included = _included(known) if included is None else included
            if path not in included:
                notes = (*finding.notes, NOTE)
                finding = finding._replace(severity=Severity.WARNING, notes=notes, cause=PREFIX + path)
        yield finding


def told_together(findings: Sequence[Finding]) -> Finding:
    """One for all that is missing in one file: how much that is, with the places."""
    told = joined(findings)
    others = tuple(Related(each.location, each.message) for each in findings if each.location != told.location)
    count = len({each.message for each in findings})
    if count == 1:
        return told
    return told._replace(
        message=f"{count} things that this file needs are missing",
        label=min(findings, key=lambda each: each.location != told.location).message,
        related=others,
        notes=(NOTE,),
        help="remove the file, or correct the names",
        fix=None,
    )


def _is_part(finding: Finding) -> bool:
    *directories, name = finding.location.path.split("/")
    part = name.endswith(".launch.xml") and finding.launcher == ROS1_DIALECT.launcher
    return part or not _DIRECTORIES.isdisjoint(directories[-1:])


def _included(known: Known) -> set[str]:
    return {path for entry in known.entries for path in entry.included if path != entry.path}

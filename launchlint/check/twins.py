"""Packages that a checkout keeps twice: what is said of the same line in both is one finding."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity

_JOINED = "LL701"
"""The rule that itself says of copies what each of them lacks."""


def judged_by_twins(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those with one cause that two packages of one name show in the same file of theirs."""
    names = {each.directory: name for name, copies in known.packages.duplicates().items() for each in copies}
    if not names:
        yield from findings
        return
    told = list(findings)
    first: dict[tuple[str, ...], Finding] = {}
    causes: dict[str, str] = {}
    twins: dict[int, str] = {}
    for finding in told:
        said = _said(finding, names, known) if finding.severity > Severity.INFO and finding.rule != _JOINED else None
        if said is None:
            continue
        other = first.setdefault(said, finding)
        if other.location.path == finding.location.path:
            continue
        if finding.cause and other.cause:
            causes[finding.cause] = causes.get(other.cause, other.cause)
        else:
            twins[id(other)] = twins[id(finding)] = f"kept twice {' '.join(said)}"
    for finding in told:
        cause = twins.get(id(finding)) or causes.get(finding.cause)
        yield finding if cause is None else finding._replace(cause=cause)


def _said(finding: Finding, names: dict[str, str], known: Known) -> tuple[str, ...] | None:
    """What ``finding`` says, of which line of which file of which package, whatever directory that lies in; None where no other has its
    name.
    """
    file = known.file(finding.location.path)
    package = known.packages.package_of(file)
    name = None if package is None else names.get(package.directory)
    if package is None or name is None:
        return None
    inside = file[len(package.directory) + 1 :]
    return (name, inside, finding.rule, finding.severity.word, finding.label, finding.topic, finding.location.text.strip())

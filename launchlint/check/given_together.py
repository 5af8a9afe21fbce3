"""Errors of a configuration that the launch files here never make: who gives its values gives other args, too, and comes through.

The search for configurations gives one arg a text that it is compared with somewhere, and leaves the others at their defaults. Where
launch files of the workspace enter a file on the way to the error with these very values, and nothing is wrong there by default, it is
their values together that count: the error is that of a combination nobody starts. A switch (true or false) is offered by the file for
itself, whatever others do with it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.rules.view import EntrySummary

BOOLEANS = ("true", "false", "1", "0")

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Calls: TypeAlias = dict[str, list[tuple[str, Mapping[str, str]]]]


def judged_by_callers(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those as information that only a combination of args shows which no launch file here gives."""
    calls: Calls | None = None
    for finding in findings:
        if finding.severity is Severity.ERROR and finding.key not in known.by_default and _has_text(finding):
            calls = _calls(known.entries) if calls is None else calls
            caller = _caller(finding, calls)
            if caller is not None:
                given = " ".join(f"{name}:={value}" for name, value in finding.arguments)
                note = f"{caller} gives {given} too, and other args with which it does not come to this"
                finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, note))
        yield finding


def _has_text(finding: Finding) -> bool:
    return any(value.lower() not in BOOLEANS for _, value in finding.arguments)


def _calls(entries: Sequence[EntrySummary]) -> Calls:
    """By path of the included file: the entry file that leads there, and what it passes."""
    calls: Calls = {}
    for entry in entries:
        for path, passed in entry.calls:
            calls.setdefault(path, []).append((entry.path, dict(passed)))
    return calls


def _caller(finding: Finding, calls: Calls) -> str | None:
    """The first entry file, by name, that enters a file on the way to ``finding`` with all the values that show it."""
    wanted = dict(finding.arguments).items()
    way = {finding.entry, finding.location.path, *(place.path for place in finding.chain)}
    callers = (caller for path in way for caller, passed in calls.get(path, ()) if caller != finding.entry and wanted <= passed.items())
    return min(callers, default=None)

"""Findings as diagnostics."""

from __future__ import annotations

from collections.abc import Iterable

from lsprotocol import types

from launchlint.finding import Finding, Severity
from launchlint.rules.registry import find
from launchlint.server.documents import Documents
from launchlint.source import Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.session import Session
    from launchlint.finding import Location

PAGES = "https://launchlint.readthedocs.io/en/stable/rules/"
_SEVERITIES = {
    Severity.ERROR: types.DiagnosticSeverity.Error,
    Severity.WARNING: types.DiagnosticSeverity.Warning,
    Severity.INFO: types.DiagnosticSeverity.Information,
}
_UNNECESSARY = ("unused", "redundant", "no-effect", "ineffective", "dead", "never-met", "duplicate-remap")
_DEPRECATED = ("deprecated", "retired", "defunct")


def by_file(findings: Iterable[Finding], documents: Documents, session: Session) -> dict[str, list[types.Diagnostic]]:
    """The diagnostics of each open file (absolute), in order; an open file without any has an empty list."""
    found: dict[str, list[types.Diagnostic]] = {file: [] for file in documents.files}
    for finding in findings:
        file = session.named(finding.location.path)
        if file in found:
            found[file].append(diagnostic(finding, documents, session))
    return found


def diagnostic(finding: Finding, documents: Documents, session: Session) -> types.Diagnostic:
    """A finding of an open file."""
    words = [finding.message, *(f"note: {note}" for note in finding.notes)]
    if finding.help:
        words.append(f"help: {finding.help}")
    related = [(each.location, each.label) for each in finding.related] + [(each, "included from here") for each in finding.chain]
    return types.Diagnostic(
        range=_range(finding.location, documents, session),
        message="\n".join(words),
        severity=_SEVERITIES[finding.severity],
        code=finding.rule,
        code_description=types.CodeDescription(f"{PAGES}{finding.rule}/") if find(finding.rule) is not None else None,
        source="launchlint",
        tags=_tags(finding.name) or None,
        related_information=[
            types.DiagnosticRelatedInformation(
                types.Location(documents.address(session.named(at.path)), _range(at, documents, session)), label or "see here"
            )
            for at, label in related
        ]
        or None,
        data={"rule": finding.rule, "start": finding.location.start, "end": finding.location.end, "topic": finding.topic},
    )


def _range(at: Location, documents: Documents, session: Session) -> types.Range:
    return documents.lines(session.named(at.path)).range(Span(at.start, max(at.end, at.start)))


def _tags(name: str) -> list[types.DiagnosticTag]:
    tags = []
    if any(word in name for word in _UNNECESSARY):
        tags.append(types.DiagnosticTag.Unnecessary)
    if any(word in name for word in _DEPRECATED):
        tags.append(types.DiagnosticTag.Deprecated)
    return tags

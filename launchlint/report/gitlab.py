"""Findings as a GitLab code quality report."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.finding import Finding, Severity
from launchlint.fingerprint import fingerprints
from launchlint.report.escape import visible
from launchlint.report.json import dump
from launchlint.report.run import Run

_SEVERITIES = {Severity.ERROR: "critical", Severity.WARNING: "minor", Severity.INFO: "info"}


def render(findings: Sequence[Finding], run: Run) -> str:
    """A JSON array with the keys GitLab reads: description, check_name, fingerprint, severity and location; one finding in each line."""
    items = [
        dump(
            {
                "description": visible(f"{finding.rule} {finding.name}: {finding.message}"),
                "check_name": f"{finding.rule} {finding.name}",
                "fingerprint": mark,
                "severity": _SEVERITIES[finding.severity],
                "location": {"path": finding.location.path, "lines": {"begin": finding.location.line, "end": finding.location.end_line}},
            }
        )
        for finding, mark in fingerprints(findings)
    ]
    return "[\n" + ",\n".join(items) + "\n]\n" if items else "[]\n"

"""Findings as workflow commands of GitHub Actions, which become annotations of the changed lines."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.finding import Finding, Severity
from launchlint.order import most_severe_first
from launchlint.plural import counted
from launchlint.report.escape import github_message, github_property
from launchlint.report.run import Run
from launchlint.report.text import command

_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}
_PER_LEVEL = 10
"""GitHub shows no more annotations of one level for one step, and says nothing about the rest."""


def render(findings: Sequence[Finding], run: Run) -> str:
    """One command for each finding, the most severe first, at most ten of each level; a closing notice says how many more there are.

    Infos only where ``run.verbose``.
    """
    lines: list[str] = []
    left_out: list[str] = []
    shown = most_severe_first(finding for finding in findings if run.verbose or finding.severity > Severity.INFO)
    for severity in sorted(Severity, reverse=True):
        group = [finding for finding in shown if finding.severity is severity]
        # the closing notice takes one of the ten places of its level
        places = _PER_LEVEL if severity > Severity.INFO or (len(group) <= _PER_LEVEL and not left_out) else _PER_LEVEL - 1
        lines += [_command(finding) for finding in group[:places]]
        if len(group) > places:
            left_out.append(counted(len(group) - places, f"more {severity.word}"))
    if left_out:
        lines.append(f"::notice title=launchlint::{' and '.join(left_out)} not shown: GitHub takes ten of a level; --format text tells all")
    return "".join(f"{line}\n" for line in lines)


def _command(finding: Finding) -> str:
    at = finding.location
    properties = [("file", at.path), ("line", str(at.line))]
    if at.end_line == at.line:  # GitHub drops the columns of an annotation over several lines
        properties += [("col", str(at.column)), ("endLine", str(at.end_line)), ("endColumn", str(at.end_column))]
    else:
        properties += [("endLine", str(at.end_line))]
    properties.append(("title", f"{finding.rule} {finding.name}"))
    written = ",".join(f"{key}={github_property(value)}" for key, value in properties)
    return f"::{_LEVELS[finding.severity]} {written}::{github_message(_message(finding))}"


def _message(finding: Finding) -> str:
    lines = [finding.message]
    lines += [
        f"{related.label or 'see also'}: {related.location.path}:{related.location.line}:{related.location.column}"
        for related in finding.related
    ]
    lines += finding.notes
    if finding.entry:
        lines.append(f"show it: {command(finding)}")
    if finding.help:
        lines.append(f"help: {finding.help}")
    return "\n".join(line.replace("\r", "\\r").replace("\n", "\\n") for line in lines)

"""Findings as Markdown: for the summary of a workflow run, or a comment on a pull request."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.finding import Finding, Severity
from launchlint.order import most_severe_first
from launchlint.report.escape import markdown
from launchlint.report.run import Run
from launchlint.report.text import summary

LONGEST = 900_000
"""Bytes: GitHub takes a summary of one mebibyte, of which a picture may need a part."""
_ICONS = {Severity.ERROR: "🛑 error", Severity.WARNING: "⚠️ warning", Severity.INFO: "💡 info"}


def render(findings: Sequence[Finding], run: Run) -> str:
    """A heading with the counts, then a table of the findings, the most severe first; infos only where ``run.verbose``.

    What would make it longer than :data:`LONGEST` is left out, and counted.
    """
    shown = list(most_severe_first(finding for finding in findings if run.verbose or finding.severity > Severity.INFO))
    lines = [f"### launchlint: {markdown(summary(findings, run).strip())}", ""]
    lines += [f"> {markdown(notice)}" for notice in run.notices]
    if run.notices:
        lines.append("")
    if not shown:
        return "\n".join(lines)
    lines += ["| | rule | where | what |", "|---|---|---|---|"]
    size = sum(len(line.encode("utf-8", "replace")) + 1 for line in lines)
    for number, finding in enumerate(shown):
        row = _row(finding, run)
        size += len(row.encode("utf-8", "replace")) + 1
        if size > LONGEST:
            lines += ["", f"and {len(shown) - number} more, which do not fit here"]
            break
        lines.append(row)
    return "\n".join(lines) + "\n"


def _row(finding: Finding, run: Run) -> str:
    at = finding.location
    rule = f"{markdown(finding.rule)} {markdown(finding.name)}"
    what = markdown(finding.message)
    if finding.help:
        what += f"<br>{markdown(finding.help)}"
    return f"| {_ICONS[finding.severity]} | {rule} | {markdown(f'{at.path}:{at.line}')} | {what} |"

"""One line for each finding, for editors and problem matchers: ``path:line:col: severity CODE name: message``."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.finding import Finding, Severity
from launchlint.order import ordered
from launchlint.report.escape import line_start, visible
from launchlint.report.run import Run


def render(findings: Sequence[Finding], run: Run) -> str:
    """All findings, one line each; infos only where ``run.verbose``."""
    shown = (finding for finding in findings if run.verbose or finding.severity > Severity.INFO)
    return "".join(f"{headline(finding)}\n" for finding in ordered(shown))


def headline(finding: Finding) -> str:
    """The first line of a finding, without colours."""
    at = finding.location
    place = f"{line_start(at.path)}:{at.line}:{at.column}"
    return f"{place}: {finding.severity.word} {visible(finding.rule)} {visible(finding.name)}: {visible(finding.message)}"

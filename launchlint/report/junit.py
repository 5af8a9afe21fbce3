"""Findings as JUnit XML: one test case for each file with findings."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.finding import Finding
from launchlint.order import ordered
from launchlint.report.concise import headline
from launchlint.report.escape import visible, xml
from launchlint.report.run import Run


def render(findings: Sequence[Finding], run: Run) -> str:
    """A test case fails where its file has a finding that fails the run (``run.fail_on``); all other findings stand in its output.

    A run without findings is one test case that passed, since some readers refuse an empty report.
    """
    files: dict[str, list[Finding]] = {}
    for finding in ordered(findings):
        files.setdefault(finding.location.path, []).append(finding)
    cases = [_case(path, group, run) for path, group in files.items()] or [
        (['    <testcase classname="launchlint" name="launch files"/>'], False)
    ]
    failures = sum(failed for _, failed in cases)
    head = f'name="launchlint" tests="{len(cases)}" failures="{failures}" errors="0"'
    lines = ['<?xml version="1.0" encoding="utf-8"?>', f"<testsuites {head}>", f'  <testsuite {head} skipped="0">']
    lines += [line for case, _ in cases for line in case]
    return "\n".join([*lines, "  </testsuite>", "</testsuites>", ""])


def _case(path: str, findings: list[Finding], run: Run) -> tuple[list[str], bool]:
    """The lines of the test case of one file, and whether it failed."""
    failing: list[Finding] = []
    others: list[Finding] = []
    for finding in findings:
        (failing if run.fail_on is not None and finding.severity >= run.fail_on else others).append(finding)
    lines = [f'    <testcase classname="launchlint" name="{xml(visible(path))}">']
    if failing:
        message = failing[0].message if len(failing) == 1 else f"{len(failing)} findings, first: {failing[0].message}"
        kinds = sorted({finding.rule for finding in failing})
        lines.append(
            f'      <failure type="{xml(visible(" ".join(kinds)))}" message="{xml(visible(message))}">{_details(failing)}</failure>'
        )
    if others:
        lines.append(f"      <system-out>{_details(others)}</system-out>")
    return [*lines, "    </testcase>"], bool(failing)


def _details(findings: list[Finding]) -> str:
    lines: list[str] = []
    for finding in findings:
        lines.append(headline(finding))
        lines += [f"  = {visible(line)}" for line in (*finding.notes, finding.help) if line]
    return xml("\n".join(lines))

"""What ``check`` prints, and the exit status it ends with."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from launchlint.check.causes import told_once
from launchlint.check.entry import EntryResult
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.merge import Outcome, merge
from launchlint.check.options import Options
from launchlint.errors import UsageError
from launchlint.finding import Severity
from launchlint.named_tuple import NamedTuple
from launchlint.report.formats import emit, parse, write
from launchlint.report.run import RuleMetadata, Run, files_below
from launchlint.sight import NOTHING
from launchlint.workspace.packages import Packages

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TextIO

HELP_URI = "https://launchlint.readthedocs.io/en/stable/rules/"


class Request(NamedTuple):
    """How findings are to be shown, and when they count as failure."""

    formats: tuple[str, ...]
    fail_on: Severity
    color: bool
    verbose: bool
    quiet: bool
    statistics: bool
    exit_zero: bool
    version: str
    root: str
    verdicts: bool = True


def check_outputs(formats: Sequence[str], baseline: str | None) -> None:
    """Look whether every output can be made, before any work is done. Raises UsageError."""
    from launchlint.atomic import check_target

    files: dict[str, str] = {}
    for format_ in formats:
        output = parse(format_)
        if output.file is not None:
            check_target(output.file, what=f"the {output.format} report")
            absolute = os.path.realpath(output.file)
            if absolute in files:
                raise UsageError(f"--format {format_}: --format {files[absolute]} goes to the same file; give each a file of its own")
            files[absolute] = format_
    if baseline is not None:
        check_target(baseline, what="the baseline")


def report(outcome: Outcome, request: Request, notices: tuple[str, ...] = (), stream: TextIO | None = None) -> int:
    """Give the outcome in every format asked for, files before ``stream`` (default: standard output). Returns the exit status.

    What has one cause is told once.
    """
    outcome = outcome._replace(findings=told_once(outcome.findings))
    run = Run(
        version=request.version,
        rules=rule_metadata,
        files_checked=outcome.files,
        entries_checked=outcome.entries,
        color=request.color,
        verbose=request.verbose,
        width=_width(),
        fail_on=request.fail_on,
        root=request.root,
        notices=notices,
        successful=not outcome.crashed,
        read=files_below(request.root),
        verdicts=outcome.verdicts if request.verdicts else (),
        sight=outcome.sight if request.verdicts else NOTHING,
    )
    for format_ in sorted(request.formats, key=lambda each: parse(each).file is None):
        if not (request.quiet and parse(format_).file is None):
            write(format_, outcome.findings, run, stream)
    if request.statistics and not request.quiet:
        from launchlint.report.text import statistics

        emit(statistics(outcome.findings), stream or sys.stdout)
    return exit_status(outcome, request)


def exit_status(outcome: Outcome, request: Request) -> int:
    """2 where a rule crashed, 1 where a finding is as severe as asked for, else 0."""
    if outcome.crashed:
        return 2
    if request.exit_zero:
        return 0
    return int(any(finding.severity >= request.fail_on for finding in outcome.findings))


def entry_lines(results: Sequence[EntryResult], options: Options, packages: Packages, per_file: PerFileIgnores, request: Request) -> int:
    """One JSON line for each entry of ``--entries``, each judged by itself. Returns the exit status."""
    from launchlint.atomic import write_text
    from launchlint.report.jsonl import entry_line

    status = 0
    lines: list[str] = []
    for result in results:
        outcome = merge([result], options, packages, per_file, workspace=False, alone=True)
        lines.append(entry_line(result.request.file, result.request.at, result.verdict, told_once(outcome.findings), result.outcome))
        status = max(status, exit_status(outcome, request))
    text = "".join(lines)
    for file in [parse(format_).file if ":" in format_ else None for format_ in request.formats]:
        if file is not None:
            write_text(file, text, what="the jsonl report")
        elif not request.quiet:
            emit(text, sys.stdout)
    return status


def rule_metadata() -> dict[str, RuleMetadata]:
    """Every rule as SARIF describes it."""
    from launchlint.rules.page import page
    from launchlint.rules.registry import RULES

    rules: dict[str, RuleMetadata] = {}
    for rule in RULES:
        text = page(rule)
        category = rule.module.split(".")[0]
        precision = "very-high" if rule.severity is Severity.ERROR else "high"
        rules[rule.id] = RuleMetadata(
            rule.id, rule.name, rule.severity, text.summary, text.text, text.markdown, f"{HELP_URI}{rule.id}/", ("ros", category), precision
        )
    return rules


def _width() -> int:
    """Columns of the terminal, as COLUMNS says or the terminal itself; 120 where there is none."""
    columns = os.environ.get("COLUMNS", "")
    if columns.isdecimal() and int(columns[:6]) > 0:
        return int(columns[:6])
    try:
        return os.get_terminal_size(sys.__stdout__.fileno() if sys.__stdout__ else 1).columns or 120
    except (OSError, ValueError):
        return 120

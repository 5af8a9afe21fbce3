"""``launchlint check``."""

from __future__ import annotations

import os

import click

from launchlint import __version__
from launchlint.cli.options import EntryOptions, entry_options, leave_ros2_out, parse_severity, use_color
from launchlint.errors import UsageError
from launchlint.report.escape import visible

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.baseline import Baseline
    from launchlint.check.merge import Outcome


@click.command("check")
@entry_options
@click.option(
    "--select", multiple=True, metavar="RULES", help="Rules to run instead of the default ones: IDs, names, LL3 for a category, all."
)
@click.option("--ignore", multiple=True, metavar="RULES", help="Rules not to run.")
@click.option("--severity", multiple=True, metavar="RULE=LEVEL", help="Another severity for a rule: error, warning or info.")
@click.option(
    "--format",
    "formats",
    multiple=True,
    metavar="F[:FILE]",
    help="text (default), concise, json, jsonl, sarif, github, gitlab, junit; repeatable.",
)
@click.option("--fail-on", default="error", show_default=True, metavar="LEVEL", help="Least severity that makes the exit status 1.")
@click.option("--exit-zero", is_flag=True, help="Exit with status 0 whatever is found.")
@click.option("--baseline", metavar="FILE", help="Leave out the findings recorded in FILE.")
@click.option("--write-baseline", metavar="FILE", help="Record the present findings in FILE and end.")
@click.option("--statistics", is_flag=True, help="Add a table of how often each rule found something.")
@click.option("--jobs", type=click.IntRange(min=0), default=0, help="Processes to use; default: as many as pay.")
@click.option("--no-cache", is_flag=True, help="Neither read nor write the result cache.")
@click.option("--color", type=click.Choice(["auto", "always", "never"]), default="auto", help="Colours in the text format.")
@click.option("-q", "--quiet", is_flag=True, help="Print nothing; the exit status tells.")
@click.option("-v", "--verbose", is_flag=True, help="Show infos too.")
def command(
    entry: EntryOptions,
    select: tuple[str, ...],
    ignore: tuple[str, ...],
    severity: tuple[str, ...],
    formats: tuple[str, ...],
    fail_on: str,
    exit_zero: bool,
    baseline: str | None,
    write_baseline: str | None,
    statistics: bool,
    jobs: int,
    no_cache: bool,
    color: str,
    quiet: bool,
    verbose: bool,
) -> int:
    """Find the mistakes in launch files.

    PATHS are launch files and directories; default: the current directory. Every file is evaluated as roslaunch would, in every configuration that its
    conditions allow; nothing from the checked files is executed. Exit status: 0 nothing at or above --fail-on, 1 findings, 2 wrong usage.
    """
    from launchlint.check.entry import EntryChecker
    from launchlint.check.merge import merge
    from launchlint.check.run import check_entries, default_directory
    from launchlint.cli.output import Request, check_outputs, entry_lines, report
    from launchlint.cli.progress import progress_bar
    from launchlint.cli.selection import per_file_ignores

    # Whatever is wrong with the options is told before any work is done.
    threshold = parse_severity(fail_on, "--fail-on")
    if entry.entries is not None and (
        baseline or write_baseline or statistics or any(each.partition(":")[0] != "jsonl" for each in formats)
    ):
        raise UsageError("--entries judges each entry by itself and prints one line of JSON for it: it goes with --format jsonl only")
    check_outputs(formats, write_baseline)
    options = entry.options(select=select, ignore=ignore, severity=severity)
    per_file = per_file_ignores(entry.configuration, options.root)
    known = None
    if baseline is not None and (write_baseline is None or os.path.exists(baseline)):
        from launchlint.baseline import load

        known = load(baseline)
    requests, overlay = entry.requests()
    checker = EntryChecker(options, overlay)
    requests, notices = leave_ros2_out(entry, requests, checker.session)
    shown = Request(formats or ("text",), threshold, use_color(color), verbose, quiet, statistics, exit_zero, __version__, options.root)
    directory = None if no_cache else default_directory()
    with progress_bar(len(requests), quiet=quiet) as progress:
        results = check_entries(requests, checker, jobs=jobs, cache_directory=directory, progress=progress)
    if not quiet:
        for notice in notices:
            click.echo(f"launchlint: {visible(notice)}", err=True)
    if entry.entries is not None:
        return entry_lines(results, options, checker.packages, per_file, shown)
    outcome = merge(results, options, checker.packages, per_file)
    if write_baseline is not None:
        return record(outcome, write_baseline, quiet=quiet)
    if known is not None:
        outcome = without_known(outcome, known)
    return report(outcome, shown, notices)


def record(outcome: Outcome, file: str, *, quiet: bool) -> int:
    """Write all findings to the baseline ``file``. Returns the exit status."""
    from launchlint.baseline import write
    from launchlint.check.file import INTERNAL_ERROR

    findings = [finding for finding in outcome.findings if finding.rule != INTERNAL_ERROR]
    write(file, findings)
    if not quiet:
        number = f"{len(findings)} finding{'' if len(findings) == 1 else 's'}"
        click.echo(f"launchlint: wrote {number} to {visible(file)}; --baseline {visible(file)} leaves them out from now on", err=True)
    return 2 if outcome.crashed else 0


def without_known(outcome: Outcome, known: Baseline) -> Outcome:
    """``outcome`` without the findings that a baseline knows; a crash is never known."""
    from launchlint.baseline import filter as unknown_ones
    from launchlint.check.file import INTERNAL_ERROR
    from launchlint.order import ordered

    crashes = [finding for finding in outcome.findings if finding.rule == INTERNAL_ERROR]
    others = [finding for finding in outcome.findings if finding.rule != INTERNAL_ERROR]
    return outcome._replace(findings=tuple(ordered([*unknown_ones(others, known), *crashes])))

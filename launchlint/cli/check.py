"""``launchlint check``."""

from __future__ import annotations

import sys

import click

from launchlint import __version__
from launchlint.cli.options import EntryOptions, entry_options, parse_severity, use_color


@click.command("check")
@entry_options
@click.option("--select", multiple=True, metavar="RULES", help="Rules to run instead of the default ones: IDs, names, LL3 for a category, all.")
@click.option("--ignore", multiple=True, metavar="RULES", help="Rules not to run.")
@click.option("--severity", multiple=True, metavar="RULE=LEVEL", help="Another severity for a rule: error, warning or info.")
@click.option("--format", "formats", multiple=True, metavar="F[:FILE]", help="text (default), concise, json, jsonl, sarif, github, gitlab, junit; repeatable.")
@click.option("--fail-on", default="error", show_default=True, metavar="LEVEL", help="Least severity that makes the exit status 1.")
@click.option("--exit-zero", is_flag=True, help="Exit with status 0 whatever is found.")
@click.option("--baseline", metavar="FILE", help="Leave out the findings recorded in FILE.")
@click.option("--write-baseline", metavar="FILE", help="Record the present findings in FILE and end.")
@click.option("--statistics", is_flag=True, help="Add a table of how often each rule found something.")
@click.option("--stdin-filename", metavar="PATH", help="With - as path: judge standard input as if it stood at PATH.")
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
    stdin_filename: str | None,
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
    from launchlint.cli.output import Request, entry_lines, report
    from launchlint.cli.progress import progress_bar
    from launchlint.cli.selection import per_file_ignores

    threshold = parse_severity(fail_on, "--fail-on")
    options = entry.options(select=select, ignore=ignore, severity=severity)
    requests, overlay = entry.requests(stdin_filename)
    per_file = per_file_ignores(entry.configuration)
    shown = Request(formats or ("text",), threshold, use_color(color), verbose, quiet, statistics, exit_zero, __version__, options.root)
    checker = EntryChecker(options, overlay)
    directory = None if no_cache else default_directory(options.variables)
    with progress_bar(len(requests), quiet=quiet) as progress:
        results = check_entries(requests, checker, jobs=jobs, cache_directory=directory, progress=progress)
    if entry.entries is not None:
        return entry_lines(results, options, checker.packages, per_file, shown, sys.stdout)
    outcome = merge(results, options, checker.packages, per_file)
    if baseline is not None:
        from launchlint.baseline import filter as without
        from launchlint.baseline import load

        outcome = outcome._replace(findings=tuple(without(outcome.findings, load(baseline))))
    if write_baseline is not None:
        from launchlint.baseline import write

        write(write_baseline, outcome.findings)
        click.echo(f"wrote {len(outcome.findings)} findings to {write_baseline}; use it with --baseline {write_baseline}", err=True)
        return 0
    return report(outcome, shown)

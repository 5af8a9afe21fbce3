"""``launchlint check``."""

from __future__ import annotations

import click

from launchlint.cli.checking import CheckOptions, run_check
from launchlint.cli.options import entry_options
from launchlint.project.asked import EntryOptions


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
    help="text (default), concise, json, jsonl, sarif, github, gitlab, junit, markdown; repeatable.",
)
@click.option("--fail-on", default="error", show_default=True, metavar="LEVEL", help="Least severity that makes the exit status 1.")
@click.option("--exit-zero", is_flag=True, help="Exit with status 0 whatever is found.")
@click.option("--fix", is_flag=True, help="Repair what can be repaired for certain, in 200 attempts at most, and tell of the rest.")
@click.option("--unsafe-fixes", is_flag=True, help="As --fix, and repair what is likely too: read the difference afterwards.")
@click.option("--diff", is_flag=True, help="Show what --fix (or --unsafe-fixes) would change, and change nothing.")
@click.option("--baseline", metavar="FILE", help="Leave out the findings recorded in FILE.")
@click.option("--write-baseline", metavar="FILE", help="Record the present findings in FILE and end.")
@click.option("--base", metavar="REV", help="Tell, too, what has lost a connection since this git revision.")
@click.option("--staged", is_flag=True, help="Judge the launch files that git would commit, as they are staged.")
@click.option("--changed", is_flag=True, help="PATHS changed: check the whole repository, tell what concerns them.")
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
    fix: bool,
    unsafe_fixes: bool,
    diff: bool,
    baseline: str | None,
    write_baseline: str | None,
    base: str | None,
    statistics: bool,
    jobs: int,
    no_cache: bool,
    color: str,
    quiet: bool,
    verbose: bool,
    staged: bool,
    changed: bool,
) -> int:
    """Find the mistakes in launch files.

    PATHS are launch files and directories; default: the current directory. Every file is evaluated as roslaunch or ros2 launch would, in
    every configuration that its conditions allow; nothing from the checked files is executed. Exit status: 0 nothing at or above --fail-on,
    1 findings, 2 wrong usage.
    """
    given = CheckOptions(
        select, ignore, severity, formats, fail_on, exit_zero, baseline, write_baseline, base, statistics, jobs, no_cache, color, quiet,
        verbose, staged, changed, fix, unsafe_fixes, diff,
    )  # fmt: skip
    return run_check(entry, given)

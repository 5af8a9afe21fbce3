"""``launchlint report``."""

from __future__ import annotations

import click

from launchlint.cli.options import entry_options
from launchlint.project.asked import EntryOptions


@click.command("report")
@entry_options
@click.option(
    "-o", "--output", default="report.html", show_default=True, metavar="FILE", help="Where to write the page; - for standard output."
)
@click.option("--picture", metavar="FILE", help="Write a picture, too, as SVG or PNG: of what changed (--base), else of the launch file.")
@click.option("--separate-assets", is_flag=True, help="Write style and scripts beside the page, for hosts that allow none in it.")
@click.option("--source-url", metavar="URL", help="Address of the repository's files; default: that of this commit, on GitHub's runners.")
@click.option("--base", metavar="REV", help="Show what changed since this git revision.")
@click.option("--title", metavar="TEXT", help="Title of the page; default: the name of what is shown.")
@click.option("--select", multiple=True, metavar="RULES", help="Rules to run instead of the default ones, as of check.")
@click.option("--ignore", multiple=True, metavar="RULES", help="Rules not to run.")
@click.option("--severity", multiple=True, metavar="RULE=LEVEL", help="Another severity for a rule: error, warning or info.")
@click.option("--fail-on", metavar="LEVEL", help="Least severity that makes the exit status 1; default: none does.")
@click.option("--jobs", type=click.IntRange(min=0), default=0, help="Processes to use; default: as many as pay.")
@click.option("-q", "--quiet", is_flag=True, help="Print nothing.")
def command(
    entry: EntryOptions,
    output: str,
    picture: str | None,
    separate_assets: bool,
    source_url: str | None,
    base: str | None,
    title: str | None,
    select: tuple[str, ...],
    ignore: tuple[str, ...],
    severity: tuple[str, ...],
    fail_on: str | None,
    jobs: int,
    quiet: bool,
) -> int:
    """Write one HTML page that shows launch files: what connects, what is wrong, and where that is written.

    PATHS are launch files and directories; default: the current directory. The page works without a network, from a file as from a server.
    Exit status: 0 the page was written (1 if something at or above --fail-on was found), 2 wrong usage.
    """
    from launchlint.cli.reporting import ReportOptions, run_report

    given = ReportOptions(output, separate_assets, source_url, base, title, select, ignore, severity, fail_on, jobs, quiet, picture)
    return run_report(entry, given)

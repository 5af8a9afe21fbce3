"""``launchlint extract``: a library from source code."""

from __future__ import annotations

import sys

import click

from launchlint.plural import counted

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.package import Result

MOST_SHOWN = 5
"""Programs named for one reason why they were not read."""
MOST_LINES = 200


@click.command("extract")
@click.option("-o", "--output", default="-", metavar="FILE", help="Where to write the library; default: standard output.")
@click.option("--package", "packages", multiple=True, metavar="NAME", help="Read this package only; repeatable. Default: all.")
@click.option("--jobs", type=click.IntRange(min=0), default=0, help="Processes to use; default: as many as pay.")
@click.option("-q", "--quiet", is_flag=True, help="No progress and no summary.")
@click.argument("sources", nargs=-1, required=True, metavar="SRC...")
def command(output: str, packages: tuple[str, ...], jobs: int, quiet: bool, sources: tuple[str, ...]) -> int:
    """Make a library from source code: what nodes publish, subscribe, serve, call and read.

    SRC is the directory of a package or a workspace. Sources of rospy, roscpp, rclpy and rclcpp are read, never run, imported or
    built. Names that cannot be known from the source are open in the library; the summary on standard error counts them.
    """
    import os

    from launchlint.atomic import check_target, write_text
    from launchlint.cli.progress import ProgressBar
    from launchlint.extract.package import extract
    from launchlint.library.write import canonical
    from launchlint.report.formats import emit

    if output != "-":
        check_target(output, what="the library")
    bar: list[ProgressBar] = []

    def progress(done: int, total: int) -> None:
        if not bar:
            bar.append(ProgressBar(total, "programs"))
        bar[0].show(done)

    shown = not quiet and sys.stderr.isatty()
    try:
        result = extract(sources, packages, jobs or os.cpu_count() or 1, progress if shown else None)
    finally:
        for each in bar:
            each.clear()
    _validate(result.document)
    text = canonical(result.document)
    if output == "-":
        emit(text, sys.stdout)
    else:
        write_text(output, text, what="the library")
    if not quiet:
        _summarize(result)
    return 0


def _validate(document: object) -> None:
    from launchlint.errors import LibraryError
    from launchlint.library.validate import faults

    found = faults(document)
    if found:
        where = "/".join(str(each) for each in found[0].path)
        raise LibraryError(f"what was extracted is no library, which is a mistake of launchlint: {where}: {found[0].message}")


def _summarize(result: Result) -> None:
    from launchlint.report.escape import visible

    lines = [f"{counted(result.programs, 'program')}, {counted(result.names, 'name')}, {result.unresolved} not known as a whole"]
    if result.opened:
        lines[0] += f"; {counted(result.opened, 'program')} may have more"
    by_reason: dict[str, list[str]] = {}
    for each in result.skipped:
        by_reason.setdefault(each.reason, []).append(f"{_named(each.package, each.name)} ({each.path})")
    if result.skipped:
        lines.append(f"{counted(len(result.skipped), 'program')} not read:")
    for reason, named in by_reason.items():
        more = f" and {len(named) - MOST_SHOWN} more" if len(named) > MOST_SHOWN else ""
        lines.append(f"  {visible(', '.join(named[:MOST_SHOWN]))}{more}: {visible(reason)}")
    click.echo("\n".join(lines[:MOST_LINES]), err=True)


def _named(package: str, name: str) -> str:
    return f"{package}/{name}" if name and not name.startswith(f"{package}/") else name or package or "a package"

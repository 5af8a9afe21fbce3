"""``launchlint library``: look at, join, compare and check libraries."""

from __future__ import annotations

import sys

import click


@click.group("library")
def command() -> None:
    """Look at, join, compare and check libraries: what nodes publish, subscribe, serve, call and read."""


@command.command("validate")
@click.argument("files", nargs=-1, required=True, metavar="FILE...")
@click.option("-q", "--quiet", is_flag=True, help="Print faults only.")
def validate(files: tuple[str, ...], quiet: bool) -> int:
    """Check libraries: every FILE must follow the format, and nothing in it may be without effect.

    Prints one line for each fault, path:line:column: what is wrong. The exit status is 2 where there is one.
    """
    from launchlint.errors import LibraryError
    from launchlint.library.file import read
    from launchlint.library.inspection import inspect
    from launchlint.report.formats import emit
    from launchlint.report.library import faults, summary

    status = 0
    for file in files:
        try:
            document, found = inspect(read(file), file)
        except LibraryError as error:
            document, found = None, [str(error)]
        if found:
            status = 2
            emit(faults(found), sys.stdout)
        elif not quiet:
            emit(summary(file, document), sys.stdout)
    return status

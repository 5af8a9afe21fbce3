"""``launchlint format``."""

from __future__ import annotations

import click

from launchlint.cli.formatting import FormatOptions, run_format


@click.command("format")
@click.argument("paths", nargs=-1, metavar="[PATHS]...")
@click.option("--check", is_flag=True, help="Change nothing; exit status 1, and a list, where something is not in normal form.")
@click.option("--diff", is_flag=True, help="Change nothing; show what would be changed, and exit with status 1.")
@click.option("--stdin-filename", metavar="PATH", help="With - as path: format standard input as if it stood at PATH.")
@click.option("--config", metavar="FILE", help="Configuration file; default: the nearest .launchlint.yaml.")
@click.option("--workspace", multiple=True, metavar="DIR", help="Where packages are, for sort-args; repeatable.")
@click.option("--color", type=click.Choice(["auto", "always", "never"]), default="auto", help="Colours in the diff.")
@click.option("-q", "--quiet", is_flag=True, help="Print nothing but errors; the exit status tells.")
def command(
    paths: tuple[str, ...],
    check: bool,
    diff: bool,
    stdin_filename: str | None,
    config: str | None,
    workspace: tuple[str, ...],
    color: str,
    quiet: bool,
) -> int:
    """Write launch files in normal form, with every comment kept and the meaning proved unchanged.

    PATHS are launch files and directories; default: the current directory; - formats standard input to standard output. Files that
    their launcher cannot read are left alone. Exit status: 0 all is in normal form now, 1 with --check and --diff where something is not,
    2 wrong usage, or a file that had to be left alone.
    """
    return run_format(FormatOptions(paths, check, diff, stdin_filename, config, workspace, color, quiet))

"""``launchlint library``: look at, join, compare and check libraries."""

from __future__ import annotations

import sys

import click


@click.group("library", invoke_without_command=True)
@click.pass_context
def command(context: click.Context) -> int:
    """Look at, join, compare and check libraries: what nodes publish, subscribe, serve, call and read."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help(), err=True)
        return 2
    return 0


@command.command("show")
@click.option("--library", "libraries", multiple=True, metavar="FILE", help="A library besides the bundled one; repeatable, the last wins.")
@click.option("--config", metavar="FILE", help="Configuration file, for its `library:`; default: the nearest .launchlint.yaml.")
@click.option("--no-bundled", is_flag=True, help="Leave out the library that launchlint ships.")
@click.option("--format", "format_", type=click.Choice(["text", "json"]), default="text", show_default=True, help="How to print it.")
@click.option("-v", "--verbose", is_flag=True, help="Show the evidence for each name, too.")
@click.argument("names", nargs=-1, metavar="[NAME]...")
def show(libraries: tuple[str, ...], config: str | None, no_bundled: bool, format_: str, verbose: bool, names: tuple[str, ...]) -> int:
    """Show what is known of each NAME: a package, PACKAGE/EXECUTABLE, a nodelet class or a component. Without NAME list the packages.

    Known is what the bundled library says, what the configuration's `library:` says and what each --library says.
    """
    from launchlint.check.run import default_directory
    from launchlint.library.catalogue import find, rows
    from launchlint.library.lookup import open_libraries
    from launchlint.project.asked import read_configuration
    from launchlint.report.formats import emit
    from launchlint.report.library import entries, entries_json, listing, listing_json

    files = (*read_configuration(config, ()).library, *libraries)
    library = open_libraries(files, default_directory(), bundled=not no_bundled)
    if names:
        found = find(library, names)
        emit(entries_json(found) if format_ == "json" else entries(found, verbose=verbose), sys.stdout)
    else:
        packages = rows(library)
        emit(listing_json(packages) if format_ == "json" else listing(packages), sys.stdout)
    return 0


@command.command("validate")
@click.option("-q", "--quiet", is_flag=True, help="Print faults only.")
@click.argument("files", nargs=-1, required=True, metavar="FILE...")
def validate(files: tuple[str, ...], quiet: bool) -> int:
    """Check libraries: every FILE must follow the format, and nothing in it may be without effect.

    Prints one line for each fault, path:line:column: what is wrong. The exit status is 2 where there is one.
    """
    from launchlint.library.inspection import inspect_file
    from launchlint.report.formats import emit
    from launchlint.report.library import faults, summary

    status = 0
    for file in files:
        document, found = inspect_file(file)
        if found:
            status = 2
            emit(faults(found), sys.stdout)
        elif not quiet:
            emit(summary(file, document), sys.stdout)
    return status


@command.command("merge")
@click.option("-o", "--output", required=True, metavar="FILE", help="Where to write the library; - for standard output.")
@click.argument("files", nargs=-1, required=True, metavar="FILE...")
def merge(files: tuple[str, ...], output: str) -> int:
    """Join libraries into one, with all evidence kept.

    What a person wrote wins over what was seen in a run, that over what was read from source; of equals the FILE given last wins, as with
    --library of other commands. Give all files at once.
    """
    from launchlint.atomic import check_target, write_text
    from launchlint.library.merge import merge_files
    from launchlint.report.formats import emit
    from launchlint.report.library import canonical_json

    if output != "-":
        check_target(output, what="the library")
    text = merge_files(files)
    if output == "-":
        emit(canonical_json(text), sys.stdout)
    else:
        write_text(output, text, what="the library")
    return 0


@command.command("diff")
@click.option("--format", "format_", type=click.Choice(["text", "json"]), default="text", show_default=True, help="How to print it.")
@click.argument("old", metavar="OLD")
@click.argument("new", metavar="NEW")
def diff(old: str, new: str, format_: str) -> int:
    """Tell what changed from the library OLD to the library NEW, evidence left aside.

    The exit status is 0 where nothing did, else 1.
    """
    from launchlint.library.difference import difference
    from launchlint.library.file import parse, read
    from launchlint.report.formats import emit
    from launchlint.report.library_changes import changes_json, changes_text

    changes = difference(parse(read(old), old), parse(read(new), new))
    emit(changes_json(changes) if format_ == "json" else changes_text(changes), sys.stdout)
    return int(bool(changes))


@command.command("schema")
@click.option("--version", type=click.Choice(["1", "2"]), help="Of one version of the format alone; default: of all.")
def schema(version: str | None) -> int:
    """Print the format of libraries as a JSON Schema, for editors and other programs."""
    import json

    from launchlint.library.schema import json_schema
    from launchlint.report.formats import emit

    emit(json.dumps(json_schema(None if version is None else int(version)), indent=2) + "\n", sys.stdout)
    return 0

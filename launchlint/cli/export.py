"""``launchlint export``."""

from __future__ import annotations

import sys

import click

from launchlint.cli.entries import tell
from launchlint.errors import UsageError
from launchlint.project.asked import EntryOptions

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.check.entry import EntryChecker
    from launchlint.check.options import EntryRequest
    from launchlint.fix.format.style import Style


@click.command("export")
@click.argument("file")
@click.argument("arguments", nargs=-1, metavar="[NAME:=VALUE]...")
@click.option("--flatten", is_flag=True, help="Write one file that needs no other: includes inlined, args and groups resolved.")
@click.option("--args-kept", is_flag=True, help="With --flatten: keep the args of FILE, so that they can still be given.")
@click.option("--to", "to", type=click.Choice(["xml", "yaml", "ros2"]), help="Write a launch file of ROS 2 in this language; ros2 is xml.")
@click.option("--from", "from_", type=click.Choice(["ros1", "ros2"]), help="What FILE is a launch file of; default: as it says itself.")
@click.option("-o", "--output", metavar="FILE", help="Where to write it; default: standard output.")
@click.option("--workspace", multiple=True, metavar="DIR", help="Where packages are; repeatable, the first that has a package wins.")
@click.option("--config", metavar="FILE", help="Configuration file; default: the nearest .launchlint.yaml.")
@click.option("--distro", metavar="NAME", help="With --to: the distribution of ROS 2 that it is for; default: that of the environment.")
@click.option("--stdin-filename", metavar="PATH", help="With - as FILE: take standard input as if it stood at PATH.")
def command(
    file: str,
    arguments: tuple[str, ...],
    flatten: bool,
    args_kept: bool,
    to: str | None,
    from_: str | None,
    output: str | None,
    workspace: tuple[str, ...],
    config: str | None,
    distro: str | None,
    stdin_filename: str | None,
) -> int:
    """Write what FILE starts as a launch file again.

    Without --flatten that is FILE itself in the normal form of `launchlint format`: includes, args, conditions and comments stay. What is
    written has been compared with FILE, and means the same; otherwise nothing is written. The exit status is 1 where roslaunch, or
    ros2 launch, would refuse FILE. Files of ROS 2 are not flattened.

    With --to, FILE is written in another language of ROS 2: from XML to YAML or back, from Python as far as a declarative launch file can
    say it, and, with --from ros1, from ROS 1. What cannot be carried over is told line by line, and stands in the file as comments.
    """
    from launchlint.atomic import check_target
    from launchlint.check.entry import EntryChecker
    from launchlint.export.written import CannotExport
    from launchlint.fix.format.style import Style
    from launchlint.rules.registry import RULES

    if (from_ or distro) and not to:
        raise UsageError(f"{'--from' if from_ else '--distro'} goes with --to")
    if to and flatten:
        raise UsageError("--to and --flatten do not go together")
    if args_kept and not flatten:
        raise UsageError("--args-kept goes with --flatten; without it, all args stay anyway")
    if output is not None:
        check_target(output, what="the exported file")
    entry = EntryOptions((file,), arguments, None, workspace, config, stdin_filename, distro=distro)
    requests, overlay = entry.requests()
    request = _the_file(file, entry, requests)
    if to is not None:
        from launchlint.cli.converting import convert

        converted = convert(entry, overlay, request, "yaml" if to == "yaml" else "xml", from_, to)
        if converted is not None:
            put(converted.data, output)
        return int(converted is None)
    about_loading = frozenset(rule.id for rule in RULES if rule.on or rule.view == "problem")
    checker = EntryChecker(entry.options(everything=True)._replace(rules=about_loading, default_only=True), overlay)
    if _refused(checker, request):
        return 1
    try:
        style = Style(entry.configuration.line_width, entry.configuration.indent, entry.configuration.sort_attributes)
        data, notices = _exported(checker, request, style, flatten=flatten, args_kept=args_kept)
    except CannotExport as error:
        raise UsageError(f"{file} cannot be exported, and nothing is written: {error.reason}") from error
    for notice in notices:
        tell(notice)
    put(data, output)
    return 0


def put(data: bytes, output: str | None) -> None:
    """Write what is exported where it is asked for."""
    from launchlint.atomic import write_bytes

    if output is None:
        sys.stdout.buffer.write(data)
        sys.stdout.buffer.flush()
    else:
        write_bytes(output, data, what="the exported file")


def _the_file(file: str, entry: EntryOptions, requests: list[EntryRequest]) -> EntryRequest:
    """The one file, with the args of the command line only: what a configuration says of entries and profiles is for checks."""
    if not requests or requests[0].at != (entry.standard_input or file):
        raise UsageError(f"{file} is no launch file; give one")
    return requests[0]._replace(arguments=entry.arguments)


def _refused(checker: EntryChecker, request: EntryRequest) -> bool:
    """Whether its launcher refuses the file; why, or what it reads over in it, is told on standard error."""
    from launchlint import __version__
    from launchlint.dialects.door import named
    from launchlint.finding import Severity
    from launchlint.report.formats import emit
    from launchlint.report.run import Run
    from launchlint.report.text import render
    from launchlint.rules.registry import rule_of
    from launchlint.syntax.problems import MisplacedTag, UnknownAttribute, UnknownTag, WrongDialect

    # What roslaunch skips has no place in what is exported.
    read_over = (UnknownTag, UnknownAttribute, MisplacedTag, WrongDialect)
    evaluation, error = checker.model(request)
    result = checker.check(request)
    found = {each.key: each for each in (*(guarded.finding for file in result.files for guarded in file.findings), *result.findings)}
    always = {rule_of(kind) for kind in read_over} | (set() if error is None else {error[0]})
    told = [each for each in found.values() if each.severity is Severity.ERROR or each.rule in always]
    if told:
        emit(render(told, Run(__version__, files_checked=1, verbose=True, root=checker.session.root)), sys.stderr)
    if error is not None:
        rule, message = error
        launcher = named(evaluation.launch.dialect).launcher
        why = "" if told else f" ({rule}): {message}"
        tell(f"{request.at} is not exported, since {launcher} refuses it{why}")
    return error is not None


def _exported(checker: EntryChecker, request: EntryRequest, style: Style, *, flatten: bool, args_kept: bool) -> tuple[bytes, list[str]]:
    """The bytes, and what people should know about them. Raises CannotExport."""
    from launchlint.dialects.door import dialect_of
    from launchlint.export import flatten as flattening
    from launchlint.export.plain import plain
    from launchlint.export.written import CannotExport
    from launchlint.model import ROS1

    session = checker.session_for(request)
    if not flatten:
        return plain(session, request.at, request.arguments, style), []
    if dialect_of(session, request.at).name != ROS1:
        raise CannotExport("only launch files of ROS 1 can be flattened")
    exported = flattening.flatten(session, request.at, request.arguments, style, args_kept=args_kept)
    return exported.data, [f"fixed: {each}" for each in exported.fixed]

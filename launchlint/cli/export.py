"""``launchlint export``."""

from __future__ import annotations

import os
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
    ros2 launch, would refuse FILE. With --flatten a launch file of ROS 2 in Python is written as XML, or as --to says.

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
    if flatten and (to == "ros2" or from_):
        raise UsageError("a launch file of ROS 1 is translated without --flatten: flatten it before, or what is written behind")
    if args_kept and not flatten:
        raise UsageError("--args-kept goes with --flatten; without it, all args stay anyway")
    if output is not None:
        check_target(output, what="the exported file")
    entry = EntryOptions((file,), arguments, None, workspace, config, stdin_filename, distro=distro)
    requests, overlay = entry.requests()
    request = _the_file(file, entry, requests)
    if to is not None and not flatten:
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
        if flatten:
            data, notices = _flattened(checker, request, style, to, args_kept=args_kept)
        else:
            data, notices = _plain(checker, request, style), []
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
    if not requests or os.path.abspath(requests[0].at) != os.path.abspath(entry.standard_input or file):
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


def _plain(checker: EntryChecker, request: EntryRequest, style: Style) -> bytes:
    """The file in normal form. Raises CannotExport."""
    from launchlint.export.plain import plain

    return plain(checker.session_for(request), request.at, request.arguments, style)


def _flattened(checker: EntryChecker, request: EntryRequest, style: Style, to: str | None, *, args_kept: bool) -> tuple[bytes, list[str]]:
    """The bytes of one file that needs no other, and what people should know about them. Raises CannotExport."""
    from launchlint.dialects.door import dialect_of
    from launchlint.model import ROS1

    session = checker.session_for(request)
    if dialect_of(session, request.at).name == ROS1:
        from launchlint.export.flatten import flatten

        if to is not None:
            raise UsageError(f"{request.at} is a launch file of ROS 1; --to with --flatten is for those of ROS 2")
        exported = flatten(session, request.at, request.arguments, style, args_kept=args_kept)
        return exported.data, [f"fixed: {each}" for each in exported.fixed]
    from launchlint.cli.converting import told
    from launchlint.export.ros2.flattening import flatten as flatten2
    from launchlint.export.ros2.flattening import language_of

    if args_kept:
        raise UsageError("--args-kept is for launch files of ROS 1: in one of ROS 2, any include and any group may change what an arg says")
    flat = flatten2(session, request.at, request.arguments, style, to or language_of(request.at))
    notices = [f"fixed: {each}" for each in flat.fixed]
    return flat.data, [*notices, *told(flat.lost, "not carried over: "), *told(flat.remarks, "look at this: ")]

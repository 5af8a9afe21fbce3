"""What ``launchlint format`` does; without click, which costs more time than formatting a file."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from functools import cached_property

from launchlint.cli.entries import tell, use_color
from launchlint.errors import UsageError
from launchlint.fix.format.formatting import Formatted, formatted
from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted
from launchlint.project.asked import EntryOptions, leave_others_out, style_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.session import Session
    from launchlint.fix.guard import Guard

LARGEST_FILE = 64 * 1024 * 1024
"""Bytes. The parser has a limit of its own below it, and says so."""


class FormatOptions(NamedTuple):
    """The options of ``format``, as written."""

    paths: tuple[str, ...] = ()
    check: bool = False
    diff: bool = False
    stdin_filename: str | None = None
    config: str | None = None
    workspace: tuple[str, ...] = ()
    color: str = "auto"
    quiet: bool = False


def plain_options(words: Sequence[str]) -> FormatOptions | None:
    """The options that ``words`` say, where these need no parser: paths, flags, and ``--stdin-filename``; else None."""
    flags: set[str] = set()
    paths: list[str] = []
    name: str | None = None
    rest = iter(words)
    for word in rest:
        if word in ("--check", "--diff", "-q", "--quiet"):
            flags.add(word)
        elif word == "--stdin-filename":
            name = next(rest, None)
            if name is None:
                return None
        elif word == "-" or not word.startswith("-"):
            paths.append(word)
        else:
            return None
    quiet = not flags.isdisjoint(("-q", "--quiet"))
    return FormatOptions(tuple(paths), "--check" in flags, "--diff" in flags, stdin_filename=name, quiet=quiet)


def run_format(given: FormatOptions) -> int:
    """Bring launch files into normal form. Returns the exit status; raises LaunchlintError."""
    return _Run(given).run()


class _Run:
    """One call of the command: what it was asked for, and how many files became what."""

    def __init__(self, given: FormatOptions) -> None:
        self._given = given
        self._entry = EntryOptions(given.paths, workspace=given.workspace, config=given.config, stdin_filename=given.stdin_filename)
        self._style = style_of(self._entry.configuration)
        self._color = given.diff and use_color(given.color)
        self._changed = self._kept = self._failed = 0

    def run(self) -> int:
        name = self._entry.standard_input
        if name is not None:
            data = sys.stdin.buffer.read()
            name = self._entry.called(data)
            if name.endswith(".py"):
                self._fail("standard input is a launch file in Python: format writes XML and YAML; there are formatters for Python")
                return 2
            result = self._format(name, data)
            if result is not None and not (self._given.check or self._given.diff):
                sys.stdout.buffer.write(result)
                sys.stdout.buffer.flush()
        else:
            for file in self._files():
                self._format_file(file)
            if not self._given.quiet:
                tell(self._summary())
        if self._failed:
            return 2
        return int(self._changed > 0 and (self._given.check or self._given.diff))

    def _files(self) -> list[str]:
        """The launch files that are asked for, without those in Python, and what nobody named and is none."""
        from launchlint.workspace.discovery import discover

        entry, configuration = self._entry, self._entry.configuration
        found = discover(entry.paths, configuration.exclude, configuration.directory)
        files = [file for file in found if not file.endswith(".py")]
        left = [file for file in found if file.endswith(".py")]
        if left and not self._given.quiet:
            named = f"{len(left)} launch files in Python such as {left[0]}" if len(left) > 1 else f"the launch file {left[0]}"
            tell(f"left out {named}: format writes XML and YAML; there are formatters for Python")
        if entry.named.issuperset(map(os.path.abspath, files)):
            return files
        from launchlint.check.options import EntryRequest

        kept, notices = leave_others_out(entry, [EntryRequest(file, file) for file in files], self._session)
        if not self._given.quiet:
            for notice in notices:
                tell(notice)
        return [request.file for request in kept]

    def _format_file(self, file: str) -> None:
        from launchlint.workspace.reading import read_bytes

        try:
            data = read_bytes(file, LARGEST_FILE)
        except OSError as error:
            self._fail(f"{file}: {error.strerror or error}")
            return
        result = self._format(file, data)
        if result is None or result == data or self._given.check or self._given.diff:
            return
        from launchlint.fix.write import write_back
        from launchlint.workspace.repository import repository_root

        try:
            write_back(file, data, result, repository_root(file))
        except UsageError as error:
            self._changed -= 1
            self._fail(str(error))
        else:
            self._say(f"formatted {file}")

    def _format(self, file: str, data: bytes) -> bytes | None:
        """The file in normal form, counted and, where asked for, shown; None where it must be left alone, which is told."""
        result = formatted(data, file, self._style)
        if result.problem is not None or result.refusal:
            self._leave(file, result)
            return None
        if self._entry.configuration.sort_args:
            result = formatted(self._args_first(file, result.data), file, self._style)
        if result.data == data:
            self._kept += 1
            return data
        self._changed += 1
        if self._given.diff and not self._given.quiet:
            self._show_difference(file, data, result.data)
        elif self._given.check:
            self._say(f"would format {file}")
        return result.data

    def _show_difference(self, file: str, before: bytes, after: bytes) -> None:
        from launchlint.report.formats import emit
        from launchlint.report.patch import unified
        from launchlint.syntax.decode import decode

        emit(unified(file, decode(before).text, decode(after).text, color=self._color), sys.stdout)

    def _say(self, line: str) -> None:
        from launchlint.report.escape import visible
        from launchlint.report.formats import emit

        if not self._given.quiet:
            emit(f"{visible(line)}\n", sys.stdout)

    def _fail(self, reason: str) -> None:
        self._failed += 1
        tell(reason)

    def _leave(self, file: str, result: Formatted) -> None:
        """Say why a file is left alone: as the finding of ``check``, where there is one."""
        if result.problem is None:
            self._fail(f"{file} is left as it is: {result.refusal}")
            return
        from launchlint.check.file import tell as findings_of
        from launchlint.report.concise import headline
        from launchlint.report.formats import emit
        from launchlint.rules.registry import rule_of

        self._failed += 1
        for finding in findings_of(result.problem, None, frozenset((rule_of(type(result.problem)),))):
            emit(f"{headline(finding)}\n", sys.stderr)

    def _summary(self) -> str:
        would = "would be " if self._given.check or self._given.diff else ""
        parts = [f"{_files(self._changed)} {would}formatted"] if self._changed else []
        parts += [f"{_files(self._kept)} in normal form already"] if self._kept else []
        parts += [f"{_files(self._failed)} left alone"] if self._failed else []
        return ", ".join(parts) or "no launch files to format"

    def _args_first(self, file: str, data: bytes) -> bytes:
        """The file with the args of each block before all else in it, where that changes nothing."""
        from launchlint.dialects.door import dialect_of
        from launchlint.fix.format.ordering import args_first
        from launchlint.model import ROS1

        session = self._session.with_text(file, data)
        dialect = dialect_of(session, file)
        if dialect.name == ROS1:
            return args_first(data, lambda before, after: self._guard.refusal(file, before, after))
        from launchlint.export.ros2.reordering import refusal
        from launchlint.fix.format.formatting import is_yaml

        def refused(before: bytes, after: bytes) -> str:
            return refusal(self._session, file, before, after)

        if not is_yaml(file):
            return args_first(data, refused)
        from launchlint.fix.format.yaml_ordering import moves

        return args_first(data, refused, moves)

    @cached_property
    def _session(self) -> Session:
        from launchlint.evaluate.session import Session
        from launchlint.workspace.packages import Packages

        options = self._entry.options()
        packages = Packages(options.workspaces, options.variables, explicit=options.explicit, complete=options.complete)
        return Session(packages, options.variables, options.root, distro=options.distro)

    @cached_property
    def _guard(self) -> Guard:
        from launchlint.fix.guard import Guard

        return Guard(self._session)


def _files(count: int) -> str:
    return counted(count, "launch file", thousands=",")

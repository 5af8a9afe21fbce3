"""``launchlint probe``: run nodes, record their interfaces, write a library."""

from __future__ import annotations

import os
import sys
import time
from contextlib import contextmanager

import click

from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from typing import Any

    from launchlint.cli.progress import ProgressBar
    from launchlint.probe.journal import Journal
    from launchlint.probe.run import Outcome, Shard


@click.command("probe")
@click.option("-o", "--output", metavar="FILE", help="Where to write the library; with --unknown default: .launchlint/probed.json.")
@click.option("--unknown", "wanted", is_flag=True, help="Probe what the launch files at PATHS start and nobody knows.")
@click.option("--local", is_flag=True, help="Use the ROS of this machine instead of a container. The nodes run unprotected.")
@click.option("--resume", is_flag=True, help="Go on where an earlier run with the same -o was interrupted.")
@click.option("--shard", metavar="I/N", help="Probe only the I-th of N parts; `launchlint library merge` joins them.")
@click.option("--jobs", type=click.IntRange(1, 64), metavar="N", help="Nodes that run at once (default: `jobs` in `limits`, else 2).")
@click.option("--strict", is_flag=True, help="Exit with status 1 where any node could not be run.")
@click.option("-q", "--quiet", is_flag=True, help="Say nothing but errors.")
@click.option("-v", "--verbose", is_flag=True, help="Show all output of the build.")
@click.argument("given", nargs=-1, metavar="CONFIG.yaml | --unknown [PATHS]...")
def command(
    output: str | None,
    wanted: bool,
    local: bool,
    resume: bool,
    shard: str | None,
    jobs: int | None,
    strict: bool,
    quiet: bool,
    verbose: bool,
    given: tuple[str, ...],
) -> int:
    """Run the nodes that CONFIG.yaml names, and record what they publish, subscribe, serve, call and read in a library.

    They run in a container without a network, one after the other beside a recording ROS master; those of ROS 2 each in a domain
    of its own beside an observer. What is known is on disk at once (in FILE.partial.jsonl), so Ctrl-C loses nothing: --resume goes on.

    With --unknown the configuration is made from launch files: the programs that they start and that neither launchlint nor their sources
    tell. It is left in .launchlint/unknown.yaml, and what was probed in .launchlint/probed.json, which every command reads.

    The exit status is 0 where the library was written, 1 where runs or packages are missing from it, 2 where there is none.
    """
    from launchlint.atomic import check_target, write_text
    from launchlint.errors import LibraryError
    from launchlint.library.file import parse
    from launchlint.library.write import canonical
    from launchlint.probe.assemble import assemble
    from launchlint.probe.configuration import load
    from launchlint.probe.journal import Journal
    from launchlint.probe.summary import is_worth_a_failure, summary

    part = _shard(shard) if shard is not None else None
    target = _target(given, wanted=wanted, output=output)
    if target is None:
        return 0
    settings, output = load(target.configuration), target.output
    if jobs is not None:
        settings = settings._replace(limits=settings.limits._replace(jobs=jobs))
    check_target(output, what="the library")
    watcher = _Watcher(quiet, verbose)
    journal = Journal(output, resume=resume)
    if not (quiet or resume) and os.path.exists(journal.path):
        _print([f"an earlier probe did not end ({journal.path}): this one begins anew; to go on with the other, stop it and say --resume"])
    complete = False
    try:
        with _stoppable():
            outcome = _probe(settings, journal, part, watcher, local)
        watcher.clear()
        document = assemble(settings, outcome.records, outcome.notes, outcome.trees, outcome.origins, local=local)
        text = canonical(_with_earlier(document, output) if wanted else document)
        try:
            parse(text.encode("utf-8", "replace"), output)
        except LibraryError as error:  # a fault of launchlint: better no library than one that cannot be read
            raise AssertionError(f"the library would not be valid: {error}") from error
        write_text(output, text, what="the library")
        complete = not outcome.lost
    except KeyboardInterrupt:
        watcher.clear()
        if journal.done:
            kept = f"{counted(len(journal.done), 'program')} {'is' if len(journal.done) == 1 else 'are'} in {journal.path}"
            _print([f"{kept}: the same command with --resume goes on from there"])
        raise
    finally:
        watcher.clear()
        journal.close(complete=complete)
    if not quiet:
        _print(summary(outcome, output))
        _print(target.notices)
    failed = strict and any(record.status == "failed" for record in outcome.records)
    return int(failed or is_worth_a_failure(outcome))


class Target(NamedTuple):
    """The configuration to read, the library to write, and what is to be said in the end."""

    configuration: str
    output: str
    notices: tuple[str, ...] = ()


def _target(given: Sequence[str], *, wanted: bool, output: str | None) -> Target | None:
    """What the command line asks for; None where nothing is unknown."""
    from launchlint.errors import UsageError

    if wanted:
        return _unknown(given, output)
    if len(given) != 1:
        raise UsageError("give one CONFIG.yaml, which says what to probe; or --unknown for what launch files start and nobody knows")
    if output is None:
        raise UsageError("-o is missing: where shall the library be written?")
    return Target(given[0], output)


def _unknown(paths: Sequence[str], output: str | None) -> Target | None:
    """Write the configuration for what nobody knows."""
    from launchlint.atomic import write_text
    from launchlint.check.ahead import read_ahead
    from launchlint.check.entry import EntryChecker
    from launchlint.check.graphs import graphs_of
    from launchlint.check.run import default_directory
    from launchlint.errors import UsageError
    from launchlint.probe.unknown import text_of, unknown
    from launchlint.project.asked import EntryOptions, leave_others_out
    from launchlint.workspace.project_library import PROBED, project_directory

    entry = EntryOptions(tuple(paths))
    requests, overlay = entry.requests()
    checker = EntryChecker(entry.options(everything=True, cache=default_directory()), overlay)
    requests, _ = leave_others_out(entry, requests, checker.session)
    if not requests:
        raise UsageError("there is no launch file here whose nodes could be probed; give one")
    read_ahead(requests, checker, 0, None)
    graphs = [graph for request in requests for graph in graphs_of(checker, request)]
    directory = project_directory(entry.paths[0])
    output = output or os.path.relpath(os.path.join(directory, PROBED))
    configuration = os.path.join(directory, "unknown.yaml")
    found = unknown(graphs, checker.session.packages, directory)
    notices: tuple[str, ...] = ()
    if found.absent:
        listed = ", ".join(found.absent[:10]) + (f" and {len(found.absent) - 10} more" if len(found.absent) > 10 else "")
        notices = (f"not probed, since their packages are not in the workspace: {listed}; name their repositories in a configuration",)
    if found.aside:
        listed = ", ".join(found.aside[:10]) + (f" and {len(found.aside) - 10} more" if len(found.aside) > 10 else "")
        notices = (*notices, f"not probed, since they are of the other version of ROS, which needs another image: {listed}")
    if not found.programs:
        _print(notices or ("every program that these launch files start is known: there is nothing to probe",))
        return None
    os.makedirs(directory, exist_ok=True)
    write_text(configuration, text_of(found, os.path.relpath(output, os.curdir)), what="the configuration")
    many = "1 program" if len(found.programs) == 1 else f"{len(found.programs)} programs"
    _print([f"{os.path.relpath(configuration)}: {many} that nobody knows"])
    return Target(os.path.relpath(configuration), output, notices)


def _with_earlier(document: dict[str, Any], output: str) -> Mapping[str, Any]:
    """A library with what was probed earlier and is not in it: that is known by now, so that nobody asks for it again."""
    from launchlint.library.file import parse, read
    from launchlint.library.merge import Clash, merge_libraries

    if not os.path.exists(output):
        return document
    earlier = dict(parse(read(output), output))
    packages = {}
    for name, package in earlier["packages"].items():
        again = document["packages"].get(name, {})
        packages[name] = {
            key: {program: known for program, known in value.items() if program not in again.get(key, {})}
            if key in ("executables", "nodelets", "components")
            else value
            for key, value in package.items()
        }
    try:
        return merge_libraries([document, {**earlier, "packages": packages}])
    except Clash:  # the messages are others by now: so is all that was probed with them
        return document


def _probe(settings: object, journal: Journal, part: Shard | None, watcher: _Watcher, local: bool) -> Outcome:
    from launchlint.check.run import default_directory
    from launchlint.probe.configuration import ProbeConfiguration
    from launchlint.probe.engine import BuildError
    from launchlint.probe.run import probe_in_container, probe_local

    if not isinstance(settings, ProbeConfiguration):
        raise AssertionError("a probe's configuration was read")
    if local:
        for key in ("repositories", "apt", "pip"):
            if getattr(settings, key):
                watcher.says(f"--local leaves `{key}` aside: nothing is fetched, installed or built on this machine")
        return probe_local(settings, journal, part, watcher)
    try:
        return probe_in_container(settings, journal, part, watcher, os.path.join(default_directory(), "probe"))
    except BuildError as error:
        watcher.clear()
        _print(f"  {line}" for line in error.lines)
        raise


def _shard(text: str) -> Shard:
    from launchlint.errors import UsageError
    from launchlint.probe.run import Shard

    number, slash, count = text.partition("/")
    if not (
        slash and all(each.isascii() and each.isdecimal() and len(each) < 6 for each in (number, count)) and 1 <= int(number) <= int(count)
    ):
        raise UsageError(f"--shard cannot be {text!r}: write I/N, such as 1/4 for the first of four parts")
    return Shard(int(number), int(count))


class _Watcher:
    """Says how far it is, on standard error: lines for what happens before nodes run, then a bar on a terminal."""

    def __init__(self, quiet: bool, verbose: bool) -> None:
        self._quiet = quiet
        self._verbose = verbose
        self._bar: ProgressBar | None = None
        self._last = time.monotonic()

    def says(self, line: str) -> None:
        if not self._quiet and (
            self._verbose or line.startswith(("fetching ", "Step ", "--local ")) or (line.startswith("[") and "] " in line[:12])
        ):
            _print([line])

    def moves(self, done: int, total: int, label: str) -> None:
        from launchlint.cli.progress import ProgressBar

        if self._quiet:
            return
        if sys.stderr.isatty():
            self._bar = self._bar or ProgressBar(total, "nodes")
            self._bar.show(min(done, total), label[:40])
        elif time.monotonic() - self._last > 30:  # a log wants a sign of life, not a line for each node
            self._last = time.monotonic()
            _print([f"{done}/{total} nodes"])

    def clear(self) -> None:
        if self._bar is not None:
            self._bar.clear()
            self._bar = None


def _print(lines: Sequence[str] | Iterator[str]) -> None:
    from launchlint.report.escape import visible
    from launchlint.report.formats import emit

    for line in lines:
        emit(visible(line) + "\n", sys.stderr)


@contextmanager
def _stoppable() -> Iterator[None]:
    """SIGTERM, as a job scheduler sends it, is taken as Ctrl-C: what was started is ended, what is known is kept."""
    import signal

    def stop(number: int, frame: object) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGTERM, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)

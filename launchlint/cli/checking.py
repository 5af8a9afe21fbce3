"""What ``launchlint check`` does; without click, which costs more time than checking a file."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from launchlint import __version__
from launchlint.cli.entries import parse_severity, tell, use_color
from launchlint.errors import UsageError
from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted
from launchlint.project.asked import EntryOptions, leave_others_out

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.check.entry import EntryChecker, EntryResult
    from launchlint.check.merge import Outcome
    from launchlint.check.options import Options
    from launchlint.check.run import Progress, ReadingProgress
    from launchlint.finding import Finding, Severity


class CheckOptions(NamedTuple):
    """The options of ``check`` that are not about entries, as written."""

    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    severity: tuple[str, ...] = ()
    formats: tuple[str, ...] = ()
    fail_on: str = "error"
    exit_zero: bool = False
    baseline: str | None = None
    write_baseline: str | None = None
    base: str | None = None
    statistics: bool = False
    jobs: int = 0
    no_cache: bool = False
    color: str = "auto"
    quiet: bool = False
    verbose: bool = False
    staged: bool = False
    changed: bool = False
    fix: bool = False
    unsafe_fixes: bool = False
    diff: bool = False


def run_check(entry: EntryOptions, given: CheckOptions) -> int:
    """Check the entry files and report. Returns the exit status; raises LaunchlintError."""
    from launchlint.check.run import default_directory
    from launchlint.cli.output import check_outputs

    # Whatever is wrong with the options is told before any work is done.
    threshold = parse_severity(given.fail_on, "--fail-on")
    _only_jsonl_with_entries(entry, given)
    _no_fixes_there(entry, given)
    check_outputs(given.formats, given.write_baseline)
    changed = _changed(entry, given)
    directory = None if given.no_cache else default_directory()
    options = entry.options(select=given.select, ignore=given.ignore, severity=given.severity, cache=directory)
    if not given.staged or not options.extract:
        return _check(entry, given, options, directory, threshold, changed)
    from launchlint.check.staged import with_staged_sources

    with with_staged_sources(options) as options:
        return _check(entry, given, options, directory, threshold, changed)


def _check(
    entry: EntryOptions,
    given: CheckOptions,
    options: Options,
    directory: str | None,
    threshold: Severity,
    changed: frozenset[str] | None,
) -> int:
    from launchlint.check.entry import EntryChecker
    from launchlint.check.merge import merge
    from launchlint.check.run import check_entries, uses_cache
    from launchlint.cli.output import Request, entry_lines, report
    from launchlint.project.selection import per_file_ignores

    per_file = per_file_ignores(entry.configuration, options.root)
    known = None
    baseline = given.baseline
    if baseline is None and entry.configuration.baseline is not None:
        baseline = os.path.relpath(entry.configuration.baseline)
    if baseline is not None and (given.write_baseline is None or os.path.exists(baseline)):
        from launchlint.baseline import load

        known = load(baseline)
    requests, overlay = entry.requests()
    checker = EntryChecker(options, overlay)
    if options.library:
        _ = checker.library  # an unusable one is told before any work is done
    if directory is not None and uses_cache(requests, checker):
        from launchlint.check.cache import remember

        remember(directory, checker)
    requests, notices = leave_others_out(entry, requests, checker.session)
    results: list[EntryResult] = []
    outcome: Outcome | None = None
    with _shown(len(requests), options, given) as (progress, reading):
        if _asks_for_outcome_only(entry, given):
            from launchlint.check.whole import check_whole

            asked = entry.paths
            outcome = check_whole(requests, checker, per_file, given.jobs, directory, asked=asked, progress=progress, reading=reading)
        else:
            results = check_entries(requests, checker, jobs=given.jobs, cache_directory=directory, progress=progress, reading=reading)
        if given.base is not None:
            from launchlint.check.losses import with_losses

            results = with_losses(results, checker, given.base)
    if not given.quiet:
        for notice in notices:
            tell(notice)
    shown = Request(
        given.formats or ("text",),
        threshold,
        use_color(given.color),
        given.verbose,
        given.quiet,
        given.statistics,
        given.exit_zero,
        __version__,
        options.root,
        verdicts=not given.select,
    )
    if entry.entries is not None:
        return entry_lines(results, options, checker.packages, per_file, shown)

    def told(outcome: Outcome) -> Outcome:
        """``outcome`` without what nobody wants to hear of."""
        if known is not None:
            from launchlint.project.known import without_known

            outcome = without_known(outcome, known)
        if changed is not None:
            outcome = outcome._replace(findings=tuple(finding for finding in outcome.findings if concerns(finding, changed)))
        return outcome

    if _fixes(given):
        from launchlint.cli.fixing import Fixer

        fixer = Fixer(entry, checker, results, per_file, told, only=changed, unsafe=given.unsafe_fixes, quiet=given.quiet)
        if given.diff:
            return fixer.show(color=shown.color)
        if entry.standard_input is not None:
            return fixer.print_text(shown, notices)
        if fixer.write():
            checker = EntryChecker(options, overlay)
            results = check_entries(requests, checker, jobs=given.jobs, cache_directory=directory)
        outcome = told(merge(results, options, checker.packages, per_file, asked=entry.paths))
        _keep(checker)
        return max(report(outcome, shown, notices), 2 if fixer.failed else 0)
    if outcome is None:
        outcome = merge(results, options, checker.packages, per_file, asked=entry.paths)
    _keep(checker)
    if given.write_baseline is not None:
        return record(outcome, given.write_baseline, quiet=given.quiet)
    return report(told(outcome), shown, notices)


def _fixes(given: CheckOptions) -> bool:
    return given.fix or given.unsafe_fixes or given.diff


def _asks_for_outcome_only(entry: EntryOptions, given: CheckOptions) -> bool:
    """Whether nobody needs the results of single entry files."""
    return entry.entries is None and given.base is None and not _fixes(given)


@contextmanager
def _shown(count: int, options: Options, given: CheckOptions) -> Iterator[tuple[Progress | None, ReadingProgress | None]]:
    """What shows people how far a check of ``count`` entry files is, and the reading of sources, where somebody looks on."""
    bar = reading = None
    if not given.quiet and sys.stderr.isatty():
        from launchlint.cli.progress import LateBar, ProgressBar

        reading = LateBar("programs read") if options.extract else None
        bar = ProgressBar(count) if count > 1 else None
    try:
        yield None if bar is None else bar.show, None if reading is None else reading.show
    finally:
        for each in (bar, reading):
            if each is not None:
                each.clear()


def _keep(checker: EntryChecker) -> None:
    """Keep what was found of files for the next run."""
    if checker.packages.held is not None:
        checker.packages.held.keep()


def _changed(entry: EntryOptions, given: CheckOptions) -> frozenset[str] | None:
    """With --changed the files that are given, absolute; everything in the repository becomes what is checked."""
    if (given.staged or given.changed) and (entry.standard_input is not None or entry.entries is not None):
        raise UsageError("--staged and --changed are about files of a git repository; they go with neither standard input nor --entries")
    entry.staged = given.staged
    if not given.changed:
        return None
    if given.write_baseline is not None:
        raise UsageError("--write-baseline records all findings; leave --changed out")
    return frozenset(os.path.realpath(path) for path in entry.take_all_of_repository())


def concerns(finding: Finding, files: frozenset[str]) -> bool:
    """Whether a finding has its place, another place that belongs to it, or an include on the way to it in one of ``files``."""
    places = (finding.location, *(related.location for related in finding.related), *finding.chain)
    return any(os.path.realpath(place.path) in files for place in places)


def _only_jsonl_with_entries(entry: EntryOptions, given: CheckOptions) -> None:
    others = given.baseline or given.write_baseline or given.statistics
    if entry.entries is not None and (others or any(each.partition(":")[0] != "jsonl" for each in given.formats)):
        raise UsageError("--entries judges each entry by itself and prints one line of JSON for it: it goes with --format jsonl only")


def _no_fixes_there(entry: EntryOptions, given: CheckOptions) -> None:
    """Fixes are made in files as they are on disk (or on standard input), of what is found in them now."""
    if not _fixes(given):
        return
    option = "--diff" if given.diff else "--fix" if given.fix else "--unsafe-fixes"
    if entry.entries is not None:
        raise UsageError(f"{option} changes launch files where they are; --entries judges texts as if they stood elsewhere")
    if given.staged:
        raise UsageError(f"{option} changes files on disk, not what is staged of them; leave --staged out")
    if given.write_baseline is not None:
        raise UsageError(f"--write-baseline records findings as they are; leave {option} out")
    if given.base is not None:
        raise UsageError(f"{option} repairs files, --base compares revisions; check twice")


def record(outcome: Outcome, file: str, *, quiet: bool) -> int:
    """Write all findings to the baseline ``file``. Returns the exit status."""
    from launchlint.baseline import write
    from launchlint.check.file import INTERNAL_ERROR

    findings = [finding for finding in outcome.findings if finding.rule != INTERNAL_ERROR]
    write(file, findings)
    if not quiet:
        number = counted(len(findings), "finding")
        tell(f"wrote {number} to {file}; --baseline {file} leaves them out from now on")
    return 2 if outcome.crashed else 0

"""A whole run: what a change concerns is worked out, and what is told of the other entry files is taken from an earlier run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.gathered import AtFile, Member
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.merge import Outcome, Seen, is_part, merge, overview, parts, told, without
from launchlint.check.options import EntryRequest
from launchlint.check.run import Progress, ReadingProgress, check_entries, check_missing, uses_cache
from launchlint.garbage import let_go
from launchlint.workspace.looking import watched

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.check.groups import Groups


def check_whole(
    requests: Sequence[EntryRequest],
    checker: EntryChecker,
    per_file: PerFileIgnores,
    jobs: int = 0,
    cache_directory: str | None = None,
    *,
    asked: tuple[str, ...] = (),
    progress: Progress | None = None,
    reading: ReadingProgress | None = None,
) -> Outcome:
    """What :func:`~launchlint.check.merge.merge` makes of what :func:`~launchlint.check.run.check_entries` gives."""
    options, packages = checker.options, checker.packages
    if cache_directory is None or not uses_cache(requests, checker):
        results = check_entries(requests, checker, jobs=jobs, progress=progress, reading=reading)
        return merge(results, options, packages, per_file, asked=asked)
    from launchlint.check.cache import Cache
    from launchlint.check.groups import Groups
    from launchlint.check.same import SameRun

    checker.remember = True
    cache = Cache(cache_directory, checker)
    try:
        same = SameRun(cache, requests, asked, options, per_file)
        before = same.outcome()
        if before is not None:
            return before
        packages.kept = packages.colcon.kept = cache.kept_answer
        groups = Groups(cache, requests, asked)
        results = check_missing(groups.unknown, checker, cache, jobs, progress, reading)
        before = same.told_again(groups, results)
        if before is not None:
            return before
        files = None
        if groups.read():
            members, led_to = _members(groups, results)
            files = groups.files(results, members, led_to)
        if files is None:
            groups.forget()
            results = check_missing(requests, checker, cache, jobs, progress, reading)
            members, led_to = _members(groups, results)
            files = groups.files(results, members, led_to) or {}
        hangs = groups.keep(members, files, led_to)
        outcome, looked = watched(lambda: _told(members, led_to, files, checker, per_file, asked))
        if hangs is not None:
            cache.store(())  # what was answered meanwhile
            same.keep(outcome, hangs, looked, groups)
        return outcome
    finally:
        cache.close()
        let_go()


def _told(
    members: Sequence[Member],
    led_to: frozenset[str],
    files: Mapping[str, AtFile],
    checker: EntryChecker,
    per_file: PerFileIgnores,
    asked: tuple[str, ...],
) -> Outcome:
    """What is told of a run."""
    summaries = tuple(member.summary for member in members)
    whole = overview(summaries, checker.options, checker.packages, asked)
    standing = [member.standing for member in members if not is_part(member.summary, led_to)]
    seen = Seen(files, without(summaries, led_to), frozenset(summary.path for summary in summaries), standing)
    return told(seen, checker.options, checker.packages, per_file, asked, whole.findings)


def _members(groups: Groups, results: Sequence[EntryResult]) -> tuple[list[Member], frozenset[str]]:
    """What is needed of each entry file, and the paths of those that are parts of others."""
    members = groups.members(results)
    return members, parts([member.summary for member in members])

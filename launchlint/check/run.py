"""Check many entry files: in this process or in several, from the cache where nothing has changed."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence

from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.options import EntryRequest, Options

POOL_PAYS = 150
"""Entry files from which several processes are faster than one: starting them costs about as much as checking this many."""
CACHE_PAYS = 20
"""Entry files from which the cache is used: looking at the workspaces costs about as much as checking this many."""
BATCH = 40
"""Entry files given to a worker at a time: neighbours, since they share includes."""

Progress = Callable[[int], None]


def check_entries(
    requests: Sequence[EntryRequest],
    checker: EntryChecker,
    *,
    jobs: int = 0,
    cache_directory: str | None = None,
    progress: Progress | None = None,
) -> list[EntryResult]:
    """The result of each request, in order: the same for any number of ``jobs`` (0: as many as pay) and with or without a cache.

    ``progress`` is called with the number of entry files done.
    """
    if cache_directory is None or len(requests) < CACHE_PAYS or checker.session.overlay:
        return _compute(requests, checker, jobs, progress)
    from launchlint.check.cache import Cache

    cache = Cache(cache_directory, checker.options)
    try:
        known = cache.look_up(requests, checker.session)
        missing = [request for request, result in zip(requests, known) if result is None]
        done = len(requests) - len(missing)
        computed = _compute(missing, checker, jobs, None if progress is None else lambda count: progress(done + count))
        cache.store(computed, checker.session)
        fresh = iter(computed)
        return [next(fresh) if result is None else result for result in known]
    finally:
        cache.close()


def _compute(requests: Sequence[EntryRequest], checker: EntryChecker, jobs: int, progress: Progress | None) -> list[EntryResult]:
    workers = min(jobs or os.cpu_count() or 1, -(-len(requests) // BATCH))
    if workers > 1 and (jobs > 1 or len(requests) >= POOL_PAYS):
        return _in_pool(requests, checker, workers, progress)
    results: list[EntryResult] = []
    for request in requests:
        results.append(checker.check(request))
        if progress is not None:
            progress(len(results))
    return results


def _in_pool(requests: Sequence[EntryRequest], checker: EntryChecker, workers: int, progress: Progress | None) -> list[EntryResult]:
    import multiprocessing

    results: list[EntryResult] = []
    with multiprocessing.get_context().Pool(workers, _start, (checker.options, checker.session.overlay)) as pool:
        for batch in pool.imap(_work, _batches(requests)):
            results.extend(batch)
            if progress is not None:
                progress(len(results))
    return results


def _batches(requests: Sequence[EntryRequest]) -> Iterator[list[EntryRequest]]:
    for start in range(0, len(requests), BATCH):
        yield list(requests[start : start + BATCH])


_worker: list[EntryChecker] = []


def _start(options: Options, overlay: Mapping[str, bytes]) -> None:
    """In a new worker: what it needs for all its batches. Ctrl-C is for the parent, which ends the workers."""
    import signal

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _worker[:] = [EntryChecker(options, overlay)]


def _work(batch: list[EntryRequest]) -> list[EntryResult]:
    return [_worker[0].check(request) for request in batch]


def default_directory(variables: Mapping[str, str]) -> str:
    """Where results are kept: ``$XDG_CACHE_HOME/launchlint`` or ``~/.cache/launchlint``."""
    return os.path.join(variables.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache"), "launchlint")

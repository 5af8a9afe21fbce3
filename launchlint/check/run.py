"""Check many entry files: in this process or in several, from the cache where nothing has changed."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from functools import partial

from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.options import EntryRequest, Options

POOL_PAYS = 400
"""Entry files from which several processes are faster than one: starting them costs about as much as checking this many."""
CACHE_PAYS = 20
"""Entry files from which the cache is used: looking at the workspaces costs about as much as checking this many."""
BATCH = 40
"""Entry files given to a worker at a time: neighbours, since they share includes."""

Progress = Callable[[int], None]
ReadingProgress = Callable[[int, int], None]
TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeVar

    from launchlint.check.cache import Cache

    Checker = TypeVar("Checker", bound=EntryChecker)
    Result = TypeVar("Result")


def check_entries(
    requests: Sequence[EntryRequest],
    checker: EntryChecker,
    *,
    jobs: int = 0,
    cache_directory: str | None = None,
    progress: Progress | None = None,
    reading: ReadingProgress | None = None,
) -> list[EntryResult]:
    """The result of each request, in order: the same for any number of ``jobs`` (0: as many as pay) and with or without a cache.

    ``progress`` is called with the number of entry files done, ``reading`` with that of the programs read from source, and of all these.
    """
    if cache_directory is None or not uses_cache(requests, checker):
        _read_ahead(requests, checker, jobs, reading)
        return compute(requests, checker, EntryChecker.check, jobs, progress)
    from launchlint.check.cache import Cache

    checker.remember = True
    cache = Cache(cache_directory, checker)
    try:
        return check_missing(requests, checker, cache, jobs, progress, reading)
    finally:
        cache.close()


def check_missing(
    requests: Sequence[EntryRequest],
    checker: EntryChecker,
    cache: Cache,
    jobs: int,
    progress: Progress | None,
    reading: ReadingProgress | None,
) -> list[EntryResult]:
    """The result of each request, in order, computed and stored where the cache has none."""
    known = cache.look_up(requests)
    missing = [request for request, result in zip(requests, known, strict=True) if result is None]
    done = len(requests) - len(missing)
    _read_ahead(missing, checker, jobs, reading)
    computed = compute(missing, checker, EntryChecker.check, jobs, None if progress is None else lambda count: progress(done + count))
    cache.store(computed)
    fresh = iter(computed)
    return [next(fresh) if result is None else result for result in known]


def uses_cache(requests: Sequence[EntryRequest], checker: EntryChecker) -> bool:
    """Whether results of these requests are kept, where there is a directory for them."""
    return len(requests) >= CACHE_PAYS and not checker.session.overlay and checker.options.staged is None


def _read_ahead(requests: Sequence[EntryRequest], checker: EntryChecker, jobs: int, progress: ReadingProgress | None) -> None:
    if checker.options.extract and checker.graph_rules:
        from launchlint.check.ahead import read_ahead

        read_ahead(requests, checker, jobs, progress)


def compute(
    requests: Sequence[EntryRequest],
    checker: Checker,
    work: Callable[[Checker, EntryRequest], Result],
    jobs: int,
    progress: Progress | None,
) -> list[Result]:
    """What ``work``, a method of ``checker``, makes of each request, in order; in several processes where that pays or is asked for."""
    workers = min(jobs or os.cpu_count() or 1, -(-len(requests) // BATCH))
    results: list[Result] = []
    if workers > 1 and (jobs > 1 or len(requests) >= POOL_PAYS):
        results = _in_pool(requests, checker, work, workers, progress)
    for request in requests[len(results) :]:
        results.append(work(checker, request))
        if progress is not None:
            progress(len(results))
    return results


def _in_pool(
    requests: Sequence[EntryRequest],
    checker: Checker,
    work: Callable[[Checker, EntryRequest], Result],
    workers: int,
    progress: Progress | None,
) -> list[Result]:
    """The results of several processes, in order; only the first ones where processes cannot be had, or one of them was killed."""
    from launchlint.pool import in_pool

    results: list[Result] = []
    try:
        with _shared_sources(checker) as options:
            given = (type(checker), options, checker.session.overlay, checker.remember)
            with closing(in_pool(partial(_work, work), _batches(requests), workers, _start, given)) as batches:
                for batch in batches:
                    results.extend(batch)
                    if progress is not None:
                        progress(len(results))
    except OSError:
        return results
    return results


@contextmanager
def _shared_sources(checker: EntryChecker) -> Iterator[Options]:
    """The options for workers that tell each other what they read of sources: without a cache, through a directory of their own."""
    options = checker.options
    if checker.own is None or options.sources_cache is not None:
        yield options
        return
    import tempfile

    with tempfile.TemporaryDirectory(prefix="launchlint-") as directory:
        for each in checker.own.all:
            each.keep_in(directory)
        yield options._replace(sources_cache=directory)


def _batches(requests: Sequence[EntryRequest]) -> Iterator[list[EntryRequest]]:
    for start in range(0, len(requests), BATCH):
        yield list(requests[start : start + BATCH])


def _start(make: type[Checker], options: Options, overlay: Mapping[str, bytes], remember: bool) -> Checker:
    """In a new worker: what it needs for all its batches."""
    return make(options, overlay, remember=remember)


def _work(work: Callable[[Checker, EntryRequest], Result], checker: Checker, batch: list[EntryRequest]) -> list[Result]:
    return [work(checker, request) for request in batch]


def default_directory() -> str:
    """Where results are kept: ``$XDG_CACHE_HOME/launchlint`` or ``~/.cache/launchlint``.

    Only the environment of this process counts: ``env`` in the configuration of a checked repository must not move it.
    """
    chosen = os.environ.get("XDG_CACHE_HOME", "")
    return os.path.join(chosen if os.path.isabs(chosen) else os.path.join(os.path.expanduser("~"), ".cache"), "launchlint")

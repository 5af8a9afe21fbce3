"""Reading the sources of the nodes that launch files start before these are checked: all at once, in several processes where that pays.

What is not seen here (a node whose package or type comes from an arg, or which only an included file elsewhere starts) is read when it is
asked for.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator, Sequence

from launchlint.check.entry import EntryChecker
from launchlint.check.options import EntryRequest, Options

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.knowledge.entry import Key, Known
    from launchlint.knowledge.own import OwnSources

Progress = Callable[[int, int], None]
PARALLEL_FROM = 8
"""Programs from which a second process pays."""
BATCH = 8
"""Programs of one package that one process reads at a time: they share files."""
_NODE = re.compile(rb"<(?:node|test)\s[^<>]*>")
_WORD = re.compile(rb"\b(pkg|type|args)\s*=\s*(?:\"([^\"$]*)\"|'([^'$]*)')")
_LOADS = re.compile(r"\s*(?:load|standalone)\s+(\S+)")


def read_ahead(requests: Iterable[EntryRequest], checker: EntryChecker, jobs: int, progress: Progress | None) -> None:
    """Read what the nodes of these launch files do, where it is not known yet. ``progress`` is told how many programs of how many."""
    own = checker.own
    if own is None:
        return
    found = dict.fromkeys(key for request in requests for key in _started(checker.session.read(request.file).data or b"", checker))
    missing = sorted(key for key in found if checker.library.wants_sources(*key) and not own.digest(key))
    workers = min(jobs or os.cpu_count() or 1, len(missing))
    done = 0
    if workers > 1 and len(missing) >= PARALLEL_FROM:
        from launchlint.pool import in_pool

        for read in in_pool(_read, _batches(missing), workers, _begin, (checker.options,)):
            for key, known in read:
                own.take(key, known)
            done += len(read)
            if progress is not None:
                progress(done, len(missing))
    for key in missing[done:]:
        own.program(*key)
        done += 1
        if progress is not None:
            progress(done, len(missing))


def _started(data: bytes, checker: EntryChecker) -> Iterator[Key]:
    for tag in _NODE.findall(data):
        words = {name.decode(): (double or single).decode("utf-8", "replace") for name, double, single in _WORD.findall(tag)}
        package, executable = words.get("pkg", ""), words.get("type", "")
        if (package, executable) == ("nodelet", "nodelet"):
            loads = _LOADS.match(words.get("args", ""))
            for owner in () if loads is None else checker.library.packages_of_class(loads[1]):
                yield owner, "nodelets", loads[1] if loads else ""
        elif package and executable:
            yield package, "executables", executable


def _batches(keys: Sequence[Key]) -> Iterator[list[Key]]:
    batch: list[Key] = []
    for key in keys:
        if batch and (batch[0][0] != key[0] or len(batch) == BATCH):
            yield batch
            batch = []
        batch.append(key)
    if batch:
        yield batch


def _begin(options: Options) -> OwnSources:
    """In a new worker: what it needs for all its programs."""
    own = EntryChecker(options).own
    assert own is not None
    return own


def _read(own: OwnSources, keys: Sequence[Key]) -> list[tuple[Key, Known]]:
    read = ((key, own.known(key)) for key in keys)
    return [(key, known) for key, known in read if known is not None]

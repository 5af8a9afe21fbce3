"""Reading the sources of the nodes that launch files start before these are checked: all at once, in several processes where that pays.

What is not seen here (a node whose package or type comes from an arg, or which only an included file elsewhere starts) is read when it is
asked for.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from launchlint.check.entry import EntryChecker
from launchlint.check.options import EntryRequest, Options
from launchlint.late import late
from launchlint.model import ROS1, ROS2

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.knowledge.entry import Key, Known
    from launchlint.knowledge.own import OwnSources
    from launchlint.library.lookup import Library

Progress = Callable[[int, int], None]
PARALLEL_FROM = 8
"""Programs from which a second process pays."""
BATCH = 8
"""Programs of one package that one process reads at a time: they share files."""
_NODE = late(rb"<(?:node|test)\s[^<>]*>")
_WORD = late(rb"\b(pkg|type|args)\s*=\s*(?:\"([^\"$]*)\"|'([^'$]*)')")
_PAIR = late(r"\b(pkg|package|exec|executable|node_executable|plugin)[\"']?\s*[=:]\s*[\"']?([\w.:+-]{1,200})")
_NEAR = 400
"""Characters between the two that are about one node."""
_LOADS = late(r"\s*(?:load|standalone)\s+(\S+)")


def read_ahead(requests: Iterable[EntryRequest], checker: EntryChecker, jobs: int, progress: Progress | None) -> None:
    """Read what the nodes of these launch files do, where it is not known yet. ``progress`` is told how many programs of how many."""
    own = checker.own
    if own is None:
        return
    found: dict[tuple[str, Key], None] = {}
    for request in requests:
        found.update(dict.fromkeys(_started(checker.session.read(request.file).data or b"", checker)))
    libraries = {ROS1: checker.library} if all(middleware == ROS1 for middleware, _ in found) else _libraries(checker)
    missing = sorted(
        (middleware, key) for middleware, key in found if libraries[middleware].wants_sources(*key) and not own.of(middleware).digest(key)
    )
    workers = min(jobs or os.cpu_count() or 1, len(missing))
    done = 0
    if workers > 1 and len(missing) >= PARALLEL_FROM:
        from launchlint.pool import in_pool

        for middleware, read in in_pool(_read, _batches(missing), workers, _begin, (checker.options,)):
            for key, known in read:
                own.of(middleware).take(key, known)
            done += len(read)
            if progress is not None:
                progress(done, len(missing))
    for middleware, key in missing[done:]:
        own.of(middleware).program(*key)
        done += 1
        if progress is not None:
            progress(done, len(missing))


def _libraries(checker: EntryChecker) -> Mapping[str, Library]:
    return {ROS1: checker.library, ROS2: checker.library.ros2}


def _started(data: bytes, checker: EntryChecker) -> Iterator[tuple[str, Key]]:
    for tag in _NODE.findall(data):
        words = {name.decode(): (double or single).decode("utf-8", "replace") for name, double, single in _WORD.findall(tag)}
        package, executable = words.get("pkg", ""), words.get("type", "")
        if (package, executable) == ("nodelet", "nodelet"):
            loads = _LOADS.match(words.get("args", ""))
            for owner in () if loads is None else checker.library.packages_of_class(loads[1]):
                yield ROS1, (owner, "nodelets", loads[1] if loads else "")
        elif package and executable:
            yield ROS1, (package, "executables", executable)
    yield from _started_in_ros2(data)


def _started_in_ros2(data: bytes) -> Iterator[tuple[str, Key]]:
    """Packages and what is started of them, in XML, YAML or Python: the two stand side by side."""
    package, program = None, None
    if b"exec" not in data and b"plugin" not in data:
        return
    for found in _PAIR.finditer(data.decode("utf-8", "replace")):
        if found[1] in ("pkg", "package"):
            package = found
        else:
            program = found
        if package is None or program is None or abs(package.start() - program.start()) > _NEAR:
            continue
        table = "components" if program[1] == "plugin" else "executables"
        yield ROS2, (package[2], table, program[2])
        package = program = None


def _batches(keys: Sequence[tuple[str, Key]]) -> Iterator[tuple[str, list[Key]]]:
    batch: list[Key] = []
    before = ""
    for middleware, key in keys:
        if batch and ((before, batch[0][0]) != (middleware, key[0]) or len(batch) == BATCH):
            yield before, batch
            batch = []
        before = middleware
        batch.append(key)
    if batch:
        yield before, batch


def _begin(options: Options) -> OwnSources:
    """In a new worker: what it needs for all its programs."""
    own = EntryChecker(options).own
    assert own is not None
    return own


def _read(own: OwnSources, batch: tuple[str, Sequence[Key]]) -> tuple[str, list[tuple[Key, Known]]]:
    middleware, keys = batch
    read = ((key, own.of(middleware).known(key)) for key in keys)
    return middleware, [(key, known) for key, known in read if known is not None]

"""What ``launchlint graph diff`` compares: two files, or the launch files of two revisions."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence

from launchlint.check.entry import EntryChecker
from launchlint.check.graphs import graphs_of, revision
from launchlint.check.options import EntryRequest, Options
from launchlint.check.run import default_directory
from launchlint.cli.entries import EntryOptions
from launchlint.errors import UsageError
from launchlint.graph.difference import Difference, difference
from launchlint.graph.selection import Selection, select
from launchlint.graph.topology import EMPTY, Topology, topology


def compared(entry: EntryOptions, base: str, head: str | None, chosen: Selection) -> list[Difference]:
    """What changed from ``base`` to ``head`` (None: the working tree), for each launch file in which something did.

    Raises:
        UsageError: there is no such file or revision.
    """
    from launchlint.workspace.repository import repository_root
    from launchlint.workspace.revision import is_revision

    if entry.standard_input is not None or entry.entries is not None:
        raise UsageError("graph diff compares files or revisions; it takes neither standard input nor --entries")
    if head is not None and not is_revision(repository_root(os.path.realpath(os.curdir)), head):
        if os.path.isfile(base) and os.path.isfile(head):
            return _of_files(entry, base, head, chosen)
        if os.path.lexists(head):
            entry.paths, head = (head, *(path for path in entry.paths if path != os.curdir)), None
    return _of_revisions(entry, base, head, chosen)


def _of_files(entry: EntryOptions, base: str, head: str, chosen: Selection) -> list[Difference]:
    sides = []
    for file in (base, head):
        entry.paths = (file,)  # its own workspace: the files may lie in two copies of one repository
        checker = EntryChecker(entry.options(everything=True, cache=default_directory()))
        request = EntryRequest(file, file, entry.arguments)
        sides.append(select(topology(graphs_of(checker, request, every_configuration=True)), chosen))
    found = difference(*sides)
    return [] if found.is_empty else [found]


def _of_revisions(entry: EntryOptions, base: str, head: str | None, chosen: Selection) -> list[Difference]:
    options = entry.options(everything=True, cache=default_directory())
    absent = dict.fromkeys(entry.paths)
    before, old_entries = _side(entry, options, base, absent)
    after, new_entries = _side(entry, options, head, absent)
    for path in absent:
        raise UsageError(f"{path}: there is no such file or directory, neither before nor after")
    named = {os.path.relpath(path, os.path.realpath(os.curdir)) for path in entry.named}
    pairs = [(path, path) for path in {*old_entries, *new_entries, *(named & {*before, *after})}]
    changes = []
    for old, new in _with_renamed(pairs, before, after):
        sides = [select(side[path], chosen) if path in side else EMPTY for side, path in ((before, old), (after, new))]
        if not sides[0].entry:
            sides[0] = EMPTY._replace(entry=sides[1].entry)
        elif not sides[1].entry:
            sides[1] = EMPTY._replace(entry=sides[0].entry)
        found = difference(*sides)
        if not found.is_empty:
            changes.append(found)
    return changes


def _side(entry: EntryOptions, options: Options, name: str | None, absent: dict[str, None]) -> tuple[dict[str, Topology], set[str]]:
    """The topology of each launch file at a revision (None: of the working tree), and those files that no other one includes.

    Paths that are there are taken out of ``absent``.
    """
    if name is None:
        here = os.path.realpath(os.curdir)
        return _topologies(EntryChecker(options), entry, absent, os.path.abspath, lambda file: os.path.relpath(file, here))
    with revision(options, name) as at:
        return _topologies(at.checker, entry, absent, at.place, at.back)


def _topologies(
    checker: EntryChecker, entry: EntryOptions, absent: dict[str, None], place: Callable[[str], str], back: Callable[[str], str]
) -> tuple[dict[str, Topology], set[str]]:
    from launchlint.check.dialects import without_ros2

    for path in [each for each in absent if os.path.exists(place(each))]:
        del absent[path]
    requests = entry.requests_below(place, back)
    found: dict[str, Topology] = {}
    included: set[str] = set()
    kept, _ = without_ros2(list(requests.values()), {place(path) for path in entry.named}, checker.session)
    wanted = {request.at for request in kept}
    for path, request in requests.items():
        if request.at in wanted:
            graphs = graphs_of(checker, request, every_configuration=True)
            found[path] = topology(graphs)
            included.update(each.source.path for graph in graphs for each in graph.launch.includes if each.source is not None)
    return found, {path for path, each in found.items() if each.entry not in included}


def _with_renamed(
    pairs: Sequence[tuple[str, str]], before: Mapping[str, Topology], after: Mapping[str, Topology]
) -> Iterator[tuple[str, str]]:
    """``pairs`` of paths before and after, sorted; a file that went and one that came are one pair where they start the same nodes."""
    gone = [path for path, _ in pairs if path not in after]
    come = [path for path, _ in pairs if path not in before]
    renamed: dict[str, str] = {}
    for mark in (_nodes, _last_name):
        left = ([path for path in gone if path not in renamed], [path for path in come if path not in renamed.values()])
        old, new = _unique(left[0], before, mark), _unique(left[1], after, mark)
        renamed.update((old[each], new[each]) for each in sorted(old) if each in new)
    for path, _ in sorted(pairs):
        if path in renamed:
            yield path, renamed[path]
        elif path not in renamed.values():
            yield path, path


def _nodes(path: str, topologies: Mapping[str, Topology]) -> str:
    return "\n".join(f"{node.name} {node.program}" for node in topologies[path].nodes)


def _last_name(path: str, _: Mapping[str, Topology]) -> str:
    return os.path.basename(path)


def _unique(paths: Sequence[str], topologies: Mapping[str, Topology], mark: Callable[[str, Mapping[str, Topology]], str]) -> dict[str, str]:
    found: dict[str, list[str]] = {}
    for path in paths:
        found.setdefault(mark(path, topologies), []).append(path)
    return {key: each[0] for key, each in found.items() if key and len(each) == 1}

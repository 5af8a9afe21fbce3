"""What ``launchlint graph diff`` compares: two files, or the launch files of two revisions."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence

from launchlint.check.entry import EntryChecker
from launchlint.check.graphs import graphs_and_verdict, revision, topology_of
from launchlint.check.options import EntryRequest, Options
from launchlint.check.run import default_directory
from launchlint.errors import UsageError
from launchlint.graph.difference import Difference, difference
from launchlint.graph.selection import Selection, select
from launchlint.graph.topology import EMPTY, Topology, topology
from launchlint.project.asked import EntryOptions

LAUNCH_NAMES = (".launch", ".test", ".xml")
"""Ends of words that are meant as files, even of deleted ones."""
ALIKE = 0.5
"""The share of nodes that two files must have in common so that one is taken for the other under a new name."""
MOST_LOOKED_AT = 10_000
"""Pairs of files that are looked at for that."""


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
        if os.path.lexists(head) or os.sep in head or head.endswith(LAUNCH_NAMES):
            entry.paths, head = (head, *(path for path in entry.paths if path != os.curdir)), None
    return _of_revisions(entry, base, head, chosen)


def _of_files(entry: EntryOptions, base: str, head: str, chosen: Selection) -> list[Difference]:
    sides = []
    for file in (base, head):
        entry.paths = (file,)  # its own workspace: the files may lie in two copies of one repository
        checker = EntryChecker(entry.options(everything=True, cache=default_directory()))
        request = EntryRequest(file, file, entry.arguments)
        sides.append(select(topology_of(checker, request, every_configuration=True), chosen))
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
        return _topologies(EntryChecker(options), entry, absent, _real, lambda file: os.path.relpath(file, here))
    with revision(options, name) as at:
        return _topologies(at.checker, entry, absent, at.place, at.back)


def _real(path: str) -> str:
    """Where a path is, absolute, through links to its directory; a link itself stays what it is."""
    path = os.path.abspath(path)
    return os.path.join(os.path.realpath(os.path.dirname(path)), os.path.basename(path))


def _topologies(
    checker: EntryChecker, entry: EntryOptions, absent: dict[str, None], place: Callable[[str], str], back: Callable[[str], str]
) -> tuple[dict[str, Topology], set[str]]:
    from launchlint.check.dialects import sort_out

    for path in [each for each in absent if os.path.exists(place(each))]:
        del absent[path]
    requests = entry.requests_below(place, back)
    found: dict[str, Topology] = {}
    included: set[str] = set()
    kept = sort_out(list(requests.values()), {place(path) for path in entry.named}, checker.session).kept
    wanted = {request.at for request in kept}
    for path, request in requests.items():
        if request.at in wanted:
            graphs, verdict = graphs_and_verdict(checker, request, every_configuration=True)
            found[path] = topology(graphs)._replace(verdict=verdict)
            included.update(each.source.path for graph in graphs for each in graph.launch.includes if each.source is not None)
    return found, {path for path, each in found.items() if each.entry not in included}


def _with_renamed(
    pairs: Sequence[tuple[str, str]], before: Mapping[str, Topology], after: Mapping[str, Topology]
) -> Iterator[tuple[str, str]]:
    """``pairs`` of paths before and after, sorted; a file that went and one that came are a pair where they mostly start the same."""
    gone = {path: _nodes(before[path]) for path, _ in sorted(pairs) if path not in after}
    come = {path: _nodes(after[path]) for path, _ in sorted(pairs) if path not in before}
    alike: list[tuple[float, bool, str, str]] = []
    if len(gone) * len(come) <= MOST_LOOKED_AT:
        for old, old_nodes in gone.items():
            for new, new_nodes in come.items():
                share = len(old_nodes & new_nodes) / (len(old_nodes | new_nodes) or 1)
                if share >= ALIKE:
                    alike.append((-share, os.path.basename(old) != os.path.basename(new), old, new))
    renamed: dict[str, str] = {}
    taken: set[str] = set()
    for _, _, old, new in sorted(alike):
        if old not in renamed and new not in taken:
            renamed[old] = new
            taken.add(new)
    for path, _ in sorted(pairs):
        if path not in taken:
            yield path, renamed.get(path, path)


def _nodes(topology: Topology) -> frozenset[tuple[str, str]]:
    return frozenset((node.name.rpartition("/")[2], node.program) for node in topology.nodes)

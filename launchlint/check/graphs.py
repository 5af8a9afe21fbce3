"""Connection graphs of entry files, now and at another revision."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager

from launchlint.check.changed import Changed, changed
from launchlint.check.entry import EntryChecker
from launchlint.check.options import EntryRequest, Options
from launchlint.evaluate.assemble import Evaluation
from launchlint.graph.connect import connect
from launchlint.graph.connections import ConnectionGraph
from launchlint.graph.details import details
from launchlint.graph.earlier import Earlier
from launchlint.graph.topology import Topology, topology
from launchlint.verdict import Verdict


def topology_of(checker: EntryChecker, request: EntryRequest, *, every_configuration: bool) -> Topology:
    """What an entry file connects as given, or in every configuration, with the verdict on it and who may be at empty ends."""
    graphs, verdict = graphs_and_verdict(checker, request, every_configuration=every_configuration)
    beside = details(graphs)
    return topology(graphs)._replace(verdict=verdict, doubts=beside.doubts, partly=beside.partly)


def graphs_and_verdict(checker: EntryChecker, request: EntryRequest, *, every_configuration: bool) -> tuple[list[ConnectionGraph], Verdict]:
    """As :func:`graphs_of`, with the verdict on the entry file."""
    evaluations = list(checker.evaluations(request))
    return _graphs(checker, evaluations if every_configuration else evaluations[:1]), checker.verdict(request, evaluations)


def graphs_of(checker: EntryChecker, request: EntryRequest) -> list[ConnectionGraph]:
    """The connection graphs of an entry file, in all configurations that differ."""
    return _graphs(checker, checker.evaluations(request))


def _graphs(checker: EntryChecker, evaluations: Iterable[Evaluation]) -> list[ConnectionGraph]:
    earlier = Earlier()
    return [connect(evaluation.launch, checker.library, earlier) for evaluation in evaluations]


class Revision:
    """A git revision that was put into a directory: the same files at other places.

    ``checker`` checks there as ``options`` say; shown paths are the same as of the working tree. Libraries and the configuration are those
    of today: what is compared is what the launch files start.
    """

    def __init__(self, options: Options, repository: str, directory: str) -> None:
        self._repository = os.path.realpath(repository)
        self._directory = directory
        self._changed: Changed | None = None
        root = self.place(options.root)
        os.makedirs(root, exist_ok=True)
        workspaces = tuple(self.place(workspace) for workspace in options.workspaces)
        self.checker = EntryChecker(options._replace(root=root, workspaces=workspaces, staged=None))

    def place(self, path: str) -> str:
        """Where a file or directory of the working tree is at the revision; absolute. What lies outside the repository stays."""
        path = os.path.abspath(path)
        relative = self._relative(path)
        if relative is None:  # through a link to the repository
            relative = self._relative(os.path.join(os.path.realpath(os.path.dirname(path)), os.path.basename(path)))
        return path if relative is None else os.path.normpath(os.path.join(self._directory, relative))

    def _relative(self, path: str) -> str | None:
        relative = os.path.relpath(path, self._repository)
        return None if relative == os.pardir or relative.startswith(os.pardir + os.sep) else relative

    def back(self, path: str) -> str:
        """The file of the working tree (as people see it) that a file of the revision is."""
        return os.path.relpath(os.path.join(self._repository, os.path.relpath(path, self._directory)), os.path.realpath(os.curdir))

    def at_home(self, text: str) -> str:
        """``text`` with the paths of the working tree in place of those of the revision."""
        return text.replace(self._directory, self._repository)

    def differs(self, root: str, files: Iterable[str]) -> bool:
        """Whether an entry file that reads these launch files (as shown) may start or connect something else than at the revision."""
        if self._changed is None:
            self._changed = changed(self._repository, self._directory)
        connects = self._changed.sources and self.checker.options.extract
        return (
            connects
            or self._changed.others
            or not self._changed.launch_files.isdisjoint(os.path.realpath(os.path.join(root, file)) for file in files)
        )

    def request(self, request: EntryRequest) -> EntryRequest | None:
        """The same entry file at the revision; None where it is not there, or not in the repository."""
        there = self.place(request.at)
        if there == os.path.abspath(request.at) or not os.path.isfile(there):
            return None
        return request._replace(file=there, at=there)


@contextmanager
def revision(options: Options, name: str, start: str = os.curdir) -> Iterator[Revision]:
    """The revision ``name`` of the repository around ``start``, in a temporary directory for as long as the block lasts.

    Raises:
        UsageError: there is no such revision, or no git.
    """
    import tempfile

    from launchlint.workspace.repository import repository_root
    from launchlint.workspace.revision import resolve, unpack

    repository = repository_root(os.path.realpath(start))
    resolve(repository, name)
    with tempfile.TemporaryDirectory(prefix="launchlint-") as directory:
        directory = os.path.realpath(directory)
        unpack(repository, name, directory)
        yield Revision(options, repository, directory)

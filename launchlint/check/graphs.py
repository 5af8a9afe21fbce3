"""Connection graphs of entry files, now and at another revision."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager

from launchlint.check.entry import EntryChecker
from launchlint.check.options import EntryRequest, Options
from launchlint.evaluate.configurations import configurations
from launchlint.evaluate.launch import evaluate
from launchlint.graph.connect import connect
from launchlint.graph.connections import ConnectionGraph
from launchlint.workspace.repository import repository_root
from launchlint.workspace.revision import unpack


def graphs_of(checker: EntryChecker, request: EntryRequest, *, every_configuration: bool) -> list[ConnectionGraph]:
    """The connection graph of an entry file as given; with ``every_configuration`` of all that differ."""
    session = checker.session_for(request)
    session.begin_entry()
    if not every_configuration:
        return [connect(evaluate(session, request.at, request.arguments).launch, checker.library)]
    return [connect(evaluation.launch, checker.library) for evaluation in configurations(session, request.at, request.arguments)]


class Revision:
    """A git revision that was put into a directory: the same files at other places.

    ``checker`` checks there as ``options`` say; shown paths are the same as of the working tree.
    """

    def __init__(self, options: Options, repository: str, directory: str) -> None:
        self._repository = repository
        self._directory = directory
        root = self.place(options.root)
        os.makedirs(root, exist_ok=True)
        workspaces = tuple(self.place(workspace) for workspace in options.workspaces)
        self.checker = EntryChecker(options._replace(root=root, workspaces=workspaces))

    def place(self, path: str) -> str:
        """Where a file or directory of the working tree is at the revision; absolute. What lies outside the repository stays."""
        path = os.path.abspath(path)
        relative = os.path.relpath(path, self._repository)
        outside = relative == os.pardir or relative.startswith(os.pardir + os.sep)
        return path if outside else os.path.normpath(os.path.join(self._directory, relative))

    def back(self, path: str) -> str:
        """The file of the working tree (as people see it) that a file of the revision is."""
        return os.path.relpath(os.path.join(self._repository, os.path.relpath(path, self._directory)))

    def requests(self, requests: Sequence[EntryRequest]) -> Mapping[str, EntryRequest]:
        """The entry files that are there at the revision, by the path they have in the working tree."""
        found: dict[str, EntryRequest] = {}
        for request in requests:
            there = self.place(request.at)
            if os.path.isfile(there):
                found[request.at] = request._replace(file=there, at=there)
        return found


@contextmanager
def revision(options: Options, name: str, start: str = os.curdir) -> Iterator[Revision]:
    """The revision ``name`` of the repository around ``start``, in a temporary directory for as long as the block lasts.

    Raises:
        UsageError: there is no such revision, or no git.
    """
    repository = repository_root(start)
    with tempfile.TemporaryDirectory(prefix="launchlint-") as directory:
        directory = os.path.realpath(directory)
        unpack(repository, name, directory)
        yield Revision(options, repository, directory)

"""A checker that keeps what it saw: the evaluation of each configuration, with its connection graph."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.options import EntryRequest
from launchlint.evaluate.assemble import Evaluation
from launchlint.finding import Finding
from launchlint.named_tuple import NamedTuple
from launchlint.rules.rule import Fine

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.graph.connections import ConnectionGraph
    from launchlint.rules.view import LaunchView


class Configuration(NamedTuple):
    """One configuration of an entry file: what it starts, and what that connects, where it starts anything."""

    evaluation: Evaluation
    graph: ConnectionGraph | None


class Understood(NamedTuple):
    """One entry file: what was found, and every configuration of it, the one that is given first."""

    result: EntryResult
    configurations: tuple[Configuration, ...]


class Watcher(EntryChecker):
    """Checks entry files, and keeps what it evaluated on the way."""

    _seen: list[Configuration]

    _first: Callable[[EntryResult], None] | None = None

    def understand(self, request: EntryRequest, first: Callable[[EntryResult], None] | None = None) -> Understood:
        """All findings of an entry file, and all its configurations. Never raises: a crash becomes a finding.

        ``first`` is called with what the configuration that is given gives, as soon as that is known.
        """
        self._seen = []
        self._first = first
        self.remember = True
        try:
            result = self.check(request)
        finally:
            self._first = None  # what is checked in between, to prove a fix, is told to nobody
        return Understood(result, tuple(self._seen))

    def after_first(self, so_far: Callable[[], EntryResult]) -> None:
        """Tell whoever waits."""
        if self._first is not None:
            self._first(so_far())

    def connected(self, evaluation: Evaluation) -> ConnectionGraph:
        """The connection graph, kept."""
        graph = super().connected(evaluation)
        self._seen[-1] = Configuration(evaluation, graph)
        return graph

    def _launch_findings(self, evaluation: Evaluation, request: EntryRequest, view: LaunchView) -> Iterator[Finding | Fine]:
        self._seen.append(Configuration(evaluation, None))
        yield from super()._launch_findings(evaluation, request, view)

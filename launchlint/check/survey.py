"""What the topology report is made from: the findings of entry files, and the connection graphs they came from, in one pass."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.options import EntryRequest
from launchlint.check.run import Progress, compute
from launchlint.evaluate.assemble import Evaluation
from launchlint.finding import Finding, Key
from launchlint.graph.connections import ConnectionGraph
from launchlint.graph.details import NO_DETAILS, Details, details
from launchlint.graph.topology import Topology, place_text, topology
from launchlint.rules.rule import Fine
from launchlint.source import Place, Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.tree import Document

Extents = Mapping[str, Span]
"""The places of nodes, params and remaps as topologies spell them → offsets at which the element begins and ends in its file."""


class Surveyed(NamedTuple):
    """One entry file: its findings and the joined graph of all its configurations; None where launchlint itself failed."""

    result: EntryResult
    topology: Topology | None
    extents: Extents
    details: Details = NO_DETAILS


class Surveyor(EntryChecker):
    """Checks entry files and keeps the graph of each configuration that it connects."""

    _graphs: list[ConnectionGraph]
    _extents: dict[str, Span]

    def survey(self, request: EntryRequest) -> Surveyed:
        """All findings of an entry file, and what it connects. Never raises: a crash becomes a finding."""
        self._graphs = []
        self._extents = {}
        result = self.check(request)
        connected = topology(self._graphs) if self._graphs and result.configurations else None
        return Surveyed(result, connected, self._extents, details(self._graphs))

    def connected(self, evaluation: Evaluation) -> ConnectionGraph:
        """The connection graph, remembered."""
        graph = super().connected(evaluation)
        self._graphs.append(graph)
        self._extents.update(_extents(graph, evaluation.documents))
        return graph

    def _launch_findings(self, evaluation: Evaluation, request: EntryRequest) -> Iterator[Finding | Fine]:
        before = len(self._graphs)
        yield from super()._launch_findings(evaluation, request)
        if len(self._graphs) == before:  # no rule asked for it
            self.connected(evaluation)


def survey_entries(
    requests: Sequence[EntryRequest], surveyor: Surveyor, *, jobs: int = 0, progress: Progress | None = None
) -> list[Surveyed]:
    """Each entry file surveyed, in order: the same for any number of ``jobs`` (0: as many as pay)."""
    return compute(requests, surveyor, Surveyor.survey, jobs, progress)


def _extents(graph: ConnectionGraph, documents: Mapping[str, Document]) -> Iterator[tuple[str, Span]]:
    for instance in graph.instances:
        node = instance.node
        place = node.origin.place
        yield place_text(node.attributes.get("name", place)), _whole(place, documents)
        for remap in node.remaps:
            yield place_text(remap.origin.place), remap.origin.place.span
    for setting in graph.launch.parameters.values():
        yield place_text(setting.origin.place), setting.origin.place.span


def _whole(place: Place, documents: Mapping[str, Document]) -> Span:
    """From the start tag that stands at a place to the end of its element."""
    document = documents.get(place.source.path)
    element = None if document is None else document.element_from(place.span.start)
    return place.span if element is None or element.span.start != place.span.start else element.span


def reached(findings: Sequence[Finding], entries: Sequence[Surveyed]) -> list[list[int]]:
    """For each entry file the numbers of those ``findings``, merged from all of them, that concern it.

    What was found while it was evaluated does; of what was found otherwise, what stands in a file that it reads.
    """
    by_key: dict[Key, list[int]] = {}
    by_path: dict[str, list[int]] = {}
    for number, (result, *_) in enumerate(entries):
        for found in result.findings:
            by_key.setdefault(found.key, []).append(number)
        for path in dict.fromkeys((result.path, *(file.path for file in result.files))):
            by_path.setdefault(path, []).append(number)
    concerned: list[list[int]] = [[] for _ in entries]
    for index, finding in enumerate(findings):
        for number in by_key.get(finding.key) or by_path.get(finding.location.path) or ():
            concerned[number].append(index)
    return concerned

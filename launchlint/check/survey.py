"""What the topology report is made from: the findings of entry files, and the connection graphs they came from, in one pass."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from launchlint.check.ahead import read_ahead
from launchlint.check.causes import Told
from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.merge import without_parts
from launchlint.check.options import Arguments, EntryRequest, Options
from launchlint.check.run import Progress, ReadingProgress, compute
from launchlint.dialects.door import dialect_of
from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.combinations import Interplay
from launchlint.finding import Finding, Key
from launchlint.graph.connections import ConnectionGraph
from launchlint.graph.details import NO_DETAILS, Details, details
from launchlint.graph.topology import Topology, place_text, topology
from launchlint.named_tuple import NamedTuple
from launchlint.rules.rule import Fine
from launchlint.source import Place, Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.graph.earlier import Earlier
    from launchlint.rules.view import LaunchView
    from launchlint.syntax.tree import Document

Extents = Mapping[str, Span]
"""The places of nodes, params, remaps, groups and includes as topologies spell them → where the element begins and ends in its file."""


class Surveyed(NamedTuple):
    """One entry file: its findings and the joined graph of all its configurations; None where launchlint itself failed.

    ``given`` are the args of each configuration; rules looked at the first ``checked`` of them, and ``told`` says in which of these each
    finding was. ``whole``: of any other combination of args it can be told what it starts. ``held``: there is a graph that was not
    joined, since the file may turn out to be a part of another entry file.
    """

    result: EntryResult
    topology: Topology | None
    extents: Extents
    details: Details = NO_DETAILS
    given: tuple[Arguments, ...] = ()
    told: Mapping[Key, tuple[int, ...]] = {}
    checked: int = 0
    whole: bool = True
    held: bool = False


class _Seen:
    """What a surveyor keeps of one entry file while it is checked."""

    def __init__(self, arguments: Arguments) -> None:
        self.graphs: list[ConnectionGraph] = []
        self.extents: dict[str, Span] = {}
        self.given: list[Arguments] = []
        self.told: dict[Key, list[int]] = {}
        self.interplay = Interplay(arguments)
        self.earlier: Earlier | None = None


class Surveyor(EntryChecker):
    """Checks entry files and keeps the graph of each configuration that it connects."""

    def __init__(self, options: Options, overlay: Mapping[str, bytes] | None = None, *, remember: bool = False) -> None:
        super().__init__(options, overlay, remember=remember)
        self._seen = _Seen(())
        self._held: dict[EntryRequest, _Seen] = {}

    def survey(self, request: EntryRequest) -> Surveyed:
        """All findings of an entry file, and what it connects. Never raises: a crash becomes a finding."""
        return self._joined(request, self._checked(request))

    def survey_unless_part(self, request: EntryRequest) -> Surveyed:
        """The same; what it connects is held back where the file lacks args, as most files do that others include."""
        result = self._checked(request)
        if not result.summary.needs_caller or not self._seen.graphs:
            return self._joined(request, result)
        self._seen.earlier = self._connected_before
        self._held[request] = self._seen
        return Surveyed(result, None, {}, held=True)

    def joined(self, surveyed: Surveyed) -> Surveyed:
        """What was held back, as :meth:`survey` gives it; worked out anew where another process has it."""
        request = surveyed.result.request
        held = self._held.pop(request, None)
        if held is None:
            return self.survey(request)
        self._seen, self._earlier = held, held.earlier
        return self._joined(request, surveyed.result)

    def _checked(self, request: EntryRequest) -> EntryResult:
        self._seen = _Seen(request.arguments)
        return self.check(request)

    def _joined(self, request: EntryRequest, result: EntryResult) -> Surveyed:
        seen = self._seen
        if not seen.graphs or not result.configurations:
            return Surveyed(result, None, seen.extents)
        checked = len(seen.given)
        whole = self._combine(request, seen) if len(seen.graphs) == checked else True
        told = {key: tuple(dict.fromkeys(those)) for key, those in seen.told.items()}
        return Surveyed(result, topology(seen.graphs), seen.extents, details(seen.graphs), tuple(seen.given), told, checked, whole)

    def _combine(self, request: EntryRequest, seen: _Seen) -> bool:
        """Evaluate the combinations of args of which each acts on what the others act on; returns whether these are all."""
        missing = seen.interplay.missing()
        session = self.session_for(request)
        session.begin_entry()
        try:
            dialect = dialect_of(session, request.at)
            for pairs in missing.combinations:
                evaluation = dialect.evaluate(session, request.at, (*request.arguments, *pairs))
                seen.given.append(evaluation.launch.given)
                self.connected(evaluation)
        except Exception:  # what was checked stands, whatever becomes of what is beyond it
            del seen.given[len(seen.graphs) :]
            return False
        return missing.whole

    def connected(self, evaluation: Evaluation) -> ConnectionGraph:
        """The connection graph, remembered."""
        graph = super().connected(evaluation)
        self._seen.graphs.append(graph)
        self._seen.extents.update(_extents(graph, evaluation.documents))
        return graph

    def _launch_findings(self, evaluation: Evaluation, request: EntryRequest, view: LaunchView) -> Iterator[Finding | Fine]:
        seen = self._seen
        before = len(seen.graphs)
        number = len(seen.given)
        seen.given.append(evaluation.launch.given)
        seen.interplay.saw(evaluation.launch)
        for found in super()._launch_findings(evaluation, request, view):
            if isinstance(found, Finding):
                seen.told.setdefault(found.key, []).append(number)
            yield found
        if len(seen.graphs) == before:  # no rule asked for it
            self.connected(evaluation)


def survey_entries(
    requests: Sequence[EntryRequest],
    surveyor: Surveyor,
    *,
    jobs: int = 0,
    progress: Progress | None = None,
    reading: ReadingProgress | None = None,
) -> list[Surveyed]:
    """Each entry file surveyed, in order, as :func:`launchlint.check.run.check_entries` does: the same for any number of ``jobs``.

    What those connect that are parts of others (:func:`launchlint.check.merge.parts`) is not worked out, since nobody is shown it.
    """
    read_ahead(requests, surveyor, jobs, reading)
    surveyed = compute(requests, surveyor, Surveyor.survey_unless_part, jobs, progress)
    kept = {id(result) for result in without_parts([each.result for each in surveyed])}
    return [surveyor.joined(each) if each.held and id(each.result) in kept else each for each in surveyed]


def _extents(graph: ConnectionGraph, documents: Mapping[str, Document]) -> dict[str, Span]:
    extents: dict[str, Span] = {}
    for instance in graph.instances:
        node = instance.node
        place = node.origin.place
        extents[place_text(node.places.get("name", place))] = _whole(place, documents)
        scope = node.scope
        while scope is not None and (around := place_text(scope.origin.place)) not in extents:
            extents[around] = _whole(scope.origin.place, documents)
            scope = scope.parent
        for remap in node.remaps:
            extents[place_text(remap.origin.place)] = remap.origin.place.span
    for setting in graph.launch.parameters.values():
        extents[place_text(setting.origin.place)] = setting.origin.place.span
    return extents


def _whole(place: Place, documents: Mapping[str, Document]) -> Span:
    """From the start tag that stands at a place to the end of its element."""
    document = documents.get(place.source.path)
    element = None if document is None else document.element_from(place.span.start)
    return place.span if element is None or element.span.start != place.span.start else element.span


def reached(told: Sequence[Told], entries: Sequence[Surveyed]) -> list[list[int]]:
    """For each entry file the numbers of those findings ``told`` that concern it; every one concerns some entry, if there is any.

    What was found while an entry was evaluated, or in the text of a file that it reads, concerns it; of the rest, what stands in such a
    file, or (in a ``package.xml``, say) in a directory around it.
    """
    by_key: dict[Key, set[int]] = {}
    by_path: dict[str, set[int]] = {}
    for number, (result, *_) in enumerate(entries):
        for found in (*result.findings, *(guarded.finding for file in result.files for guarded in file.findings)):
            by_key.setdefault(found.key, set()).add(number)
        for path in (result.path, *(file.path for file in result.files)):
            by_path.setdefault(path, set()).add(number)
    concerned: list[list[int]] = [[] for _ in entries]
    for index, each in enumerate(told):
        those: set[int] = set()
        for finding in each.of:
            path = finding.location.path
            those.update(by_key.get(finding.key) or by_path.get(path) or _below(path, entries))
        for number in sorted(those):
            concerned[number].append(index)
    return concerned


def shown_in(told: Sequence[Told], entry: Surveyed) -> list[tuple[int, ...]]:
    """For each of ``told`` the numbers of the configurations of one entry file that have it; empty: all of them.

    What stands in the text of a file is in all. A configuration that no rule looked at has what the configurations have that change some of
    its args and no others.
    """
    every = set(range(entry.checked))
    result: list[tuple[int, ...]] = []
    for each in told:
        those = {number for finding in each.of for number in entry.told.get(finding.key, ())}
        result.append(() if not those or those == every else tuple(sorted({*those, *_beyond(those, entry)})))
    return result


def _beyond(those: set[int], entry: Surveyed) -> Iterator[int]:
    for number in range(entry.checked, len(entry.given)):
        chosen = set(entry.given[number])
        within = [each for each in range(1, entry.checked) if set(entry.given[each]) <= chosen]
        largest = [each for each in within if not any(set(entry.given[each]) < set(entry.given[other]) for other in within)]
        if (0 in those) != any((each in those) != (0 in those) for each in largest):
            yield number


def _below(path: str, entries: Sequence[Surveyed]) -> set[int]:
    """The entry files in the directory of ``path`` and below; all of them where there is none."""
    directory = path.rpartition("/")[0]
    below = {number for number, each in enumerate(entries) if not directory or each.result.path.startswith(f"{directory}/")}
    return below or set(range(len(entries)))

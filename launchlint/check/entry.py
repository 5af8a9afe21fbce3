"""The checks of one entry file: every configuration of it, and the files it reaches."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from copy import copy
from functools import cached_property, partial
from itertools import islice

from launchlint.check.file import INTERNAL_ERROR, FileResult, check_file, check_parameters, internal_error, is_left_over, run_rule, tell
from launchlint.check.in_order import InOrder, grouped
from launchlint.check.listing import Listing
from launchlint.check.options import EntryRequest, Options
from launchlint.check.other_ros_included import IncludesOfRos2
from launchlint.check.stops import put_right, put_right_later, said_of, stops_everybody, without_tried
from launchlint.check.verdict import ALL_RULES, judged, plainly
from launchlint.dialects.door import configurations, evaluate, named
from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.problems import IncludeMissingArg, IncludeUndeclaredArg, RequiredArgUnset, UndeclaredArg, UsedBeforeDeclaration
from launchlint.evaluate.session import Session
from launchlint.finding import Finding, Key, Location, Severity
from launchlint.model import ROS1, Launch
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.rules.registry import RULES, Entry, rule_of
from launchlint.rules.rule import Fine
from launchlint.rules.view import BrokenCall, EntrySummary, FileView, LaunchView
from launchlint.sight import NOTHING, Followed, Sight, once, reason_beside, shortened
from launchlint.source import Source
from launchlint.syntax.tree import Document
from launchlint.verdict import LOADS, Verdict
from launchlint.workspace.looking import Looked, note, noted
from launchlint.workspace.packages import Packages
from launchlint.workspace.states import NOWHERE, Looks, States, state_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing_extensions import Self

    from launchlint.graph.connections import ConnectionGraph
    from launchlint.graph.earlier import Earlier
    from launchlint.knowledge.own import OwnSources
    from launchlint.library.lookup import Library
    from launchlint.model import DialectName

_PARAMETER_ENDS = (".yaml", ".yml")
CRASHED = Verdict("cannot be told", INTERNAL_ERROR, "launchlint itself crashed on it")
ALONE_KINDS = frozenset({RequiredArgUnset, UndeclaredArg, UsedBeforeDeclaration})
"""Problems that say a file is made to be included: it lacks args that only its callers can give."""


class EntryResult(NamedTuple):
    """What one entry file gives.

    ``verdict`` says what its launcher does with it here and now, ``ok``, ``error`` or, where that cannot be told, ``unknown``; ``outcome``
    is what people are told of that.
    For the cache: ``dependencies`` are the files it was made from with the digest of their content or the reason why there is none,
    ``variables`` the environment variables it read, ``looks`` where rules looked around, and what there was, ``programs`` those whose
    sources were asked for: middleware, key, digest. ``sight`` says how many of the nodes that it starts are known.
    """

    request: EntryRequest
    path: str
    verdict: str
    error: tuple[str, str] | None
    findings: tuple[Finding, ...]
    fine: tuple[InOrder, ...]
    visited: tuple[tuple[str, tuple[int, ...]], ...]
    files: tuple[FileResult, ...]
    summary: EntrySummary
    configurations: int
    dependencies: tuple[tuple[str, str], ...] = ()
    variables: tuple[tuple[str, str | None], ...] = ()
    looks: Looks = NOWHERE
    outcome: Verdict = LOADS
    programs: tuple[tuple[str, str, str, str, str], ...] = ()
    sight: Sight = NOTHING

    @property
    def launch_files(self) -> Iterable[str]:
        """The launch files that it is made of, as shown: itself, and what it includes in whichever configuration."""
        return dict.fromkeys((self.path, *self.summary.included, *(file.path for file in self.files)))


MOST_REASONS = 20
"""Reasons that are kept of one launch file in Python."""


class EntryChecker:
    """Checks entry files one after another, sharing parsed files and evaluated blocks.

    ``remember``: results also say what they depend on, so that they can be kept; ``states`` are what there was on disk.
    """

    def __init__(self, options: Options, overlay: Mapping[str, bytes] | None = None, *, remember: bool = False) -> None:
        self.options = options
        self.remember = remember
        self.packages = Packages(options.workspaces, options.variables, explicit=options.explicit, complete=options.complete)
        self.session = Session(self.packages, options.variables, options.root, overlay, options.distro)
        self.rules: tuple[Entry, ...] = tuple(rule for rule in RULES if rule.id in options.rules)
        self.launch_rules = tuple(rule for rule in self.rules if rule.view == "launch")
        self.graph_rules = tuple(rule for rule in self.rules if rule.view == "graph")
        self.states = States(partial(state_of, packages=self.packages))
        self._files: dict[str, FileResult] = {}
        self._sights: list[Sight] = []
        self._earlier: Earlier | None = None

    @cached_property
    def library(self) -> Library:
        """What is known of nodes. Raises LibraryError where a library file cannot be used."""
        from launchlint.library.lookup import open_libraries

        return open_libraries(self.options.library, self.options.library_cache, own=self.own)

    @cached_property
    def own(self) -> OwnSources | None:
        """What the sources of the workspaces' packages say of their programs."""
        options = self.options
        if not options.extract:
            return None
        from launchlint.knowledge.own import OwnSources, moved

        packages = self.packages
        if options.staged is not None:
            directory, repository = options.staged
            there = tuple(moved(os.path.realpath(each), repository, directory) for each in options.workspaces)
            packages = Packages(there, options.variables, explicit=options.explicit, complete=options.complete)
        return OwnSources(packages, options.root, options.sources_cache, options.staged)

    def holding(self, texts: Mapping[str, bytes | None]) -> Self:
        """A checker for which files hold ``texts`` instead, or again (None) what is on disk.

        Packages, and what was read of other files, are shared with this one. Unlike this one it does not remember.
        """
        other = copy(self)
        other.session = self.session.with_texts(texts)
        changed = {self.session.shown(file) for file in texts}
        other.remember = False
        other._files = {key: result for key, result in self._files.items() if result.path not in changed}
        other._sights = []
        return other

    def check(self, request: EntryRequest) -> EntryResult:
        """All findings of one entry file. Never raises: a crash becomes a finding."""
        try:
            return self._check(request)
        except Exception as error:  # one file must never take the run down
            return self._crashed(request, error)

    def _check(self, request: EntryRequest) -> EntryResult:
        session = self.session_for(request)
        session.begin_entry()
        noted()
        self._sights.clear()
        self._earlier = None
        if self.own is not None:
            self._asked(self.own)
        findings: dict[Key, Finding] = {}
        fine: dict[Fine, None] = {}
        visited: dict[str, set[int]] = {}
        files: dict[str, FileResult] = {}
        included: dict[str, None] = {}
        first: Evaluation | None = None
        outcomes: list[tuple[tuple[tuple[str, str], ...], Verdict]] = []
        pinned = frozenset(name for name, _ in request.arguments)
        count = 0

        def so_far(first: Evaluation) -> EntryResult:
            """What the configurations that have been looked at give."""
            known = dict(files)
            for file in self._parameter_files(session, findings.values(), files, first.launch.dialect):
                known[file.path] = file
            result = self._result(request, first, findings, fine, visited, known, tuple(included), count)
            return result._replace(
                outcome=outcomes[0][1].beside(outcomes[1:]),
                sight=(self._sights[0] if self._sights else NOTHING)._replace(
                    followed=_followed(first.launch),
                    distros=((first.launch.distro, first.launch.named_by),) if first.launch.named_by else (),
                ),
            )

        for evaluation in configurations(session, request.at, request.arguments):
            count += 1
            for path, document in evaluation.documents.items():
                if path not in files:
                    files[path] = self._file(session, path, document, evaluation.launch.dialect)
            for path, indices in evaluation.visited.items():
                visited.setdefault(path, set()).update(indices)
            for include in evaluation.launch.includes:
                if include.source is not None:
                    included[include.source.path] = None
            evaluation = without_tried(_told_at_declarations(session, request.at, evaluation, pinned), request.arguments)
            first = first or evaluation
            view = self._view(evaluation, request)
            outcomes.append((evaluation.launch.given, judged(evaluation.launch, view)))
            for found in self._launch_findings(evaluation, request, view):
                if isinstance(found, Fine):
                    fine[found] = None
                else:
                    _keep_plainer(findings, found)
            if count == 1:
                self.after_first(partial(so_far, first))
            if self.options.default_only:
                break
        assert first is not None
        result = so_far(first)
        if not self.remember:
            return result
        return result._replace(
            dependencies=tuple((name, session.read(name).digest) for name in sorted(session.touched)),
            variables=tuple((name, session.environment.get(name)) for name in sorted(session.variables)),
            looks=self.states.looks(noted(), (file.looks for file in result.files)),
            programs=() if self.own is None else self._asked(self.own),
        )

    def after_first(self, so_far: Callable[[], EntryResult]) -> None:
        """The configuration that is given has been looked at, and gives ``so_far``; there may be more. Nobody waits for that here."""

    @staticmethod
    def _asked(own: OwnSources) -> tuple[tuple[str, str, str, str, str], ...]:
        """The programs whose sources were asked for since this was called last: middleware, key and digest of each."""
        return tuple((each.middleware, *key, each.digest(key)) for each in own.all for key in sorted(each.asked()))

    def _crashed(self, request: EntryRequest, error: Exception) -> EntryResult:
        path = self.session.shown(request.at)
        finding = internal_error("the evaluation", path, error)
        summary = EntrySummary(path, True, (), (), ())
        return EntryResult(request, path, "error", (finding.rule, finding.message), (finding,), (), (), (), summary, 0, outcome=CRASHED)

    def evaluations(self, request: EntryRequest) -> Iterator[Evaluation]:
        """The entry file in each configuration that is looked at, first of all as given."""
        session = self.session_for(request)
        session.begin_entry()
        return islice(configurations(session, request.at, request.arguments), 1 if self.options.default_only else None)

    def verdict(self, request: EntryRequest, evaluations: Iterable[Evaluation]) -> Verdict:
        """What its launcher makes of the entry file, of which these are all :meth:`evaluations`, as :meth:`check` says it."""
        session = self.session_for(request)
        pinned = frozenset(name for name, _ in request.arguments)
        told = (_told_at_declarations(session, request.at, evaluation, pinned) for evaluation in evaluations)
        plain = (without_tried(each, request.arguments) for each in told)
        first, *others = ((each.launch.given, judged(each.launch, self._view(each, request))) for each in plain)
        return first[1].beside(others)

    def _view(self, evaluation: Evaluation, request: EntryRequest) -> LaunchView:
        return LaunchView(evaluation.launch, self.packages, request.declared, evaluation.documents)

    def model(self, request: EntryRequest) -> tuple[Evaluation, tuple[str, str] | None]:
        """What one entry file starts as given, and its :meth:`refusal`."""
        session = self.session_for(request)
        session.begin_entry()
        evaluation = evaluate(session, request.at, request.arguments)
        return evaluation, self.refusal(request, evaluation)

    def refusal(self, request: EntryRequest, evaluation: Evaluation) -> tuple[str, str] | None:
        """Why its launcher refuses the entry file: rule ID and message of the first reason, if it does."""
        pinned = frozenset(name for name, _ in request.arguments)
        launch = _told_at_declarations(self.session_for(request), request.at, evaluation, pinned).launch
        refused = launch.refused
        if refused is None:
            return None
        view = LaunchView(launch, self.packages, request.declared)
        told = [finding.message for finding in tell(refused, view, self.options.rules)]
        return rule_of(type(refused)), told[0] if told else plainly(refused)

    def session_for(self, request: EntryRequest) -> Session:
        """The shared session, or one of its own where other text stands in for a file."""
        if request.file == request.at:
            return self.session
        content = self.session.read(request.file)
        return self.session if content.data is None else self.session.with_text(request.at, content.data)

    def _file(self, session: Session, path: str, document: Document, dialect: DialectName) -> FileResult:
        shared = session is self.session
        key = f"{dialect} {path}"
        if shared and key in self._files:
            return self._files[key]
        before = noted() if self.remember else Looked(frozenset())
        named_by = "" if dialect == ROS1 else session.named_by
        result = check_file(FileView(document, self.packages, self.options.style, named(dialect), named_by), self.rules)
        if self.remember:
            result = result._replace(looks=self.states.looks(noted()))
            note(before)
        if shared:
            self._files[key] = result
        return result

    def _parameter_files(
        self, session: Session, findings: Iterable[Finding], files: Mapping[str, FileResult], dialect: DialectName
    ) -> Iterator[FileResult]:
        """The parameter files in which something was found, and whose comments may say something of it."""
        for path in dict.fromkeys(finding.location.path for finding in findings):
            data = session.read(session.named(path)).data if path.endswith(_PARAMETER_ENDS) and path not in files else None
            if data is not None and b"launchlint" in data:
                yield check_parameters(Source(path, data.decode("utf-8", "replace").removeprefix("\ufeff"), session.named(path)), dialect)

    def _launch_findings(self, evaluation: Evaluation, request: EntryRequest, view: LaunchView) -> Iterator[Finding | Fine]:
        launch = evaluation.launch
        if is_left_over(launch.dialect, request.file, self.packages):
            return
        before: Problem | None = None
        listing = Listing()
        of_ros2 = IncludesOfRos2(evaluation, self.packages, self.options.rules)
        for problem in launch.problems:
            path = problem.place.source.path
            elsewhere = of_ros2.has(path)
            for finding in tell(problem, view, ALL_RULES if elsewhere else self.options.rules, listing):
                said = put_right(finding, problem, before, launch, request.arguments)
                said = of_ros2.instead_of(said, path) if elsewhere else said
                yield self._at_home(said, evaluation, assumed=problem.assumed)
            if before is None and stops_everybody(problem, view):
                before = problem
        switched = view.tried if launch.given != request.arguments else ""
        for rule in self.launch_rules:
            if launch.dialect not in rule.dialects:
                continue
            self.session.checkpoint()
            for found in listing.listed(run_rule(rule, view, launch.entry.path)):
                if isinstance(found, Fine):
                    yield found
                elif not of_ros2.has(found.location.path):
                    yield self._at_home(said_of(put_right_later(found, before), switched), evaluation, assumed=False)
        if self.graph_rules and (launch.nodes or launch.tests or launch.parameter_settings):
            yield from of_ros2.without(self._graph_findings(evaluation, request, listing))
        yield from (self._at_home(each, evaluation, assumed=False) for each in listing.left_out(self.options.rules))

    @property
    def _connected_before(self) -> Earlier:
        from launchlint.graph.earlier import Earlier

        if self._earlier is None:
            self._earlier = Earlier()
        return self._earlier

    def connected(self, evaluation: Evaluation) -> ConnectionGraph:
        """The connection graph of what was evaluated."""
        from launchlint.graph.connect import connect

        return connect(evaluation.launch, self.library, self._connected_before)

    def _graph_findings(self, evaluation: Evaluation, request: EntryRequest, listing: Listing) -> Iterator[Finding | Fine]:
        from launchlint.rules.view import GraphView, tried

        graph = self.connected(evaluation)
        if not self._sights:  # only the configuration without args, which comes first, counts
            self._sights.append(_sight(graph))
        library = self.library.of_launch(evaluation.launch.dialect)
        view = GraphView(graph, library, self.packages, request.declared, evaluation.documents, self._connected_before)
        switched = tried(evaluation.launch) if evaluation.launch.given != request.arguments else ""
        for rule in self.graph_rules:
            if evaluation.launch.dialect not in rule.dialects:
                continue
            self.session.checkpoint()
            for found in listing.listed(run_rule(rule, view, evaluation.launch.entry.path)):
                yield found if isinstance(found, Fine) else self._at_home(said_of(found, switched), evaluation, assumed=False)

    def _at_home(self, finding: Finding, evaluation: Evaluation, *, assumed: bool) -> Finding:
        """``finding`` with the entry file and args that show it; under a condition of unknown value it is no more than a warning."""
        severity = min(finding.severity, Severity.WARNING) if assumed else finding.severity
        launch = evaluation.launch
        launcher = named(launch.dialect).launcher
        return finding._replace(severity=severity, entry=launch.entry.path, arguments=launch.given, entries=1, launcher=launcher)

    def _result(
        self,
        request: EntryRequest,
        first: Evaluation,
        findings: dict[Key, Finding],
        fine: dict[Fine, None],
        visited: dict[str, set[int]],
        files: dict[str, FileResult],
        included: tuple[str, ...],
        count: int,
    ) -> EntryResult:
        launch = first.launch
        path = launch.entry.path
        refused = launch.refused
        error = None
        if refused is not None:
            told = next((finding.message for finding in findings.values() if finding.location.start == refused.place.span.start
                         and finding.location.path == refused.place.source.path), plainly(refused))  # fmt: skip
            error = (rule_of(type(refused)), told)
        reasons = {type(problem) for problem in launch.problems if problem.refused and problem.place.source.path == path}
        roots = tuple((known.path, known.root) for known in files.values() if known.root is not None)
        needs_caller = bool(reasons & ALONE_KINDS) and not request.declared
        lacks = needs_caller and bool(reasons & (ALONE_KINDS - {RequiredArgUnset}))
        calls = tuple(_broken_calls(launch.problems))
        launcher = named(launch.dialect).launcher
        summary = EntrySummary(path, refused is not None, included, calls, roots, needs_caller, lacks, tuple(_calls(launch)), launcher)
        return EntryResult(
            request,
            path,
            launch.verdict,
            error,
            tuple(findings.values()),
            grouped(fine),
            tuple((known, tuple(sorted(indices))) for known, indices in visited.items()),
            tuple(files.values()),
            summary,
            count,
        )


def _told_at_declarations(session: Session, file: str, evaluation: Evaluation, pinned: frozenset[str]) -> Evaluation:
    """As :func:`launchlint.check.empty_defaults.told_at_declarations`, which is not even imported where roslaunch loads the file."""
    if evaluation.launch.refused is None or evaluation.launch.dialect != ROS1:
        return evaluation
    from launchlint.check.empty_defaults import told_at_declarations

    return told_at_declarations(session, file, evaluation, pinned)


def _keep_plainer(findings: dict[Key, Finding], found: Finding) -> None:
    """Of findings that say the same keep the worse one, then the one nearer to the entry file, then the one found first."""
    known = findings.get(found.key)
    if known is None or (-int(found.severity), len(found.chain)) < (-int(known.severity), len(known.chain)):
        findings[found.key] = found


def _sight(graph: ConnectionGraph) -> Sight:
    unknown = [each for each in graph.instances if each.is_unknown]
    reasons = ((each.program, reason_beside(each.program, each.reason), 1) for each in unknown)
    return Sight(len(graph.instances), len(graph.instances) - len(unknown), once(reasons))


def _followed(launch: Launch) -> tuple[Followed, ...]:
    """The launch files in Python, with the first of the reasons why not all of them is known."""
    return tuple(
        Followed(
            each.source.path,
            each.state,
            tuple(
                dict.fromkeys((place.source.position(place.span.start).line, shortened(why)) for place, why in each.reasons[:MOST_REASONS])
            ),
        )
        for each in launch.followed
    )


def _calls(launch: Launch) -> Iterator[tuple[str, tuple[tuple[str, str], ...]]]:
    for include in launch.includes:
        passed = tuple((name, value) for name, value in include.arguments.items() if isinstance(value, str))
        if include.source is not None and passed:
            yield include.source.path, passed


def _broken_calls(problems: tuple[Problem, ...]) -> Iterator[BrokenCall]:
    for problem in problems:
        if not problem.refused:
            continue
        if isinstance(problem, IncludeMissingArg):
            if not problem.pass_all:  # else it may come from the command line
                yield BrokenCall(problem.file, problem.name, True, Location.of(problem.place))
        elif isinstance(problem, IncludeUndeclaredArg) and problem.name == problem.undeclared[0]:
            yield BrokenCall(problem.file, ", ".join(problem.undeclared), False, Location.of(problem.place), tuple(problem.known))

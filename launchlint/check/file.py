"""The checks of one launch file as it is written, whoever includes it."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.check.listing import Listing
from launchlint.finding import Finding, Location
from launchlint.model import ROS1
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.rules.registry import Entry, speaking_of
from launchlint.rules.rule import Fine
from launchlint.rules.view import FileView, LaunchView
from launchlint.source import Place, Source, Span
from launchlint.syntax.tree import Document, Element
from launchlint.workspace.other_ros import left_over
from launchlint.workspace.states import NOWHERE, Looks

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.model import DialectName
    from launchlint.suppression import Suppression
    from launchlint.workspace.packages import Packages


_PROGRAM = ".py"
_OF_PROGRAMS = "launchlint.syntax.ros2.python."
"""Where the problems are defined that only launch files in Python have: the fixes of their rules are Python."""

SAID_OF_LEFT_OVERS = frozenset(("LL100", "LL101", "LL115"))
"""The rules that speak of launch files of ROS 1 that were left behind in a package for ROS 2: they cannot be read, or that they were."""


class Guarded(NamedTuple):
    """A finding, and the conditional element around it (its index): where that is never evaluated, nobody is hurt yet."""

    finding: Finding
    guard: int | None


class FileResult(NamedTuple):
    """What one launch file by itself gives, read in one dialect; ``looks`` as in :class:`~launchlint.check.entry.EntryResult`.

    Not ``launches``: a parameter file, of which only the suppressions count.
    """

    path: str
    findings: tuple[Guarded, ...]
    suppressions: tuple[Suppression, ...]
    root: Location | None
    looks: Looks = NOWHERE
    dialect: DialectName = ROS1
    launches: bool = True

    @property
    def key(self) -> str:
        """Equal for two results about the same file."""
        return f"{self.dialect} {self.path}"


def check_file(view: FileView, rules: tuple[Entry, ...]) -> FileResult:
    """Run the rules that look at the text of one launch file."""
    document = view.document
    if is_left_over(view.dialect.name, document.source.file, view.packages):
        rules = tuple(rule for rule in rules if rule.id in SAID_OF_LEFT_OVERS)
    selected = frozenset(rule.id for rule in rules)
    findings: list[Guarded] = []
    listing = Listing()
    for problem in view.dialect.validate(document):
        findings += [Guarded(finding, _guard(view, finding.location)) for finding in tell(problem, view, selected, listing)]
    if document.launch is not None or view.dialect.name != ROS1:
        for rule in rules:
            if rule.view == "file" and view.dialect.name in rule.dialects:
                told = listing.listed(run_rule(rule, view, document.source.path))
                findings += [Guarded(found, _guard(view, found.location)) for found in told if isinstance(found, Finding)]
    findings += [Guarded(finding, None) for finding in listing.left_out(selected)]
    suppressions: tuple[Suppression, ...] = ()
    if "launchlint" in document.source.text:
        from launchlint.suppression import read

        suppressions = tuple(read(document.source, view.dialect.remarks(document)))
    return FileResult(document.source.path, tuple(findings), suppressions, _root(document), dialect=view.dialect.name)


def _root(document: Document) -> Location | None:
    """Where to point at a file as a whole: its document element, or the first line of what it describes."""
    if document.root is not None:
        return Location.of(document.place(document.root.name_span))
    if document.description is None:
        return None
    source, (start, end) = document.description.place
    line_end = source.text.find("\n", start)
    return Location.of(Place(source, Span(start, min(end, line_end) if line_end >= 0 else end)))


def is_left_over(dialect: DialectName, file: str, packages: Packages) -> bool:
    """Whether a launch file is one of ROS 1 that ROS 2 has left behind: of such a file no more than that is said."""
    return dialect == ROS1 and left_over(file, packages) is not None


def check_parameters(source: Source, dialect: DialectName) -> FileResult:
    """What a parameter file in YAML by itself gives: what its comments say of the findings in it."""
    from launchlint.suppression import read
    from launchlint.syntax.yaml_remarks import remarks

    return FileResult(source.path, (), tuple(read(source, remarks(source))), None, dialect=dialect, launches=False)


def tell(problem: Problem, view: object, selected: frozenset[str], listing: Listing | None = None) -> Iterator[Finding]:
    """What the rules for this kind of problem say about it, those that speak of the dialect of ``view``; of each as much as is listed."""
    listing = listing or Listing()
    told = view.told if isinstance(view, LaunchView) else {}
    dialect = view.dialect.name if isinstance(view, (FileView, LaunchView)) else ROS1
    for rule in speaking_of(type(problem)):
        if rule.id in selected and dialect in rule.dialects and not listing.is_full(rule.id):
            key = (id(problem), rule.id)
            if key not in told:
                told[key] = _told(rule, problem, view)
            yield from listing.listed(told[key])


def _told(rule: Entry, problem: Problem, view: object) -> tuple[Finding, ...]:
    findings: list[Finding] = []
    try:
        findings.extend(rule.load().tell(problem, view))
    except Exception as error:  # a rule must never take the run down
        findings.append(internal_error(f"rule {rule.id} {rule.name}", problem.place.source.path, error))
    return tuple(findings) if type(problem).__module__.startswith(_OF_PROGRAMS) else tuple(map(_as_in_markup, findings))


def _as_in_markup(finding: Finding) -> Finding:
    """A finding without a fix where that would have to be written into a program: it is made for XML or YAML."""
    return finding._replace(fix=None) if finding.fix is not None and finding.location.path.endswith(_PROGRAM) else finding


def run_rule(rule: Entry, view: object, path: str) -> Iterator[Finding | Fine]:
    """What a view rule says; a crash becomes a finding that names the rule and the file."""
    try:
        for found in rule.load().check(view):
            yield _as_in_markup(found) if isinstance(found, Finding) else found
    except Exception as error:  # a rule must never take the run down
        yield internal_error(f"rule {rule.id} {rule.name}", path, error)


INTERNAL_ERROR = "LL000"


def internal_error(what: str, path: str, error: Exception) -> Finding:
    """The finding for a crash inside ``what`` (a rule, say): the run goes on, and ends with exit status 2."""
    import traceback

    from launchlint.finding import Severity
    from launchlint.rules.rule import shortened

    frames = traceback.extract_tb(error.__traceback__)
    where = f"{frames[-1].name}, line {frames[-1].lineno}" if frames else "unknown place"
    return Finding(
        INTERNAL_ERROR, "internal-error", Severity.ERROR, Location(path, 1, 1, 1, 1, 0, 0, ""),
        shortened(f"{what} crashed on this file: {type(error).__name__}: {error}"),
        notes=(f"in {where}; everything else went on",), help="please report this, with the launch file if you can share it", topic=what,
    )  # fmt: skip


def _guard(view: FileView, location: Location) -> int | None:
    document = view.document
    if view.dialect.reads_ahead:
        return None
    if location.path != document.source.path or document.launch is None:
        return None
    # The innermost element around the place: the last one that begins before it, or one around that.
    after = document.element_from(location.start + 1)
    element: Element | None = document.elements[(len(document.elements) if after is None else after.index) - 1]
    while element is not None and element.span.end <= location.start:
        element = element.parent
    while element is not None:
        if "if" in element.attributes or "unless" in element.attributes:
            return element.index
        element = element.parent
    return None

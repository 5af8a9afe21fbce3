"""What all entry files together show at each file: of many that show the same mistake one finding, and who leads there.

What is gathered for one file hangs on the results that show something of it, and on nothing else: where one entry file has changed, only
the files are gathered anew of which it shows something.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

from launchlint.check.in_order import Together
from launchlint.finding import Finding, Key, Severity
from launchlint.named_tuple import NamedTuple
from launchlint.rules.rule import Fine

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.check.entry import EntryResult
    from launchlint.check.file import FileResult
    from launchlint.check.options import EntryRequest
    from launchlint.rules.view import EntrySummary
    from launchlint.sight import Sight
    from launchlint.suppression import Suppression
    from launchlint.verdict import Verdict

NEVER_EVALUATED = "no configuration that was found evaluates this element, so that nobody is stopped by it yet"


class Shown(NamedTuple):
    """Who shows a finding: the paths of the entry files, sorted; and whether one does with the args with which it is asked for."""

    entries: tuple[str, ...]
    by_default: bool


class AtFile(NamedTuple):
    """What is told of one file: ``findings`` with their place in it that evaluating entry files shows, in the order in which they were met;
    those of the file as it is written (``of_text``), wherever their place is; its suppressions, and whether it is a launch file.

    ``shown`` has the findings, and those that are in order in another entry file, by key.
    """

    findings: tuple[Finding, ...] = ()
    shown: Mapping[Key, Shown] = {}
    of_text: tuple[Finding, ...] = ()
    suppressions: tuple[Suppression, ...] = ()
    launches: bool = False


class Standing(NamedTuple):
    """What is told of an entry file as a whole."""

    path: str
    outcome: Verdict
    sight: Sight


class Member(NamedTuple):
    """What is needed of an entry file where none of the files has changed for which it shows anything (``shown``, paths, sorted).

    ``key`` and ``seal`` are those under which all of its result is kept.
    """

    key: str
    seal: str
    shown: tuple[str, ...]
    summary: EntrySummary
    standing: Standing


NOTHING = AtFile()


def files_shown(result: EntryResult) -> frozenset[str]:
    """The paths of all files for which this result says anything to :func:`gathered`."""
    return frozenset((
        *(finding.location.path for finding in result.findings),
        *(group.path for group in result.fine),
        *(path for path, _ in result.visited),
        *(file.path for file in result.files),
    ))  # fmt: skip


def gathered(results: Sequence[EntryResult], entries: Sequence[EntryResult], only: Collection[str] | None = None) -> dict[str, AtFile]:
    """What is told of each file, by path. ``entries`` are those of ``results`` that are no parts of others.

    Of ``only`` some files where that is given: then all results must be there that show something of them. Where several say the same
    equally well, the first of them by its request counts.
    """
    results = sorted(results, key=_request)
    entries = sorted(entries, key=_request)
    shown = _of_entries(entries, only)
    files: dict[str, FileResult] = {}
    for result in results:
        for file in result.files:
            if only is None or file.path in only:
                files.setdefault(file.path, file)
    visited: dict[str, set[int]] = {}
    for result in entries:
        for path, indices in result.visited:
            visited.setdefault(path, set()).update(indices)
    for path, each in files.items():
        of_text = _of_text(each, visited.get(path, set()))
        shown[path] = shown.get(path, NOTHING)._replace(of_text=of_text, suppressions=each.suppressions, launches=each.launches)
    return shown


def _request(result: EntryResult) -> EntryRequest:
    return result.request


def _of_entries(entries: Iterable[EntryResult], only: Collection[str] | None) -> dict[str, AtFile]:
    """What evaluating ``entries`` shows."""
    findings: dict[str, dict[Key, Finding]] = {}
    reached: dict[Key, set[str]] = {}
    by_default: set[Key] = set()
    fine = Together()
    made_whole = _parts_in_order(entries, only)
    for result in entries:
        fine.add(result.fine)
        for finding in result.findings:
            at = finding.location
            if only is not None and at.path not in only:
                continue
            if made_whole and result.path in made_whole.get(Fine(finding.rule, at.path, at.start, finding.topic), ()):
                continue
            key = finding.key
            reached.setdefault(key, set()).add(result.path)
            if finding.arguments == result.request.arguments:
                by_default.add(key)
            there = findings.setdefault(at.path, {})
            known = there.get(key)
            if known is None or _better(finding, known):
                there[key] = finding
    return {
        path: AtFile(
            tuple(
                finding._replace(entries=len(reached[key]))
                for key, finding in there.items()
                if not fine.has(finding.rule, path, finding.location.start)
            ),
            {key: Shown(tuple(sorted(reached[key])), key in by_default) for key in there},
        )
        for path, there in findings.items()
    }


def _of_text(file: FileResult, evaluated: Collection[int]) -> tuple[Finding, ...]:
    """The findings of a file as it is written; what is never ``evaluated`` is no error."""
    return tuple(
        finding._replace(severity=Severity.WARNING, notes=(*finding.notes, NEVER_EVALUATED))
        if guard is not None and guard not in evaluated and finding.severity is Severity.ERROR
        else finding
        for finding, guard in file.findings
    )


def _parts_in_order(entries: Iterable[EntryResult], only: Collection[str] | None) -> dict[Fine, set[str]]:
    """What is in order in an entry file that includes others: the files that it is made of, which alone need not be whole."""
    found: dict[Fine, set[str]] = {}
    for result in entries:
        included: set[str] | None = None
        for group in result.fine:
            if group.topic and (only is None or group.path in only):
                included = set(result.summary.included) - {result.path} if included is None else included
                for fine in group.each:
                    found.setdefault(fine, set()).update(included)
    return found


def _better(finding: Finding, known: Finding) -> bool:
    """Whether ``finding`` shows the same mistake more plainly: worse first, then nearer to an entry file, fewer args, first by name."""

    def rank(item: Finding) -> tuple[object, ...]:
        return (-int(item.severity), len(item.chain), len(item.arguments), item.entry, item.arguments, item.message)

    return rank(finding) < rank(known)

"""Results as plain JSON values and back: what the cache keeps.

JSON and not pickle, since a cache directory may be restored from somewhere else and must not be able to run anything.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from launchlint.check.entry import EntryResult
from launchlint.check.file import FileResult, Guarded
from launchlint.check.in_order import ReadOnce, to_text
from launchlint.check.options import EntryRequest
from launchlint.finding import Edit, Finding, Fix, Location, Related, Severity
from launchlint.rules.view import BrokenCall, EntrySummary
from launchlint.sight import Followed, Sight, Unseen
from launchlint.source import Span
from launchlint.suppression import Name, Suppression
from launchlint.verdict import Refusal, Verdict


def file_to_json(result: FileResult) -> list[Any]:
    """A file's result as JSON values; where it looked around is left out."""
    suppressions = [
        [
            list(item.location),
            sorted(item.rules),
            [[name.text, *name.span] for name in item.names],
            item.covers,
            item.reason,
            item.problem,
            item.removal,
        ]
        for item in result.suppressions
    ]  # fmt: skip
    findings = [[_finding_to_json(finding), guard] for finding, guard in result.findings]
    return [result.path, findings, suppressions, result.root, result.dialect, result.launches]


def file_from_json(value: Any) -> FileResult:
    """The inverse of :func:`file_to_json`. Raises TypeError, ValueError or KeyError for anything else."""
    path, findings, suppressions, root, dialect, launches = value
    return FileResult(
        path,
        tuple(Guarded(_finding_from_json(finding), guard) for finding, guard in findings),
        tuple(
            Suppression(
                Location(*location),
                frozenset(rules),
                tuple(Name(text, Span(start, end)) for text, start, end in names),
                None if covers is None else Span(*covers),
                reason,
                problem,
                Edit(*removal),
            )
            for location, rules, names, covers, reason, problem, removal in suppressions
        ),
        None if root is None else Location(*root),
        dialect=dialect,
        launches=launches,
    )


def entry_to_json(result: EntryResult) -> list[Any]:
    """An entry's result as JSON values; its files are named only, and what it depends on is left out."""
    summary = result.summary
    return [
        result.path,
        result.verdict,
        result.error,
        [_finding_to_json(finding) for finding in result.findings],
        list(map(to_text, result.fine)),
        result.visited,
        [file.key for file in result.files],
        [
            summary.path,
            summary.refused,
            summary.included,
            [[*call[:3], call.location, call.known] for call in summary.broken_calls],
            None if summary.roots == _roots(result.files) else summary.roots,
            summary.needs_caller,
            summary.undeclared_args,
            summary.calls,
            summary.launcher,
        ],
        result.configurations,
        result.outcome,
        result.sight,
    ]


def _followed(value: Any) -> tuple[Followed, ...]:
    return tuple(Followed(path, state, tuple((line, reason) for line, reason in reasons)) for path, state, reasons in value)


def _distros(value: Any) -> tuple[tuple[str, str], ...]:
    return tuple((name, file) for name, file in value)


def names_of(value: Any) -> Any:
    """The keys of the files of an entry's result, as :func:`entry_to_json` gives it."""
    return value[6]


def _roots(files: Iterable[FileResult]) -> tuple[tuple[str, Location], ...]:
    return tuple((file.path, file.root) for file in files if file.root is not None)


def entry_from_json(value: Any, request: EntryRequest, files: Mapping[str, FileResult], fine_of: ReadOnce | None = None) -> EntryResult:
    """The inverse of :func:`entry_to_json`, with the files looked up in ``files``. Raises TypeError, ValueError or KeyError.

    Where many entries are read, ``fine_of`` is the same for all of them.
    """
    path, verdict, error, findings, fine, visited, names, summary, configurations, outcome, sight = value
    of_files = tuple(files[name] for name in names)
    word, rule, reason, missing, elsewhere, launcher = outcome
    entry, refused, included, calls, roots, needs, undeclared, passing, starter = summary
    return EntryResult(
        request,
        path,
        verdict,
        None if error is None else (error[0], error[1]),
        tuple(_finding_from_json(finding) for finding in findings),
        tuple(map((ReadOnce() if fine_of is None else fine_of).__getitem__, fine)),
        tuple((name, tuple(indices)) for name, indices in visited),
        of_files,
        EntrySummary(
            entry,
            refused,
            tuple(included),
            tuple(BrokenCall(target, name, missing, Location(*at), tuple(known)) for target, name, missing, at, known in calls),
            _roots(of_files) if roots is None else tuple((name, Location(*location)) for name, location in roots),
            needs,
            undeclared,
            tuple((path, tuple((name, text) for name, text in passed)) for path, passed in passing),
            starter,
        ),
        configurations,
        outcome=Verdict(word, rule, reason, tuple(missing), tuple(_refusal_from_json(each) for each in elsewhere), launcher),
        sight=Sight(
            sight[0],
            sight[1],
            tuple(Unseen(*each) for each in sight[2]),
            _followed(sight[3]),
            _distros(sight[4]),
        ),
    )


def _refusal_from_json(value: Any) -> Refusal:
    arguments, rule, reason = value
    return Refusal(tuple((name, given) for name, given in arguments), rule, reason)


def _finding_to_json(finding: Finding) -> list[Any]:
    fix = None if finding.fix is None else list(finding.fix)
    return [*finding[:2], int(finding.severity), *finding[3:14], fix, *finding[15:]]


def _finding_from_json(value: Any) -> Finding:
    rule, name, severity, location, message, label, related, chain, notes, help_, entry, arguments, entries, *more = value
    element, fix, topic, cause, launcher, about = more
    return Finding(
        rule,
        name,
        Severity(severity),
        Location(*location),
        message,
        label,
        tuple(Related(Location(*place), text) for place, text in related),
        tuple(Location(*place) for place in chain),
        tuple(notes),
        help_,
        entry,
        tuple((key, text) for key, text in arguments),
        entries,
        element,
        None if fix is None else Fix(fix[0], fix[1], tuple(Edit(*edit) for edit in fix[2]), fix[3]),
        topic,
        cause,
        launcher,
        tuple(about),
    )

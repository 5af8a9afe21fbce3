"""Results as plain JSON values and back: what the cache keeps.

JSON and not pickle, since a cache directory may be restored from somewhere else and must not be able to run anything.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from launchlint.check.entry import EntryResult
from launchlint.check.file import FileResult, Guarded
from launchlint.check.gathered import AtFile, Member, Shown, Standing
from launchlint.check.in_order import ReadOnce, to_text
from launchlint.check.merge import Outcome
from launchlint.check.options import EntryRequest
from launchlint.finding import Edit, Finding, Fix, Key, Location, Related, Severity
from launchlint.rules.view import BrokenCall, EntrySummary
from launchlint.sight import Followed, Sight, Unseen
from launchlint.source import Span
from launchlint.suppression import Name, Suppression
from launchlint.verdict import Refusal, Verdict


def file_to_json(result: FileResult) -> list[Any]:
    """A file's result as JSON values; where it looked around is left out."""
    suppressions = [_suppression_to_json(item) for item in result.suppressions]
    findings = [[_finding_to_json(finding), guard] for finding, guard in result.findings]
    return [result.path, findings, suppressions, result.root, result.dialect, result.launches]


def file_from_json(value: Any) -> FileResult:
    """The inverse of :func:`file_to_json`. Raises TypeError, ValueError or KeyError for anything else."""
    path, findings, suppressions, root, dialect, launches = value
    return FileResult(
        path,
        tuple(Guarded(_finding_from_json(finding), guard) for finding, guard in findings),
        tuple(map(_suppression_from_json, suppressions)),
        None if root is None else Location(*root),
        dialect=dialect,
        launches=launches,
    )


def _suppression_to_json(item: Suppression) -> list[Any]:
    names = [[name.text, *name.span] for name in item.names]
    return [list(item.location), sorted(item.rules), names, item.covers, item.reason, item.problem, item.removal]


def _suppression_from_json(value: Any) -> Suppression:
    location, rules, names, covers, reason, problem, removal = value
    return Suppression(
        Location(*location),
        frozenset(rules),
        tuple(Name(text, Span(start, end)) for text, start, end in names),
        None if covers is None else Span(*covers),
        reason,
        problem,
        Edit(*removal),
    )


def entry_to_json(result: EntryResult) -> list[Any]:
    """An entry's result as JSON values; its files are named only, and what it depends on is left out."""
    return [
        result.path,
        result.verdict,
        result.error,
        [_finding_to_json(finding) for finding in result.findings],
        list(map(to_text, result.fine)),
        result.visited,
        [file.key for file in result.files],
        _summary_to_json(result.summary, _roots(result.files)),
        result.configurations,
        result.outcome,
        result.sight,
    ]


def _summary_to_json(summary: EntrySummary, roots: Any) -> list[Any]:
    """``roots`` are those that are known from elsewhere."""
    return [
        summary.path,
        summary.refused,
        summary.included,
        [[*call[:3], call.location, call.known] for call in summary.broken_calls],
        None if summary.roots == roots else summary.roots,
        summary.needs_caller,
        summary.undeclared_args,
        summary.calls,
        summary.launcher,
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
    return EntryResult(
        request,
        path,
        verdict,
        None if error is None else (error[0], error[1]),
        tuple(_finding_from_json(finding) for finding in findings),
        tuple(map((ReadOnce() if fine_of is None else fine_of).__getitem__, fine)),
        tuple((name, tuple(indices)) for name, indices in visited),
        of_files,
        _summary_from_json(summary, _roots(of_files)),
        configurations,
        outcome=_verdict_from_json(outcome),
        sight=_sight_from_json(sight),
    )


def _summary_from_json(value: Any, of_files: tuple[tuple[str, Location], ...]) -> EntrySummary:
    entry, refused, included, calls, roots, needs, undeclared, passing, starter = value
    return EntrySummary(
        entry,
        refused,
        tuple(included),
        tuple(BrokenCall(target, name, missing, Location(*at), tuple(known)) for target, name, missing, at, known in calls),
        of_files if roots is None else tuple((name, Location(*location)) for name, location in roots),
        needs,
        undeclared,
        tuple((path, tuple((name, text) for name, text in passed)) for path, passed in passing),
        starter,
    )


def _verdict_from_json(value: Any) -> Verdict:
    word, rule, reason, missing, elsewhere, launcher = value
    return Verdict(word, rule, reason, tuple(missing), tuple(_refusal_from_json(each) for each in elsewhere), launcher)


def _sight_from_json(value: Any) -> Sight:
    nodes, known, unseen, followed, distros = value
    return Sight(nodes, known, tuple(Unseen(*each) for each in unseen), _followed(followed), _distros(distros))


def member_to_json(member: Member) -> list[Any]:
    """What is kept of an entry file beside all of its result, as JSON values."""
    standing = member.standing
    return [member.key, member.seal, member.shown, _summary_to_json(member.summary, ()), standing.outcome, standing.sight]


def member_from_json(value: Any) -> Member:
    """The inverse of :func:`member_to_json`. Raises TypeError, ValueError or KeyError for anything else."""
    key, seal, shown, summary, outcome, sight = value
    read = _summary_from_json(summary, ())
    return Member(key, seal, tuple(shown), read, Standing(read.path, _verdict_from_json(outcome), _sight_from_json(sight)))


def at_files_to_json(files: Mapping[str, AtFile]) -> list[Any]:
    """What is told of files, by path, as JSON values."""
    numbers: dict[str, int] = {}

    def shown_to_json(key: Key, shown: Shown) -> list[Any]:
        return [*key, [numbers.setdefault(name, len(numbers)) for name in shown.entries], shown.by_default]

    written = {
        path: [
            list(map(_finding_to_json, file.findings)),
            [shown_to_json(key, shown) for key, shown in file.shown.items()],
            list(map(_finding_to_json, file.of_text)),
            list(map(_suppression_to_json, file.suppressions)),
            file.launches,
        ]
        for path, file in files.items()
    }
    return [list(numbers), written]


def at_files_from_json(value: Any) -> dict[str, AtFile]:
    """The inverse of :func:`at_files_to_json`. Raises TypeError, ValueError, IndexError or KeyError for anything else."""
    names, files = value
    return {
        path: AtFile(
            tuple(map(_finding_from_json, findings)),
            {
                (rule, place, start, end, topic): Shown(tuple(names[number] for number in entries), by_default)
                for rule, place, start, end, topic, entries, by_default in shown
            },
            tuple(map(_finding_from_json, of_text)),
            tuple(map(_suppression_from_json, suppressions)),
            launches,
        )
        for path, (findings, shown, of_text, suppressions, launches) in files.items()
    }


def outcome_to_json(outcome: Outcome) -> list[Any]:
    """What is told of a run, as JSON values."""
    return [list(map(_finding_to_json, outcome.findings)), *outcome[1:]]


def outcome_from_json(value: Any) -> Outcome:
    """The inverse of :func:`outcome_to_json`. Raises TypeError, ValueError or KeyError for anything else."""
    findings, files, entries, crashed, verdicts, sight = value
    standing = tuple((path, _verdict_from_json(verdict)) for path, verdict in verdicts)
    return Outcome(tuple(map(_finding_from_json, findings)), files, entries, crashed, standing, _sight_from_json(sight))


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

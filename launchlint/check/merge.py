"""Join the results of all entry files: each finding once, at its own place, with the shortest way to it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence

from launchlint.check.entry import EntryResult
from launchlint.check.file import INTERNAL_ERROR, FileResult, run_rule
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.in_order import Together
from launchlint.check.known import Known
from launchlint.check.options import Options
from launchlint.check.ours import Ours
from launchlint.finding import Finding, Key, Severity
from launchlint.named_tuple import NamedTuple
from launchlint.order import ordered
from launchlint.rules.registry import RULES, find
from launchlint.rules.rule import Fine
from launchlint.rules.view import EntrySummary, RunView, SuppressionView
from launchlint.sight import NOTHING, Sight, together
from launchlint.verdict import Verdict
from launchlint.workspace.packages import Packages

NEVER_EVALUATED = "no configuration that was found evaluates this element, so that nobody is stopped by it yet"


class Outcome(NamedTuple):
    """All findings of a run in report order, how much was looked at, and the verdict on each entry file by its path, in order."""

    findings: tuple[Finding, ...]
    files: int
    entries: int
    crashed: bool
    verdicts: tuple[tuple[str, Verdict], ...] = ()
    sight: Sight = NOTHING


class Overview(NamedTuple):
    """What hangs on the summaries of all entry files, and no more of them: the same until one of these changes.

    ``parts`` are the paths of entry files that are parts of others (:func:`parts`); ``findings`` what the rules say that look at the run.
    """

    summaries: tuple[EntrySummary, ...]
    parts: frozenset[str]
    findings: tuple[Finding, ...]


def overview(summaries: Iterable[EntrySummary], options: Options, packages: Packages, asked: tuple[str, ...] = ()) -> Overview:
    """What there is to know of a whole run without its single findings."""
    known = tuple(summaries)
    view = RunView(known, packages, options.root, tuple(map(os.path.abspath, asked)))
    rules = (rule for rule in RULES if rule.view == "run" and rule.id in options.rules)
    told = (found for rule in rules for found in run_rule(rule, view, ".") if isinstance(found, Finding))
    return Overview(known, parts(known), tuple(told))


def merge(
    results: Sequence[EntryResult],
    options: Options,
    packages: Packages,
    per_file: PerFileIgnores,
    *,
    workspace: bool = True,
    alone: bool = False,
    asked: tuple[str, ...] = (),
    whole: Overview | None = None,
) -> Outcome:
    """The findings of a whole run.

    A file that others include and that lacks args when started alone is not an entry file: what was found in it that way is left out.
    ``per_file`` says which rules are off where. ``workspace`` runs the rules that look at the whole run; ``alone`` keeps every entry,
    whoever includes it. ``asked`` are the paths people gave; what is wrong in files that are merely installed is told at the include that
    leads there.

    With the overview of the ``whole`` run, ``results`` may be only some of it: then what is told of a file is right if all entry files
    that lead there are among them.
    """
    if whole is None:
        summaries = tuple(result.summary for result in results)
        whole = overview(summaries, options, packages, asked) if workspace else Overview(summaries, parts(summaries), ())
    entries = [each for each in results if alone or not (each.summary.needs_caller and each.path in whole.parts)]
    of_entries = whole.summaries if alone else tuple(each for each in whole.summaries if not _is_part(each, whole.parts))
    findings: dict[Key, Finding] = {}
    reached: dict[Key, set[str]] = {}
    by_default: set[Key] = set()
    fine = Together()
    visited: dict[str, set[int]] = {}
    files: dict[str, FileResult] = {}
    made_whole = _parts_in_order(entries)
    for result in entries:
        fine.add(result.fine)
        for path, indices in result.visited:
            visited.setdefault(path, set()).update(indices)
        for finding in result.findings:
            key = finding.key
            if result.path in made_whole.get(Fine(finding.rule, finding.location.path, finding.location.start, finding.topic), ()):
                continue
            reached.setdefault(key, set()).add(result.path)
            if finding.arguments == result.request.arguments:
                by_default.add(key)
            known = findings.get(key)
            if known is None or _better(finding, known):
                findings[key] = finding
    for result in results:
        for file in result.files:
            files.setdefault(file.path, file)
    collected = [
        finding._replace(entries=len(reached[key]))
        for key, finding in findings.items()
        if not fine.has(finding.rule, finding.location.path, finding.location.start)
    ]
    own = {finding.key for finding in collected}
    of_files: dict[Key, Finding] = {}  # what several files show at one place counts as it does in the worst of them
    for file in files.values():
        evaluated = visited.get(file.path, set())
        for finding, guard in file.findings:
            if finding.key in own:
                continue
            if guard is not None and guard not in evaluated and finding.severity is Severity.ERROR:
                finding = finding._replace(severity=Severity.WARNING, notes=(*finding.notes, NEVER_EVALUATED))
            same = of_files.get(finding.key)
            if same is None or finding.severity > same.severity:
                of_files[finding.key] = finding
    collected += of_files.values()
    if collected:
        from launchlint.check.judges import judged  # a dozen modules that a file without findings does without

        collected = judged(collected, Known(packages, options.root, reached, by_default, of_entries))
    collected += whole.findings if workspace else ()
    collected = list(Ours(options, asked).brought_home(collected))
    crashes = [finding for finding in collected if finding.rule == INTERNAL_ERROR]
    others = _adjust((finding for finding in collected if finding.rule != INTERNAL_ERROR), options, per_file)
    kept, more = _suppress(others, files.values(), options, per_file)
    crashes += more
    verdicts = tuple(sorted({result.path: result.outcome for result in entries}.items()))
    looked_at = {path for path, file in files.items() if file.launches} | {result.path for result in results}
    sight = together(each.sight for each in entries)
    return Outcome(tuple(ordered([*kept, *crashes])), len(looked_at), len(entries), bool(crashes), verdicts, sight)


def _is_part(summary: EntrySummary, parts: frozenset[str]) -> bool:
    return summary.needs_caller and summary.path in parts


def _parts_in_order(entries: Sequence[EntryResult]) -> dict[Fine, set[str]]:
    """What is in order in an entry file that includes others: the files that it is made of, which alone need not be whole."""
    found: dict[Fine, set[str]] = {}
    for result in entries:
        for group in result.fine:
            for fine in group.each if group.topic else ():
                found.setdefault(fine, set()).update(path for path in result.summary.included if path != result.path)
    return found


def without_parts(results: Sequence[EntryResult]) -> list[EntryResult]:
    """The results without those of files that lack args and that another entry file leads to; see :func:`parts`."""
    left_out = parts([result.summary for result in results])
    return [result for result in results if not _is_part(result.summary, left_out)]


def parts(entries: Sequence[EntrySummary]) -> frozenset[str]:
    """The paths of entry files that are parts of others: they lack args, and another entry file leads to them.

    Files that only include each other in a circle are none, so that the circle is told of.
    """
    includes: dict[str, set[str]] = {}
    for entry in entries:
        includes.setdefault(entry.path, set()).update(entry.included)
    elsewhere = {path for entry in entries for path in entry.included if path != entry.path}
    dropped = {entry.path for entry in entries if entry.needs_caller and entry.path in elsewhere}
    led_to: set[str] = set()
    waiting = [path for path in includes if path not in dropped]
    candidates = iter(sorted(dropped))
    while True:
        while waiting:
            path = waiting.pop()
            if path not in led_to:
                led_to.add(path)
                waiting.extend(includes.get(path, ()))
        in_circle = next((path for path in candidates if path not in led_to), None)
        if in_circle is None:
            break
        dropped.discard(in_circle)
        waiting.append(in_circle)
    return frozenset(dropped)


def _better(finding: Finding, known: Finding) -> bool:
    """Whether ``finding`` shows the same mistake more plainly: worse first, then nearer to an entry file, fewer args, first by name."""

    def rank(item: Finding) -> tuple[object, ...]:
        return (-int(item.severity), len(item.chain), len(item.arguments), item.entry, item.arguments, item.message)

    return rank(finding) < rank(known)


def _adjust(findings: Iterable[Finding], options: Options, per_file: PerFileIgnores) -> list[Finding]:
    """Severities and per-file ignores as people asked for them."""
    return [
        finding._replace(severity=options.severities.get(finding.rule, finding.severity))
        for finding in findings
        if finding.rule not in per_file.off(finding.location.path)
    ]


def _suppress(
    findings: list[Finding], files: Iterable[FileResult], options: Options, per_file: PerFileIgnores
) -> tuple[list[Finding], list[Finding]]:
    """The findings that no comment suppresses, with what is to be said of the comments; then the crashes of those rules."""
    suppressions = [suppression for file in files for suppression in file.suppressions]
    if not suppressions:
        return findings, []
    from launchlint.suppression import apply

    def resolve(word: str) -> str | None:
        rule = find(word)
        return None if rule is None else rule.id

    kept, used = apply(findings, suppressions, resolve)
    view = SuppressionView(tuple(suppressions), frozenset(used), resolve, options.rules, tuple(rule.name for rule in RULES))
    told = [
        found
        for rule in RULES
        if rule.view == "suppression" and rule.id in options.rules
        for found in run_rule(rule, view, suppressions[0].location.path)
        if isinstance(found, Finding)
    ]
    kept += _adjust((found for found in told if found.rule != INTERNAL_ERROR), options, per_file)
    return kept, [found for found in told if found.rule == INTERNAL_ERROR]

"""Join the results of all entry files: each finding once, at its own place, with the shortest way to it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence

from launchlint.check.entry import EntryResult
from launchlint.check.file import INTERNAL_ERROR, run_rule
from launchlint.check.gathered import AtFile, Shown, Standing, gathered
from launchlint.check.ignores import PerFileIgnores
from launchlint.check.known import Known
from launchlint.check.options import Options
from launchlint.check.ours import Ours
from launchlint.finding import Finding, Key
from launchlint.named_tuple import NamedTuple
from launchlint.order import ordered
from launchlint.rules.registry import RULES, find
from launchlint.rules.view import EntrySummary, RunView, SuppressionView
from launchlint.sight import NOTHING, Sight, together
from launchlint.verdict import Verdict
from launchlint.workspace.packages import Packages


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
    entries = [each for each in results if alone or not is_part(each.summary, whole.parts)]
    of_entries = whole.summaries if alone else without(whole.summaries, whole.parts)
    standing = [Standing(each.path, each.outcome, each.sight) for each in entries]
    seen = Seen(gathered(results, entries), of_entries, frozenset(each.path for each in results), standing)
    return told(seen, options, packages, per_file, asked, whole.findings if workspace else ())


class Seen(NamedTuple):
    """What a run has seen: what is told of each file, the entry files without those that are parts of others, all that were ``checked``
    (paths), and how the entry files stand.
    """

    files: Mapping[str, AtFile]
    entries: tuple[EntrySummary, ...]
    checked: frozenset[str]
    standing: Sequence[Standing]


def told(
    seen: Seen, options: Options, packages: Packages, per_file: PerFileIgnores, asked: tuple[str, ...], of_run: Iterable[Finding]
) -> Outcome:
    """What is told of a run; ``of_run`` are the findings about all of it."""
    files = [seen.files[path] for path in sorted(seen.files)]
    collected = [finding for file in files for finding in file.findings]
    own = {finding.key for finding in collected}
    of_text: dict[Key, Finding] = {}  # what several files show at one place counts as it does in the worst of them
    for file in files:
        for finding in file.of_text:
            same = of_text.get(finding.key)
            if finding.key not in own and (same is None or finding.severity > same.severity):
                of_text[finding.key] = finding
    collected += of_text.values()
    if collected:
        from launchlint.check.judges import judged  # a dozen modules that a file without findings does without

        collected = judged(collected, Known(packages, options.root, _shown(files), seen.entries))
    collected += of_run
    collected = list(Ours(options, asked).brought_home(collected))
    crashes = [finding for finding in collected if finding.rule == INTERNAL_ERROR]
    others = _adjust((finding for finding in collected if finding.rule != INTERNAL_ERROR), options, per_file)
    kept, more = _suppress(others, files, options, per_file)
    crashes += more
    verdicts = tuple(sorted({each.path: each.outcome for each in seen.standing}.items()))
    looked_at = {path for path, file in seen.files.items() if file.launches} | seen.checked
    sight = together(each.sight for each in seen.standing)
    return Outcome(tuple(ordered([*kept, *crashes])), len(looked_at), len(seen.standing), bool(crashes), verdicts, sight)


def _shown(files: Iterable[AtFile]) -> dict[Key, Shown]:
    return {key: shown for file in files for key, shown in file.shown.items()}


def without(summaries: Iterable[EntrySummary], parts: frozenset[str]) -> tuple[EntrySummary, ...]:
    """``summaries`` without those of ``parts`` of others."""
    return tuple(each for each in summaries if not is_part(each, parts))


def is_part(summary: EntrySummary, parts: frozenset[str]) -> bool:
    """Whether an entry file is a part of others."""
    return summary.needs_caller and summary.path in parts


def without_parts(results: Sequence[EntryResult]) -> list[EntryResult]:
    """The results without those of files that lack args and that another entry file leads to; see :func:`parts`."""
    left_out = parts([result.summary for result in results])
    return [result for result in results if not is_part(result.summary, left_out)]


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


def _adjust(findings: Iterable[Finding], options: Options, per_file: PerFileIgnores) -> list[Finding]:
    """Severities and per-file ignores as people asked for them."""
    return [
        finding._replace(severity=options.severities.get(finding.rule, finding.severity))
        for finding in findings
        if finding.rule not in per_file.off(finding.location.path)
    ]


def _suppress(
    findings: list[Finding], files: Iterable[AtFile], options: Options, per_file: PerFileIgnores
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

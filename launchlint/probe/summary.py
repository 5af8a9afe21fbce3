"""What a probe did, for people: what was probed, what not and why, and what to do about it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from launchlint.plural import counted
from launchlint.probe.record import LaunchRecord, NodeRecord, Note
from launchlint.probe.run import Outcome

MOST_NAMES = 8
"""Programs named in one line."""

WHY = {
    "arguments-required": ("arguments required", "say by `args` what they are to be started with"),
    "param-required": ("param required", "set it by `params`"),
    "module-missing": ("Python module missing", "install it by `apt` or `pip`"),
    "library-missing": ("shared library missing", "install it by `apt`"),
    "file-missing": ("file missing", "give it by `files`"),
    "display-required": ("display required", ""),
    "device-missing": ("device missing", ""),
    "waits-for-device": ("device waited for", ""),
    "waits-for-service": ("service waited for, of a type that is not installed", "install its package by `apt`"),
    "waits-for-message": ("message waited for, of a type that is not installed", "install its package by `apt`"),
    "waits-for-param": ("param waited for", "set it by `params`"),
    "waits": ("waiting", ""),
    "unsteady": ("different each time", ""),
    "network": ("network required", ""),
    "busy": ("still computing", "give them more time by `limit`"),
    "silent": ("never seen on the graph", "give them more time by `limit` if they are slow to start"),
    "timed-out": ("nothing registered in time", "give them more time by `limit`"),
    "never-quiet": ("something new until the end", "give them more time by `limit`"),
    "too-many-names": ("names without end", ""),
    "too-much-output": ("output without end", ""),
    "too-much-memory": ("memory without end", "allow more by `memory`"),
    "too-much-disk": ("files without end", "allow more by `memory`"),
    "too-many-processes": ("processes without end", ""),
    "too-large": ("interface too large", ""),
    "exception": ("exception", ""),
    "error-logged": ("error reported", ""),
    "not-started": ("cannot be started", ""),
    "odd-names": ("names that no node can have", ""),
    "broke-the-container": ("container taken down", ""),
    "launch-missing": ("no such launch file", "correct `launch`"),
    "ended": ("ended by itself", ""),
    "not-loaded": ("component not loaded", ""),
    "not-configured": ("not configured", "give it the params that it wants by `params`"),
    "not-active": ("not activated", ""),
    "params-unanswered": ("nothing said of its params", ""),
    "observer-ended": ("observer ended", ""),
    "launch-not-run": ("launch file of ROS 2", ""),
}
"""Code of a problem → what it is, and what helps."""


def is_worth_a_failure(outcome: Outcome) -> bool:
    """Whether the exit status shall say that this was not what was asked for: runs are missing, packages are missing or were not built, or
    nothing ran at all.
    """
    ran = any(record.status == "ok" for record in outcome.records)
    missing = any(_is_missing(note) for note in outcome.notes)
    return bool(outcome.lost) or missing or outcome.left > 0 or (bool(outcome.records) and not ran)


def _is_missing(note: Note) -> bool:
    """Whether a note says that something is not there that was asked for: a program, a package, or what a package's build makes."""
    facts = note.facts
    return (
        note.kind == "unknown"
        or (note.kind == "package" and facts["status"] != "found")
        or (note.kind == "build" and facts["result"] != "ok")
    )


def summary(outcome: Outcome, output: str) -> list[str]:
    """The lines of the summary."""
    nodes = [record for record in outcome.records if isinstance(record, NodeRecord)]
    launches = [record for record in outcome.records if isinstance(record, LaunchRecord)]
    ran, failed, none = (_labels(nodes, status) for status in ("ok", "failed", "not-a-node"))
    failed = [label for label in failed if label not in set(ran)]
    loaded = {kind: {record.label for record in nodes if record.program == kind} & set(ran) for kind in ("nodelet", "component")}
    recorded = counted(len(ran) - sum(map(len, loaded.values())), "executable")
    recorded += "".join(f" and {counted(len(labels), kind)}" for kind, labels in loaded.items() if labels)
    programs = f"{counted(len(none), 'program')} {'is' if len(none) == 1 else 'are'} no node{'' if len(none) == 1 else 's'}"
    lines = [f"{output}: {recorded} recorded, {len(failed)} could not be run, {programs}"]
    if launches:
        good = sum(record.status == "ok" for record in launches)
        lines.append(f"{good} of {counted(len(launches), 'launch file')} recorded")
    lines += _grouped("could not be run:", [record for record in outcome.records if record.status == "failed"])
    doubtful = [record for record in outcome.records if record.status == "ok" and record.problems]
    lines += _grouped("recorded, but there may be more to them:", doubtful)
    lines += _notes(outcome.notes)
    count, first = outcome.refused
    if count:
        lines.append(f"{count} lines of the container's output were no records and were left out: {first}")
    if outcome.left:
        lines.append(f"{counted(outcome.left, 'process', 'processes')} could not be ended")
    if outcome.lost:
        lines.append(f"not everything was probed: {outcome.lost}; --resume goes on")
    return lines


def _labels(records: Iterable[NodeRecord], status: str) -> list[str]:
    return sorted({record.label for record in records if record.status == status})


def _grouped(title: str, records: Sequence[NodeRecord | LaunchRecord]) -> list[str]:
    """Runs by their first problem, those with most first."""
    groups: dict[str, dict[str, str]] = {}
    for record in records:
        if record.problems:
            problem = record.problems[0]
            groups.setdefault(problem.code, {})[record.label] = problem.detail
    if not groups:
        return []
    lines = [title]
    for code, found in sorted(groups.items(), key=lambda group: (-len(group[1]), group[0])):
        what, helps = WHY.get(code, (code.replace("-", " "), ""))
        lines.append(f"  {what}: {len(found)}" + (f" ({helps})" if helps else ""))
        lines += [f"    {label}: {detail}" for label, detail in sorted(found.items())[:MOST_NAMES]]
        if len(found) > MOST_NAMES:
            lines.append(f"    and {len(found) - MOST_NAMES} more; the library lists them all")
    return lines


def _notes(notes: Sequence[Note]) -> list[str]:
    lines = []
    for note in notes:
        facts: Mapping[str, object] = note.facts
        if note.kind == "package" and facts["status"] != "found":
            lines.append(f"there is no package {facts['package']}: correct `packages`, or install it by `apt`")
        elif note.kind == "unknown":
            lines.append(f"no probed package has {facts['label']}, which `nodes` or `programs` names")
        elif note.kind == "dependency":
            by = note.facts["needed_by"]
            lines.append(f"{', '.join(by[:MOST_NAMES])}: the dependency {facts['name']} was not installed: {facts['detail']}")
        elif note.kind == "build" and facts["result"] != "ok":
            first = next(iter(note.facts["errors"]), "")
            lines.append(f"{facts['package']}: {'built in part' if facts['result'] == 'partial' else 'not built'}: {first}")
            lines += [f"    {line}" for line in note.facts["log"]]
    return lines

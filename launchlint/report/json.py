"""Findings as one JSON object, for programs."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from launchlint.finding import Finding, Fix, Location
from launchlint.fingerprint import fingerprints
from launchlint.report.escape import no_surrogates
from launchlint.report.run import Run

_SURROGATE = "\\ud"
"""How JSON writes them in ASCII begins so."""


def render(findings: Sequence[Finding], run: Run) -> str:
    """``{"version": 1, "findings": […], "verdicts": […], "sight": {…}}``, each in a line; all severities, whatever ``run.verbose`` says.

    ``verdicts`` has ``file``, ``word`` (``loads``, ``refused`` or ``cannot be told``), ``rule``, ``reason``, ``missing`` and ``elsewhere``
    (the other configurations that roslaunch refuses) for each entry file. ``sight`` says how many ``nodes`` there are
    without args, how many of them are ``known``, and of the ``unknown`` ones the ``program``, the ``reason`` and how many ``nodes`` run it.
    Both are left out where only some rules were asked for, ``sight`` also where no node is started.
    """
    parts = ['"version": 1', f'"findings": [{_lines(objects(findings))}]']
    if run.verdicts:
        parts.append(f'"verdicts": [{_lines([{"file": file, **verdict.as_object()} for file, verdict in run.verdicts])}]')
    if run.sight.nodes:
        parts.append(f'"sight": {dump(run.sight.as_object())}')
    return f"{{{', '.join(parts)}}}\n"


def _lines(items: Sequence[Any]) -> str:
    return "\n" + ",\n".join(map(dump, items)) + "\n" if items else ""


def objects(findings: Sequence[Finding]) -> list[dict[str, Any]]:
    """Each finding, in report order, as a dictionary with the keys that ``check --format json`` documents, in a fixed order."""
    return [_object(finding, mark) for finding, mark in fingerprints(findings)]


def dump(value: Any) -> str:
    """``value`` as JSON in one line of ASCII, without lone surrogates, and without what GitHub takes for a command in a log."""
    text = json.dumps(value, ensure_ascii=True, allow_nan=False)
    if _SURROGATE in text:  # half of a pair, or a whole one
        text = json.dumps(_clean(value), ensure_ascii=True, allow_nan=False)
    return text.replace("##[", "##\\u005b")


def _object(finding: Finding, mark: str) -> dict[str, Any]:
    return {
        "rule": finding.rule,
        "name": finding.name,
        "severity": finding.severity.word,
        **_place(finding.location),
        "message": finding.message,
        "label": finding.label,
        "related": [{**_place(related.location), "label": related.label} for related in finding.related],
        "chain": [_place(step) for step in finding.chain],
        "notes": list(finding.notes),
        "help": finding.help,
        "configuration": dict(finding.arguments),
        "entry": finding.entry,
        "entries": finding.entries,
        "fingerprint": mark,
        "fix": None if finding.fix is None else _fix(finding.fix),
    }


def _place(location: Location) -> dict[str, Any]:
    return {
        "path": location.path,
        "line": location.line,
        "column": location.column,
        "end_line": location.end_line,
        "end_column": location.end_column,
    }


def _fix(fix: Fix) -> dict[str, Any]:
    """``start`` and ``end`` of an edit are offsets in code points from the start of the text; ``changes`` is empty where nothing does."""
    return {"message": fix.message, "safe": fix.safe, "changes": fix.changes, "edits": [edit._asdict() for edit in fix.edits]}


def _clean(value: Any) -> Any:
    if isinstance(value, str):
        return no_surrogates(value)
    if isinstance(value, dict):
        return {_clean(key): _clean(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_clean(item) for item in value]
    return value

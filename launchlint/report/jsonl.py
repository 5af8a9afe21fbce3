"""Findings as JSON lines: one object for each finding, or for each entry of an entries file."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.finding import Finding
from launchlint.report.json import dump, objects
from launchlint.report.run import Run
from launchlint.verdict import Verdict


def render(findings: Sequence[Finding], run: Run) -> str:
    """Each finding in a line of its own, with the keys of the JSON format."""
    return "".join(f"{dump(item)}\n" for item in objects(findings))


def entry_line(file: str, as_: str, verdict: str, findings: Sequence[Finding], outcome: Verdict) -> str:
    """The line, with its line end, for one entry of ``--entries``.

    ``file`` was judged as if it stood at ``as_``; ``verdict`` says whether its launcher would load it: ``ok``, ``error`` or, where that
    cannot be told of a program, ``unknown``. ``outcome`` is what people are told of that: it sets apart what only this machine lacks.
    """
    return dump({"file": file, "as": as_, "verdict": verdict, "outcome": outcome.as_object(), "findings": objects(findings)}) + "\n"

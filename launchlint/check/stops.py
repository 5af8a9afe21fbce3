"""Where the launcher really stops: a note that says so is put right where an earlier line or only another configuration brings it about."""

from __future__ import annotations

from launchlint.check.file import tell
from launchlint.check.verdict import ALL_RULES
from launchlint.dialects.door import named
from launchlint.finding import Finding, Location, Severity
from launchlint.model import ROS1, Launch
from launchlint.problem import Problem

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Set

    from launchlint.evaluate.assemble import Evaluation

STOPS, WOULD = "stops", "would stop"
LOADS = "roslaunch loads the file and fails"
"""Said of ROS 1 only: what cannot be started is no mistake to it."""


def stops_everybody(problem: Problem, view: object) -> bool:
    """Whether the launcher stops at ``problem`` wherever the file is started, not only for want of what this machine lacks."""
    return problem.refused and any(finding.severity is Severity.ERROR for finding in tell(problem, view, ALL_RULES))


def without_tried(evaluation: Evaluation, asked: tuple[tuple[str, str], ...]) -> Evaluation:
    """``evaluation`` of a launch of ROS 2 that nothing refuses merely for a value that the search for configurations gave to an arg.

    ``asked`` are the args it is started with in any case. Nobody need ever give that value: what is wrong with it may never come to pass.
    """
    launch = evaluation.launch
    tried = {value for name, value in launch.given if (name, value) not in asked}
    if launch.dialect == ROS1 or not tried:
        return evaluation
    problems = tuple(each.but(refused=False, assumed=True) if _is_of(each, tried) else each for each in launch.problems)
    refused = launch.refused
    if refused is not None and _is_of(refused, tried):
        refused = next((each for each in problems if each.refused and each not in launch.late), None)
    return evaluation._replace(launch=launch._replace(problems=problems, refused=refused))


def _is_of(problem: Problem, tried: Set[str]) -> bool:
    """Whether it says of one of these values that it does not fit, which does not stand where the problem does."""
    value = vars(problem).get("value")
    return isinstance(value, str) and value in tried and value not in problem.place.text


def put_right(finding: Finding, problem: Problem, before: Problem | None, launch: Launch, asked: tuple[tuple[str, str], ...]) -> Finding:
    """``finding`` about ``problem`` of ``launch``, where ``before`` is an earlier one that stops everybody.

    ``asked`` are the args it is started with in any case; others are what the search tries.
    """
    launcher = named(launch.dialect).launcher
    stops = f"{launcher} {STOPS}"
    fix = finding.fix
    if problem.refused and fix is not None and fix.changes == f"{launcher} loads the file" and _is_stopped_elsewhere(problem, launch):
        finding = finding._replace(fix=fix._replace(changes=f"{launcher} gets past this; something else stops it then"))
    if not problem.refused or not any(note.startswith(stops) for note in finding.notes):
        return finding
    if before is not None and before.origin != problem.origin:
        at = Location.of(before.place)
        return _with(finding, stops, f"{launcher} {WOULD}", (f"{at.path}:{at.line} stops it before that",))
    if launch.given and launch.given != asked:
        given = " ".join(f"{name}:={value}" for name, value in launch.given)
        return _with(finding, stops, f"with {given} {stops}", ())
    return finding


def _is_stopped_elsewhere(problem: Problem, launch: Launch) -> bool:
    """Whether the launcher stops at something of another kind, or in another file, once ``problem`` is mended."""
    others = (each for each in launch.problems if each.refused and each.place.key != problem.place.key)
    return any(type(each) is not type(problem) or each.place.source is not problem.place.source for each in others)


def put_right_later(finding: Finding, before: Problem | None) -> Finding:
    """``finding`` about what roslaunch comes to once it has loaded the file, where ``before`` is a problem that stops everybody."""
    if before is None or not any(note.startswith(LOADS) for note in finding.notes):
        return finding
    at = Location.of(before.place)
    stop = f"roslaunch would fail{{}}; {at.path}:{at.line} stops it before that"
    notes = (stop.format(note.removeprefix(LOADS)) if note.startswith(LOADS) else note for note in finding.notes)
    return finding._replace(notes=tuple(notes))


def said_of(finding: Finding, switched: str) -> Finding:
    """``finding`` about what a launch starts with args that are not the default (``switched``): no error, and they are named in it."""
    if not switched:
        return finding
    finding = finding._replace(severity=min(finding.severity, Severity.WARNING))
    if any(switched in text for text in (finding.message, finding.help, *finding.notes)):
        return finding
    return finding._replace(notes=(*finding.notes, f"so with {switched}, not by default"))


def _with(finding: Finding, stops: str, words: str, more: tuple[str, ...]) -> Finding:
    notes = (words + note.removeprefix(stops) if note.startswith(stops) else note for note in finding.notes)
    return finding._replace(notes=(*notes, *more))

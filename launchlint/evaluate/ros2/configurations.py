"""Every configuration of a ROS 2 launch file that matters: as given, then the fewest further ones that take every branch at least once.

A condition that was not taken (or only taken) is turned by giving another value to one of the args on which it depends. No value is made
up: an arg gets one of its choices, the other boolean where its value is one, and what the files compare it with.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.session import Read, Session
from launchlint.model import Branch, Launch
from launchlint.syntax.ros2.description import Condition, Substitution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.block import Side

Pairs = tuple[tuple[str, str], ...]

MOST_EVALUATIONS = 48
"""Evaluations of one entry file, tried ones included."""
MOST_WORK = 16_000
"""Conditions, nodes, includes and args of all evaluations together: a launch of thousands of nodes is evaluated a few times only."""

_BOOLEANS = {"true": "false", "false": "true", "True": "False", "False": "True", "1": "0", "0": "1"}
_COMPARES = ("eval", "equals", "not-equals", "if")
_QUOTED = re.compile(r"'([^'\\]*)'|\"([^\"\\]*)\"")
_COMPUTED = "\0"
"""Stands for a substitution."""
_PYTHON = ".py"
_ALONE = re.compile(r"\$\(var [\w-]+\)")


def configurations(session: Session, file: str, given: Pairs = ()) -> Iterator[Evaluation]:
    """Evaluate ``file`` as given, then with single args changed until every reachable side of every condition has been seen.

    Args in ``given`` stay as they are. Only configurations that show something new are yielded.
    """
    pinned = frozenset(name for name, _ in given)
    first = evaluate(session, file, given, pinned)
    yield first
    compared = _Compared(session)
    seen = _sides(first)
    tried: set[Pairs] = {()}
    waiting = [first]
    work = _work(first)
    while waiting:
        base = waiting.pop(0)
        before = base.launch.given[len(given) :]
        for branch in _open(base.launch):
            if _side(branch, not branch.taken) in seen:
                continue
            for pair in _candidates(branch, base.launch, compared):
                changes = (*(each for each in before if each[0] != pair[0]), pair)
                if tuple(sorted(changes)) in tried:
                    continue
                tried.add(tuple(sorted(changes)))
                if len(tried) > MOST_EVALUATIONS or work > MOST_WORK:
                    return
                evaluation = evaluate(session, file, (*given, *changes), pinned)
                work += _work(evaluation)
                sides = _sides(evaluation)
                if sides <= seen:
                    continue
                seen |= sides
                yield evaluation
                waiting.append(evaluation)
                if _side(branch, not branch.taken) in seen:
                    break


def _work(evaluation: Evaluation) -> int:
    launch = evaluation.launch
    return len(launch.branches) + len(launch.nodes) + len(launch.includes) + len(launch.declared)


def _open(launch: Launch) -> Iterator[Branch]:
    return (branch for branch in launch.branches if branch.taken is not None and branch.steered_by)


def _side(branch: Branch, taken: bool) -> Side:
    return (branch.element.source.path, branch.element.span.start, branch.attribute, taken)


def _sides(evaluation: Evaluation) -> set[Side]:
    return {_side(branch, branch.taken) for branch in evaluation.launch.branches if branch.taken is not None}


def _candidates(branch: Branch, launch: Launch, compared: _Compared) -> Iterator[tuple[str, str]]:
    """Args with values that may turn the condition."""
    for name in sorted(branch.steered_by):
        declarations = [each for each in launch.declarations if each.argument.name == name]
        value = next((each.argument.value for each in declarations if isinstance(each.argument.value, str)), None)
        values = [choice for each in declarations for choice in each.choices or ()]
        if not values and value is not None and value in _BOOLEANS:
            values = [_BOOLEANS[value]]
        if not values:
            values = [*compared.in_condition(branch.origin.place.key, launch), *compared.with_arg(name, launch)]
        if not values and value is None and _ALONE.fullmatch(branch.text):
            values = ["true", "false"]
        yield from ((name, each) for each in dict.fromkeys(values) if each != value)


class _Literals(NamedTuple):
    """Of one file: what args are compared with, by name, and what stands in comparisons, by the place of the condition."""

    by_name: dict[str, list[str]]
    by_place: dict[tuple[str, int], list[str]]


class _Compared:
    """What is compared in the files that were read."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._by_file: dict[str, _Literals] = {}

    def with_arg(self, name: str, launch: Launch) -> list[str]:
        """The literals that the arg ``name`` is compared with in any file of the launch."""
        return [literal for each in self._all(launch) for literal in each.by_name.get(name, ())]

    def in_condition(self, place: tuple[str, int], launch: Launch) -> list[str]:
        """The literals of one condition."""
        return [literal for each in self._all(launch) for literal in each.by_place.get(place, ())]

    def _all(self, launch: Launch) -> Iterator[_Literals]:
        for file in dict.fromkeys(launch.files):
            if file not in self._by_file:
                reading = None if file.endswith(_PYTHON) else self._session.reading(file)
                known = () if reading is None or isinstance(reading, Read) else reading.description.actions
                self._by_file[file] = _literals_of(known)
            yield self._by_file[file]


def _literals_of(actions: tuple[object, ...]) -> _Literals:
    found = _Literals({}, {})
    waiting: list[object] = list(actions)
    while waiting:
        each = waiting.pop()
        if isinstance(each, Condition):
            compared = [literal for part in _comparisons(each) for literal in _parts(part)[1]]
            if compared:
                found.by_place[each.place.key] = compared
        if isinstance(each, Substitution) and each.name in _COMPARES:
            names, literals = _parts(each)
            for name in names:
                found.by_name.setdefault(name, []).extend(literals)
        if isinstance(each, tuple):
            waiting.extend(part for part in each if isinstance(part, tuple))
    return found


def _comparisons(described: tuple[object, ...]) -> Iterator[Substitution]:
    waiting: list[object] = list(described)
    while waiting:
        each = waiting.pop()
        if isinstance(each, Substitution) and each.name in _COMPARES:
            yield each
        elif isinstance(each, tuple):
            waiting.extend(part for part in each if isinstance(part, tuple))


def _parts(substitution: Substitution) -> tuple[list[str], list[str]]:
    """The names of the args that are read in a comparison, and the literals in it."""
    names: list[str] = []
    literals: list[str] = []
    for text in substitution.arguments:
        written = ""
        for piece in text.pieces:
            if isinstance(piece, str):
                written += piece
                continue
            written += _COMPUTED
            name = piece.arguments[0].literal if piece.name == "var" and piece.arguments else None
            if name is not None:
                names.append(name)
        if substitution.name == "eval":
            literals += [single or double for single, double in _QUOTED.findall(written)]
        else:
            literals.append(written)
    return names, [each for each in literals if each and _COMPUTED not in each]

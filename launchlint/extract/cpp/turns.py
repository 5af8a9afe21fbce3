"""Turns of loops: those that are followed one by one, and those of which nobody knows how many there are.

A turn of a loop of unknown length is followed, and a second one only where the first made names, or left behind what names are made of: in
that one nothing is known of what the first has counted or collected. What is numbered is listed up to a bound.
"""

from __future__ import annotations

from collections.abc import Callable as Does
from collections.abc import Hashable

from launchlint.extract.cpp.naming import ANY, is_loose
from launchlint.extract.cpp.syntax import LONGEST_CONDITION
from launchlint.extract.cpp.values import (
    UNKNOWN,
    Callable,
    Cell,
    Closure,
    Items,
    Null,
    Number,
    Text,
    Thing,
    Unknown,
    Value,
    both,
    choices,
    either,
)
from launchlint.extract.fact import Doubt, Fact

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_MOST_LOOPS = 1
_MOST_NUMBERED = 10
_MOST_STEPS_OF_NUMBERED = 4_000


def telling(machine: Machine, run: Does[[], str]) -> tuple[str, bool]:
    """Follow what is reached for certain; and whether it makes names, or writes what names are made of."""
    told, since = _told(machine), machine.serial
    machine.journals.append({})
    try:
        signal = run()
    finally:
        before = machine.journals.pop()
    if machine.journals:
        for cell, value in before.items():
            machine.journals[-1].setdefault(cell, value)
    return signal, told != _told(machine) or any(_may_tell(cell.value, since) for cell in before)


def _told(machine: Machine) -> tuple[int, int, int]:
    """What has been told by now, in numbers: these grow with all that is."""
    return machine.noted, len(machine.doubts), len(machine.queued)


def once_or_more(machine: Machine, run: Does[[], str], condition: str) -> str:
    """Follow the body of a loop of which nobody knows how often it runs; ``condition`` is the text of what decides that."""
    earlier, machine.facts = machine.facts, {}
    told, since = _told(machine), machine.serial
    signal, before, after = _turn(machine, run)
    first, machine.facts = machine.facts, {}
    counted = [cell for cell, value in after.items() if isinstance(value, (Number, Items)) and isinstance(before[cell], (Number, Items))]
    tells = told != _told(machine) or any(_may_tell(each, since) for each in after.values())
    if counted and tells and machine.loops < _MOST_LOOPS:
        # A second turn, in which what the first one counted or collected is not known.
        doubts = dict(machine.doubts)
        for cell in counted:
            machine.write(cell, UNKNOWN)
        machine.loops += 1
        steps = machine.steps
        try:
            _, _, second = _turn(machine, run)
            unknown, machine.facts = machine.facts, {}
            more = {key: each for key, each in unknown.items() if key not in first}
            if machine.steps - steps < _MOST_STEPS_OF_NUMBERED and any(ANY in each.name for each in more.values()):
                machine.doubts = doubts
                loose = {(each.category, each.path, each.line) for each in more.values() if is_loose(each.name)}
                _numbered(machine, run, condition, after, {key: each for key, each in first.items() if key not in unknown}, loose)
                first = {key: each for key, each in first.items() if key in unknown}
                unknown = {key: each for key, each in unknown.items() if key in first or not is_loose(each.name)}
            first.update(unknown)
        finally:
            machine.loops -= 1
        for cell, value in second.items():
            after[cell] = either([("", after.get(cell, value)), ("", value)])
    machine.facts = {**earlier, **first, **machine.facts}
    for cell, value in after.items():
        machine.write(cell, _after_loop(before.get(cell, cell.value), value))
    return signal


def _numbered(
    machine: Machine,
    run: Does[[], str],
    condition: str,
    after: dict[Cell, Value],
    first: dict[Hashable, Fact],
    loose: set[tuple[str, str, int]],
) -> None:
    """Further turns of a loop that makes numbered names: each of them is there where the loop comes so far.

    ``loose`` are the places whose names have no known beginning, which would tell that there are more of them.
    """
    for key, fact in first.items():
        both_ = both(fact.condition, condition)
        machine.facts[key] = fact._replace(condition=both_ if len(both_) <= 3 * LONGEST_CONDITION else fact.condition)
    machine.conditions.append(condition)
    state = after
    for _ in range(_MOST_NUMBERED - 1):
        for cell, value in state.items():
            machine.write(cell, value)
        _, _, state = _turn(machine, run)
    machine.conditions.pop()
    for category, path, line in loose:
        reason = f"names are numbered, and only {_MOST_NUMBERED} of them listed: {condition}"
        machine.doubts[Doubt(category, reason, path, line)] = None


def _turn(machine: Machine, run: Does[[], str]) -> tuple[str, dict[Cell, Value], dict[Cell, Value]]:
    """One turn of a loop, undone: where it ends, and the variables that it writes with their values before and after."""
    machine.journals.append({})
    horizon, machine.horizon = machine.horizon, machine.serial + 1
    try:
        signal = run()
    finally:
        machine.horizon = horizon
        before = machine.journals.pop()
    after = {cell: cell.value for cell in before}
    for cell, value in before.items():
        cell.value = value
    return signal, before, after


def _after_loop(before: Value, after: Value) -> Value:
    """What a variable holds behind a loop of unknown length that changed it."""
    if isinstance(after, (Items, Number)):
        return UNKNOWN
    if isinstance(after, Text) and isinstance(before, Text) and before.template and after.template.startswith(before.template):
        return UNKNOWN
    if isinstance(before, (Unknown, Null)) or before == Text(""):
        return after
    return either([("", after), ("", before)])


def _may_tell(value: Value, since: int) -> bool:
    """Whether a value that a turn of a loop leaves behind may be part of a name, or make one: a number is that of this turn only.

    Of the objects only those may that were made ``since``; and of them those of the program, as others are told when they are made.
    """
    for _, each in choices(value):
        for one in each.items if isinstance(each, Items) else (each,):
            if isinstance(one, (Text, Callable, Closure)) or (isinstance(one, Thing) and one.declared is not None and one.serial > since):
                return True
    return False

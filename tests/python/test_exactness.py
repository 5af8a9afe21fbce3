"""Generated programs: what the interpreter says of them is what Python makes of them, or that it is not known."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from itertools import product
from pathlib import Path
from random import Random
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from launchlint.python.failures import Raised
from launchlint.python.memory import ENDED, Exhausted
from launchlint.python.plain import Key
from launchlint.python.source import parse_text
from launchlint.python.values import (
    MISSING,
    Choice,
    Class,
    Failure,
    Function,
    Instance,
    Map,
    Seq,
    Text,
    Unknown,
    Value,
    is_maybe,
)
from tests.python.programs import NAMES, Programs
from tests.python.test_interpreter import Noting

MOST_FLAGS = 4


class Exactly(Noting):
    """Follows to the letter."""

    exact = True


class Ran:
    """What came of a program: its variables, or the name of the exception that it ended with."""

    def __init__(self, variables: dict[str, Any], error: str) -> None:
        self.variables = variables
        self.error = error


def python(text: str, flags: list[bool]) -> Ran:
    """What Python makes of a program that was generated here; ``flag()`` gives one of ``flags`` after the other."""
    waiting = iter(flags)
    variables: dict[str, Any] = {"flag": lambda: next(waiting, False)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            exec(compile(text, "generated", "exec"), variables)  # noqa: S102  # the text is made here
        except Exception as error:
            return Ran(variables, type(error).__name__)
    return Ran(variables, "")


def followed(text: str, tmp_path: Path) -> tuple[Exactly, dict[Any, Value], str]:
    """The interpreter, the variables, and the exception; ``?`` where there may be one, ``!`` where there is one of some kind."""
    run = Exactly(str(tmp_path))
    program = f"import shop\nflag = shop.flag\n{text}"
    main = run.main(str(tmp_path / "program.py"), parse_text(program))
    flow = run.execute(parse_text(program).tree.body, main.scope)
    ways = run.settle(0, flow)
    may_end = any(way.flow == ENDED for _, way in ways)
    run.unite([way for way in ways if way[1].flow != ENDED] or ways, main.scope.variables)
    if flow == ENDED and len(ways) == 1:
        raised = run.raised
        value = raised.value if isinstance(raised, Raised) else None
        name = value.type.name.removeprefix("builtins.") if isinstance(value, Failure) else "?"
        return run, main.scope.variables, "!" if run.risks else name
    return run, main.scope.variables, "?" if may_end or run.risks else ""


def covers(value: Value, real: Any, depth: int = 0) -> bool:
    """Whether what is said of a value is true of the real one."""
    if isinstance(value, (Unknown, Text)) or depth > 20:
        return True
    if isinstance(value, Choice):
        return any(covers(each, real, depth + 1) for _, each in value.alternatives)
    if isinstance(value, Seq):
        return _covers_items(value, real, depth)
    if isinstance(value, Map):
        return _covers_entries(value, real, depth)
    if isinstance(value, (Function, Class, Instance, Failure)):
        return not isinstance(real, (str, int, float, list, dict, tuple, set, type(None)))
    if isinstance(value, (str, int, float, type(None))):
        return type(value) is type(real) and (value == real or value != value)
    return True


_KINDS = {"list": list, "tuple": tuple, "set": set, "frozenset": frozenset, "range": range}


def _covers_items(value: Seq, real: Any, depth: int) -> bool:
    if value.kind not in _KINDS:
        return not isinstance(real, (str, int, float, list, dict, tuple, set, type(None)))
    if type(real) is not _KINDS[value.kind]:
        return False
    if not value.complete:
        return True
    if value.kind in ("set", "frozenset"):
        return all(any(covers(each, item, depth + 1) for each in value.items) for item in real)
    return _aligned(value.items, list(real), depth)


def _aligned(items: list[Value], real: list[Any], depth: int) -> bool:
    if not items:
        return not real
    first, *rest = items
    if real and covers(first, real[0], depth + 1) and _aligned(rest, real[1:], depth):
        return True
    return is_maybe(first) and _aligned(rest, real, depth)


def _covers_entries(value: Map, real: Any, depth: int) -> bool:
    if not isinstance(real, dict):
        return False
    entries = {(key.items if isinstance(key, Key) else key): each for key, each in value.entries.items()}
    if value.complete and any(key not in entries for key in real):
        return False
    return all(covers(each, real[key], depth + 1) if key in real else is_maybe(each) or not value.complete for key, each in entries.items())


def check(text: str, tmp_path: Path) -> bool:
    """Compare for every answer of ``flag()``; whether all was known."""
    try:
        run, variables, error = followed(text, tmp_path)
    except Exhausted:
        return False
    for flags in _answers(text):
        real = python(text, flags)
        if error == "!":
            assert real.error, f"an error is said, none came of\n{text}"
        elif error not in ("", "?"):
            assert real.error == error, f"{error} is said, {real.error or 'no error'} came of\n{text}"
        elif real.error:
            assert error == "?", f"no error is said, {real.error} came of\n{text}"
        if real.error:
            continue
        for name in NAMES:
            value = variables.get(name, MISSING)
            assert name not in real.variables or covers(value, real.variables[name]), (
                f"{name} is said to be {shown(value)}, and is {real.variables[name]!r} (flags {flags}) in\n{text}"
            )
    return run.risks == 0


def shown(value: Value, depth: int = 0) -> str:
    if depth > 5:
        return "and so on"
    if isinstance(value, Seq):
        return f"{value.kind}{[shown(each, depth + 1) for each in value.items]}{'' if value.complete else '…'}"
    if isinstance(value, Map):
        return f"{ {key: shown(each, depth + 1) for key, each in value.entries.items()} }{'' if value.complete else '…'}"
    if isinstance(value, Choice):
        return f"one of {[shown(each, depth + 1) for _, each in value.alternatives]}"
    return repr(value)


def _answers(text: str) -> Iterator[list[bool]]:
    asked = min(text.count("flag()"), MOST_FLAGS)
    if "for " in text or "while " in text or "def " in text:
        asked = min(asked * 3, MOST_FLAGS + 2)
    for answers in product((False, True), repeat=asked):
        yield list(answers)


@settings(max_examples=80, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(seed=st.integers(0, 1 << 32))
def test_a_program_over_values_that_are_known(seed: int, tmp_path_factory: pytest.TempPathFactory) -> None:
    check(Programs(Random(seed), 0).program(), tmp_path_factory.getbasetemp())


@settings(max_examples=80, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(seed=st.integers(0, 1 << 32))
def test_a_program_that_asks_for_what_nobody_knows(seed: int, tmp_path_factory: pytest.TempPathFactory) -> None:
    check(Programs(Random(seed), MOST_FLAGS).program(), tmp_path_factory.getbasetemp())


def test_most_of_what_is_known_is_known(tmp_path: Path) -> None:
    known = sum(check(Programs(Random(seed), 0).program(), tmp_path) for seed in range(50))
    assert known > 25

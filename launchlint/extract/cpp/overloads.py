"""Which of several functions of one name a call means, and which functions are worth following."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

from launchlint.extract.cpp.declarations import Class, Function
from launchlint.extract.cpp.relevance import Relevance
from launchlint.extract.cpp.spelled_type import DOUBLES, INTEGERS, POINTERS, TEXTS, Type
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import UNKNOWN, Argument, Callable, Closure, Handle, Number, Text, Thing, choices

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_WORD = re.compile(r"[A-Za-z_]\w*")
_KINDS = (TEXTS, DOUBLES, INTEGERS, frozenset(("bool",)))
_ANY_TYPE = 2
"""How well a parameter fits whose type is one of the function's own template: better than what has to be converted."""


def chosen(machine: Machine, functions: Sequence[Function], given: Sequence[Argument] | None, this: Thing | None) -> Function | None:
    """The overload that fits the arguments best; None of them known: the first that has a body."""
    candidates = [each for each in functions if each.body is not None]
    if len(candidates) <= 1 or given is None:
        return candidates[0] if candidates else None
    best, most = candidates[0], -1_000
    for function in candidates:
        score = _fit(machine, function, given)
        if score > most:
            best, most = function, score
    return best


def twins(machine: Machine, function: Function) -> list[Function]:
    """The definitions of a function in one file, of which the preprocessor leaves one (``#ifdef ROS1``); those worth following, if any is.

    No more than one where the file defines it once.
    """
    listed = machine.declarations.functions.get(function.name, ())
    if len(listed) < 2 or function.body is None:
        return [function]
    types = [each.type for each in function.parameters]
    same = [
        each
        for each in listed
        if each.body is not None
        and each.path == function.path
        and each.template == function.template
        and each.of_constant == function.of_constant
        and [one.type for one in each.parameters] == types
    ]
    if len(same) < 2:
        return [function]
    return [each for each in same if is_relevant(machine, each)] or [function]


def _fit(machine: Machine, function: Function, given: Sequence[Argument]) -> int:
    parameters = function.parameters
    defaults = with_defaults(machine, function)
    needed = sum(1 for position, each in enumerate(parameters) if each.default is None and position not in defaults)
    score = 0
    if not needed <= len(given) <= len(parameters):
        score -= 100
    for parameter, argument in zip(parameters, given, strict=False):
        score += _ANY_TYPE if parameter.type.name in function.template else _fits(parameter.type, argument)
    return score


def _fits(type_: Type, argument: Argument) -> int:
    name, value = type_.name, argument.value
    first = choices(value)[0][1] if choices(value) else UNKNOWN
    if isinstance(first, Text):
        return 4 if name in TEXTS else -3 if name in DOUBLES or name in INTEGERS or name == "bool" or "NodeHandle" in name else 0
    if isinstance(first, Number):
        if isinstance(first.value, bool):
            return 4 if name == "bool" else 0 if name in INTEGERS else -2
        exact, converted = (DOUBLES, INTEGERS) if isinstance(first.value, float) else (INTEGERS, DOUBLES)
        return 4 if name in exact else 2 if name in converted else 1 if name == "bool" else -3
    if isinstance(first, Handle):
        called = "NodeHandle" if first.node is None else "Node"
        return 4 if called in name or (type_.arguments and called in type_.arguments[0].name) else -4
    if isinstance(first, Thing):
        inner = type_.arguments[0].last if type_.name in POINTERS and type_.arguments else type_.last
        return 4 if inner == first.type.last else -2 if name in TEXTS or name in DOUBLES or name in INTEGERS else 0
    if isinstance(first, (Callable, Closure)):
        return 3 if "function" in name else -2 if name in TEXTS or name in INTEGERS else 0
    declared = "" if argument.cell is None else argument.cell.type.name
    return _of_one_kind(name, declared) if first is UNKNOWN and declared else 0


def _of_one_kind(name: str, declared: str) -> int:
    """How well a parameter fits a variable of which only the type is known."""
    kinds = [next((kind for kind in _KINDS if each in kind), frozenset((each,))) for each in (name, declared)]
    if kinds[0] == kinds[1]:
        return 4
    plain = [kind in _KINDS for kind in kinds]
    return 0 if not all(plain) else -3 if TEXTS in kinds else 1


def with_defaults(machine: Machine, function: Function) -> dict[int, Node]:
    """Default arguments that stand in the prototype of a function."""
    found: dict[int, Node] = {}
    for other in machine.declarations.functions.get(function.name, []):
        if other is not function and len(other.parameters) == len(function.parameters):
            for position, parameter in enumerate(other.parameters):
                if parameter.default is not None:
                    found.setdefault(position, parameter.default)
    return found


def is_relevant(machine: Machine, function: Function) -> bool:
    """Whether a function, or one that it calls, may have to do with names of ROS; told by words alone."""
    if function.relevant is None and function.body is not None:
        Relevance(machine.declarations, machine.names, machine.tables, machine.foreign.words_among)
    return bool(function.relevant)


def tells(machine: Machine, function: Function) -> bool:
    """Whether a function itself may make names of ROS; told by its words alone."""
    return function.body is not None and telling(machine, function.body.text)


def telling(machine: Machine, text: str) -> bool:
    """Whether a piece of source may make names of ROS; told by its words alone."""
    words = machine.tables.words
    if any(word in words and word not in machine.tables.silent_words for word in words_of(text)):
        return True
    return any(name in text for name in machine.tables.qualified)


@lru_cache(maxsize=8192)
def words_of(text: str) -> tuple[str, ...]:
    """The words of a piece of source, each once, in the order of the source."""
    return tuple(dict.fromkeys(_WORD.findall(text)))


def talks(machine: Machine, declared: Class) -> bool:
    """Whether a function of the class may have to do with names of ROS."""
    return any(is_relevant(machine, each) for _, found in machine.declarations.members(declared.name) for each in found if each.body)

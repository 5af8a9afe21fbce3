"""What an attribute came to before: with the same values of the args in it, it comes to the same, in whatever configuration.

Kept is what hangs on nothing but these args and the packages, and of which there is no more to be told than that a package is not here.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from launchlint.evaluate.block import Value
from launchlint.evaluate.problems import PackageNotFound
from launchlint.evaluate.ros1.scope import Context
from launchlint.evaluate.ros1.substitution import resolve
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem
from launchlint.source import Span
from launchlint.syntax.parts import Parts, Substitution
from launchlint.syntax.tree import Attribute
from launchlint.workspace.looking import Looked, note, watched

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    from launchlint.evaluate.ros1.file import FileEvaluation

Given: TypeAlias = "tuple[Value | None, ...]"
"""The values of the args that an attribute reads, ``None`` for one that has none."""

MOST_KEPT = 100
"""Results for one attribute: no real one has more, and it bounds memory."""


class _Kept(NamedTuple):
    """A result, what it cost in elements looked at, what was told of it for the entry file, and what was looked at for it."""

    value: Value
    cost: int
    problems: tuple[Problem, ...]
    entry: str
    looked: Looked


class KeptValues:
    """What one attribute, taken apart into ``parts``, came to. ``reads`` are the args in it."""

    __slots__ = ("_names", "reads", "values")

    def __init__(self, parts: Parts) -> None:
        self.reads = _reads(parts)
        self._names = tuple(self.reads)
        self.values: dict[Given, _Kept] = {}

    def given(self, arguments: Mapping[str, Value]) -> Given:
        """What the value hangs on."""
        return tuple(map(arguments.get, self._names))

    def keep(self, given: Given, kept: _Kept) -> None:
        """Note what it came to."""
        if len(self.values) >= MOST_KEPT:
            self.values.clear()
        self.values[given] = kept


def resolved(file: FileEvaluation, attribute: Attribute, parts: Parts, context: Context, offset: int = 0) -> Value:
    """The value of ``parts``, which stand in ``attribute`` from ``offset`` on."""

    def where(start: int, end: int) -> Span:
        return attribute.span_of(start + offset, end + offset)

    value = resolve(file, parts, where, context)
    file.notice_left_over(parts, where)
    return value


def kept_value(file: FileEvaluation, attribute: Attribute, parts: Parts, context: Context) -> Value:
    """As :func:`resolved`, for the whole of ``attribute``; worked out once where it is the same each time."""
    known = file.session.values.get(attribute)
    if known is None:
        known = file.session.values[attribute] = KeptValues(parts)
    given = known.given(context.arguments)
    kept = known.values.get(given)
    if kept is None or (kept.problems and kept.entry != file.entry):
        return _resolved_and_kept(file, attribute, parts, context, known, given)
    note(kept.looked)
    if kept.cost:
        file.spend(kept.cost, attribute.value_span)
    for problem in kept.problems:
        file.record(problem)
    file.reads |= known.reads
    return kept.value


def _resolved_and_kept(
    file: FileEvaluation, attribute: Attribute, parts: Parts, context: Context, known: KeptValues, given: Given
) -> Value:
    block, looked_at, effects = file.block, file.progress.looked_at, len(file.block.effects)
    reads, file.reads = file.reads, set()
    missing, block.missing = block.missing, {}
    try:
        value, looked = watched(partial(resolved, file, attribute, parts, context))
        problems = tuple(effect for effect in block.effects[effects:] if isinstance(effect, PackageNotFound))
        if (
            file.reads == known.reads
            and len(problems) == len(block.effects) - effects
            and not (problems and file.assumed)
            and not (block.missing or block.near or block.anonymous)
        ):
            known.keep(given, _Kept(value, file.progress.looked_at - looked_at, problems, file.entry, looked))
    finally:
        file.reads |= reads
        for name, places in block.missing.items():
            missing.setdefault(name, places)
        block.missing = missing
    return value


def _reads(parts: Parts) -> frozenset[str]:
    """The args in a value, if they and packages are all that it is made of."""
    expression = parts.expression
    if expression is not None:
        from launchlint.evaluate.ros1.expression import arguments_read

        return arguments_read(expression.code)
    return frozenset(part.only for part in parts.parts if isinstance(part, Substitution) and part.command == "arg")

"""Comprehensions and generator expressions, and what loops go through."""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence

from launchlint.python.conditions import written
from launchlint.python.containers import keys_of
from launchlint.python.letter import LATER, ToTheLetter
from launchlint.python.values import (
    MISSING,
    UNKNOWN,
    UNORDERED,
    Choice,
    Map,
    Scope,
    Seq,
    Unknown,
    Value,
    alike,
    alternatives,
    conjunction,
    is_maybe,
)

MOST_ROUNDS = 64


class Comprehensions(ToTheLetter):
    """Loops in expressions."""

    def assign(self, target: ast.expr, value: Value, scope: Scope) -> None:
        """Write to a variable, attribute, item or several of them."""
        raise NotImplementedError

    def _comprehension(self, node: ast.ListComp | ast.SetComp | ast.GeneratorExp, scope: Scope) -> Value:
        found: list[Value] = []
        inner = Scope(scope.module, scope)
        inner.around = scope
        if self.exact and isinstance(node, ast.GeneratorExp):
            return self._generator(node, inner, scope)
        over: Value = MISSING
        kind = "list"
        if self.exact:
            over = self.evaluate(node.generators[0].iter, scope)
            if isinstance(over, Seq) and over.kind in UNORDERED and over.is_sure and len(over.items) > 1:
                over, kind = Seq(list(over.items)), "listing"
        complete = self._generate(node.generators, inner, lambda: found.append(self.evaluate(node.elt, inner)), found, over)
        kind = kind if len(found) > 1 else "list"
        if isinstance(node, ast.SetComp):
            return self.make_set(found, complete)
        return Seq(found, complete, kind=kind) if self.exact else alike(Seq(found, complete, kind=kind))

    def _generator(self, node: ast.GeneratorExp, inner: Scope, scope: Scope) -> Value:
        """A generator: what it goes through is worked out now, the rest when something is taken of it."""
        first = self.evaluate(node.generators[0].iter, scope)
        kind = "iterator"
        if isinstance(first, Seq) and first.kind in UNORDERED and first.is_sure and LATER not in first.content and len(first.items) > 1:
            first, kind = Seq(list(first.items)), "listing"

        def later() -> tuple[list[Value], bool]:
            found: list[Value] = []
            complete = self._generate(node.generators, inner, lambda: found.append(self.evaluate(node.elt, inner)), found, first)
            return found, complete

        made = Seq([], kind=kind)
        made.content[LATER] = later
        return made

    def _mapping_comprehension(self, node: ast.DictComp, scope: Scope) -> Value:
        entries: dict[Value, Value] = {}
        inner = Scope(scope.module, scope)
        inner.around = scope
        unhashable: list[bool] = []

        def take() -> None:
            keys, value = self.evaluate(node.key, inner), self.evaluate(node.value, inner)
            for condition, each in (("", keys),) if self.exact else alternatives(keys):
                key = self.key(each)
                if key is not MISSING:
                    entries[key] = Choice(((condition, value),)) if condition and not is_maybe(value) else value
                else:
                    unhashable.append(True)

        complete = self._generate(node.generators, inner, take, entries)
        made = Map(entries, complete and not unhashable)
        return made if self.exact or unhashable else alike(made)

    def _generate(
        self,
        generators: Sequence[ast.comprehension],
        scope: Scope,
        take: Callable[[], None],
        found: list[Value] | dict[Value, Value],
        over: Value = MISSING,
    ) -> bool:
        """Go through the loops of a comprehension; whether all of their rounds were gone through. What only may be found says so."""
        if not generators:
            take()
            return True
        first = generators[0]
        items, complete = self.rounds_of_each(self.evaluate(first.iter, scope) if over is MISSING else over)
        for item in items:
            mark, count = len(self.conditions), len(found)
            conditions = []
            if self.exact and is_maybe(item):
                said, item = item.alternatives[0]
                conditions.append(said)
            self.assign(first.target, item, scope)
            skipped = False
            for test in first.ifs:
                known = self.truth(self.evaluate(test, scope))
                skipped = skipped or known is False
                if skipped:
                    break
                if known is None:
                    complete = complete and self.exact
                    conditions.append(written(test))
                    self.conditions.append(written(test))
            if not skipped and conditions and self.exact:
                inner: list[bool] = []
                ways = [(" and ".join(conditions), lambda inner=inner: inner.append(self._generate(generators[1:], scope, take, found)))]
                self.either([*ways, ("", None)], scope)
                complete = complete and inner == [True]
            elif not skipped:
                complete = self._generate(generators[1:], scope, take, found) and complete
            if not skipped:
                if conditions and self.exact and isinstance(found, list):
                    found[count:] = [each if is_maybe(each) else Choice(((" and ".join(conditions), each),)) for each in found[count:]]
                elif conditions and self.exact:
                    complete = False
            del self.conditions[mark:]
        return complete

    def rounds_of_each(self, value: Value) -> tuple[list[Value], bool]:
        """What a loop takes of a value that is one of several, each under its condition; of any other what :meth:`rounds` says."""
        if self.exact or not isinstance(value, Choice) or not all(condition for condition, _ in value.alternatives):
            return self.rounds(value)
        found: list[Value] = []
        complete = True
        for condition, each in value.alternatives:
            items, whole = self.rounds(each)
            complete = complete and whole
            for item in items:
                said = tuple((conjunction((condition, inner)), one) for inner, one in alternatives(item))
                found.append(item if isinstance(item, Unknown) else Choice(said))
        return (found, complete) if len(found) <= MOST_ROUNDS else ([UNKNOWN], False)

    def rounds(self, value: Value) -> tuple[list[Value], bool]:
        """What a loop over ``value`` takes, and whether that is everything; one unknown thing where nothing is known."""
        if self.exact:
            return self._rounds_exactly(value)
        if isinstance(value, Seq) and len(value.items) <= MOST_ROUNDS:
            if value.complete or value.is_alike:
                return value.items, value.complete
            return [*value.items, UNKNOWN], False
        if isinstance(value, Map) and (value.complete or value.is_alike) and len(value.entries) <= MOST_ROUNDS:
            return keys_of(value), value.complete
        if isinstance(value, str) and len(value) <= MOST_ROUNDS:
            return list(value), True
        return [UNKNOWN], False

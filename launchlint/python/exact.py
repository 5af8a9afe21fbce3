"""Statements of a program that is followed to the letter: one way where all is known, else several that come together again."""

from __future__ import annotations

import ast
from collections.abc import Callable

from launchlint.python.conditions import negated, written
from launchlint.python.definitions import Definitions
from launchlint.python.failures import Raised, failure, is_failure_class, taken_by
from launchlint.python.matching import Matching
from launchlint.python.memory import BROKEN, CONTINUED, ENDED, GOES_ON, Branch, Ended
from launchlint.python.orders import alike, are_permuted, is_in_any_order, orders
from launchlint.python.recogniser import Recogniser
from launchlint.python.values import (
    COMPLETE,
    ENTRIES,
    ITEMS,
    KIND,
    MISSING,
    UNKNOWN,
    Bound,
    Choice,
    Class,
    External,
    Failure,
    Instance,
    Scope,
    Seq,
    Value,
    conjunction,
    is_maybe,
)
from launchlint.python.ways import Way

Loop = ast.For | ast.AsyncFor | ast.While
MOST_IN_ANY_ORDER = 300
"""Items of a set that a loop goes through in several orders, to see what does not hang on the order."""
MOST_LEFT = 16
"""How often some way may leave a loop early, before the rest of its rounds counts as unknown: each time there is one way more to follow."""


class Exact(Definitions):
    """Conditions, loops and exceptions."""

    def __init__(self, recogniser: Recogniser) -> None:
        super().__init__(recogniser)
        self._handled: list[Ended] = []

    def if_exactly(self, node: ast.If, scope: Scope) -> int:
        """``if``."""
        known = self.truth(self.evaluate(node.test, scope))
        if known is not None:
            return self.execute(node.body if known else node.orelse, scope)
        said = written(node.test)
        first = self.ways(said, lambda: self.execute(node.body, scope))
        second = self.ways(negated(said), lambda: self.execute(node.orelse, scope))
        return self.meet([*first, *second], scope.variables)

    # -- loops --------------------------------------------------------------------------------------------------------

    def for_exactly(self, node: ast.For | ast.AsyncFor, scope: Scope) -> int:
        """``for``."""
        value = self.evaluate(node.iter, scope)
        if is_in_any_order(value) and len(value.items) <= MOST_IN_ANY_ORDER:
            return self._in_any_order(node, value, scope)
        if not isinstance(value, Choice) or isinstance(node, ast.AsyncFor):
            return self._loop(node, UNKNOWN if isinstance(node, ast.AsyncFor) else value, scope)
        ways = [way for condition, each in value.alternatives for way in self.ways(condition, self._looping(node, each, scope))]
        if is_maybe(value):
            ways.append((negated(value.alternatives[0][0]), Branch()))
        return self.meet(ways, scope.variables)

    def _in_any_order(self, node: ast.For | ast.AsyncFor, value: Seq, scope: Scope) -> int:
        """A loop over what comes in an order that is nobody's: what does not hang on the order is known all the same."""
        tried = [self.ways("", self._looping(node, Seq(each), scope)) for each in orders(value.items)]
        if any(len(ways) > 1 or ways[0][1].flow != GOES_ON for ways in tried):
            return self.meet([(f"it is order {at}", way) for at, ways in enumerate(tried, 1) for _, way in ways], scope.variables)
        written = [ways[0][1].written for ways in tried]
        for place, (mapping, key, first) in written[0].items():
            values = [each[place][2] for each in written if place in each]
            if len(values) < len(written) or all(alike(first, each) for each in values[1:]):
                self.store(mapping, key, first)
            elif key == ITEMS and all(are_permuted(first, each) for each in values[1:]):
                self.store(mapping, ITEMS, first)
                self.store(mapping, KIND, "listing")
            else:
                self.store(
                    mapping, key, self.merged(key, [(f"the machine lists them in order {at}", each) for at, each in enumerate(values, 1)])
                )
        return GOES_ON

    def _looping(self, node: ast.For | ast.AsyncFor, value: Value, scope: Scope) -> Callable[[], int]:
        return lambda: self._loop(node, value, scope)

    def _loop(self, node: ast.For | ast.AsyncFor, value: Value, scope: Scope) -> int:
        items, complete = self.rounds(value)
        mark, flow = self.opened, GOES_ON
        if not complete:
            return self._unknown_rounds(node, lambda: self.assign(node.target, UNKNOWN, scope), scope)
        for item in items:
            self.step()
            if self.opened - mark > MOST_LEFT:
                flow = self._unknown_rounds(node, lambda: self.assign(node.target, UNKNOWN, scope), scope, alone=False)
                break
            flow = self._round(node, item, scope)
            if flow:
                break
        return self._end_loop(node, mark, flow, scope)

    def _round(self, node: ast.For | ast.AsyncFor, item: Value, scope: Scope) -> int:
        """One round of a loop; the ways that leave the loop stay open."""
        mark = self.opened
        if not isinstance(item, Choice):
            flow = self._body(node, item, scope)()
            return self._end_round(mark, flow, scope)
        ways = [way for condition, each in item.alternatives for way in self.ways(condition, self._body(node, each, scope))]
        if is_maybe(item):
            ways.append((negated(item.alternatives[0][0]) if item.alternatives[0][0] else "", Branch()))
        return self._meet_round(ways, scope)

    def _body(self, node: ast.For | ast.AsyncFor, item: Value, scope: Scope) -> Callable[[], int]:
        def run() -> int:
            try:
                self.assign(node.target, item, scope)
            except Ended as error:
                self.raised = error
                return ENDED
            return self.execute(node.body, scope)

        return run

    def _end_round(self, mark: int, flow: int, scope: Scope) -> int:
        if self.opened > mark:
            return self._meet_round(self.settle(mark, flow), scope)
        return GOES_ON if flow == CONTINUED else flow

    def _meet_round(self, ways: list[Way], scope: Scope) -> int:
        for _, way in ways:
            if way.flow == CONTINUED:
                way.flow = GOES_ON
        return self.meet(ways, scope.variables)

    def _end_loop(self, node: Loop, mark: int, flow: int, scope: Scope) -> int:
        if flow == BROKEN:
            flow = GOES_ON
        elif flow == GOES_ON and node.orelse:
            flow = self.execute(node.orelse, scope)
        if self.opened == mark:
            return flow
        ways = self.settle(mark, flow)
        for _, way in ways:
            if way.flow == BROKEN:
                way.flow = GOES_ON
        return self.meet(ways, scope.variables)

    def while_exactly(self, node: ast.While, scope: Scope) -> int:
        """``while``; its bound is that of all steps."""
        mark, flow = self.opened, GOES_ON
        while True:
            self.step()
            known = self.truth(self.evaluate(node.test, scope))
            if known is None or (known and self.opened - mark > MOST_LEFT):
                flow = self._unknown_rounds(node, lambda: None, scope)
                break
            if not known:
                break
            inner = self.opened
            flow = self._end_round(inner, self.execute(node.body, scope), scope)
            if flow:
                break
        return self._end_loop(node, mark, flow, scope)

    def _unknown_rounds(self, node: Loop, begin: Callable[[], None], scope: Scope, *, alone: bool = True) -> int:
        """A loop of which it is not known how many rounds it has: what it writes is not known in any of them.

        ``alone``: there were no rounds before, so that the ``else`` of a ``for`` is executed here.
        """
        test = node.iter if isinstance(node, (ast.For, ast.AsyncFor)) else node.test
        said = " ".join(f"for {ast.unparse(node.target)} in {written(test)}".split()) if not isinstance(node, ast.While) else written(test)

        def body() -> int:
            begin()
            return self.execute(node.body, scope)

        tried = self.ways(said, body)
        for _, way in tried:
            for mapping, key, _value in list(way.written.values()):
                self._forget(mapping, key)
        ways = self.ways(said, body)
        for _, way in ways:
            for mapping, key, value in list(way.written.values()):
                if key == ITEMS:
                    before = mapping.get(ITEMS) or []
                    found = [
                        each if any(each is other for other in before) or is_maybe(each) else Choice(((said, each),)) for each in value
                    ]
                    way.written[id(mapping), ITEMS] = (mapping, ITEMS, found)
            if way.flow in (BROKEN, CONTINUED):
                way.flow = GOES_ON
        flow = self.meet([*ways, (negated(said), Branch())], scope.variables)
        orelse = node.orelse if alone and isinstance(node, (ast.For, ast.AsyncFor)) else []
        return self.execute(orelse, scope) if flow == GOES_ON and orelse else flow

    def _forget(self, mapping: dict[Value, Value], key: Value) -> None:
        """What a loop writes, before its rounds that are not known."""
        if key in (ITEMS, COMPLETE, KIND):
            self.store(mapping, COMPLETE, False)
        elif key == ENTRIES:
            self.store(mapping, ENTRIES, dict.fromkeys(mapping[ENTRIES], UNKNOWN))
            self.store(mapping, COMPLETE, False)
        else:
            self.store(mapping, key, UNKNOWN)

    # -- exceptions ---------------------------------------------------------------------------------------------------

    def raise_exactly(self, node: ast.Raise, scope: Scope) -> int:
        """``raise``."""
        if node.exc is None:
            raise self._handled[-1] if self._handled else failure("RuntimeError", "No active exception to reraise")
        value = self.evaluate(node.exc, scope)
        if is_failure_class(value) or isinstance(value, Class):
            value = self.call(value, [], {}, node, scope)
        if node.cause is not None:
            self.evaluate(node.cause, scope)
        if not isinstance(value, (Failure, Instance)):
            raise Ended
        cause = self._handled[-1] if self._handled else None  # in its handler: the program says in its own words what is not there
        raised = Raised(value, stated=True, asked=cause.asked if isinstance(cause, Raised) else None)
        raised.where.append((node, scope))
        raise raised

    def assert_exactly(self, node: ast.Assert, scope: Scope) -> int:
        """``assert``."""
        known = self.truth(self.evaluate(node.test, scope))
        if known is False:
            said = () if node.msg is None else (self.evaluate(node.msg, scope),)
            raised = Raised(Failure(External("builtins.AssertionError"), said), stated=True)
            raised.where.append((node, scope))
            raise raised
        self.risks += known is None
        return GOES_ON

    def try_exactly(self, node: ast.Try, scope: Scope) -> int:
        """``try``."""
        risks = self.risks
        found: list[Way] = []
        self.catching += 1
        try:
            body = self.ways("", lambda: self.execute(node.body, scope))
        finally:
            self.catching -= 1
        risky = self.risks > risks
        for condition, way in body:
            if risky and node.handlers:
                found += self._may_fail(node, condition, way, scope)
            if way.flow == ENDED:
                found += self._handlers(node, condition, way, scope)
            else:
                found += self._on_top(condition, way, node.orelse, scope) if way.flow == GOES_ON and node.orelse else [(condition, way)]
        if node.finalbody:
            found = [each for condition, way in found for each in self._finally(condition, way, node, scope)]
        return self.meet(found, scope.variables)

    def _on_top(self, condition: str, way: Branch, body: list[ast.stmt], scope: Scope) -> list[Way]:
        """What is done behind a way."""

        def run() -> int:
            self.apply(way)
            return self.execute(body, scope)

        return self.ways(condition, run)

    def _finally(self, condition: str, way: Branch, node: ast.Try, scope: Scope) -> list[Way]:
        def run() -> int:
            self.apply(way)
            flow = self.execute(node.finalbody, scope)
            if flow == GOES_ON and way.flow == ENDED:
                self.raised = way.raised
            return flow or way.flow

        return self.ways(condition, run)

    def _handlers(self, node: ast.Try, condition: str, way: Branch, scope: Scope) -> list[Way]:
        """What comes of an exception: the handler that takes it, or all that may."""
        found: list[Way] = []
        value = way.raised.value if isinstance(way.raised, Raised) else UNKNOWN
        for handler in node.handlers:
            known = True if handler.type is None else taken_by(value, self.evaluate(handler.type, scope))
            if known is False:
                continue
            said = condition if known else conjunction((condition, f"except {ast.unparse(handler.type)}" if handler.type else ""))
            found += self._handle(handler, said, way, value, scope)
            if known:
                return found
        return [*found, (condition, way)]

    def _may_fail(self, node: ast.Try, condition: str, way: Branch, scope: Scope) -> list[Way]:
        """What comes of an exception that may have been raised anywhere in the body."""
        with self.branch("") as partly:
            finished = Branch()
            finished.written = way.written
            self.join([("", finished), ("", Branch())], scope.variables)
            for place, (mapping, key, _) in way.written.items():
                if place in self.rewritten and key not in (ITEMS, ENTRIES, COMPLETE):
                    self.store(mapping, key, UNKNOWN)
        found: list[Way] = []
        for handler in node.handlers:
            said = f"except {ast.unparse(handler.type)}" if handler.type is not None else "except"
            found += self._handle(handler, conjunction((condition, said)), partly, UNKNOWN, scope)
        return found

    def _handle(self, handler: ast.ExceptHandler, condition: str, way: Branch, value: Value, scope: Scope) -> list[Way]:
        def run() -> int:
            self.apply(way)
            if handler.name:
                self.assign(ast.Name(handler.name, ast.Store()), value, scope)
            self._handled.append(way.raised or Ended())
            try:
                return self.execute(handler.body, scope)
            finally:
                self._handled.pop()
                if handler.name:
                    self.store(scope.shared.get(handler.name, scope).variables, handler.name, MISSING)

        return self.ways(condition, run)

    # -- with, match --------------------------------------------------------------------------------------------------

    def with_exactly(self, node: ast.With | ast.AsyncWith, scope: Scope) -> int:
        """``with``."""
        left: list[Value] = []
        for item in node.items:
            value = self.evaluate(item.context_expr, scope)
            entered = value
            if isinstance(value, Instance):
                enter = self.attribute(value, "__enter__", node, scope)
                entered = self.call(enter, [], {}, node, scope) if isinstance(enter, Bound) else self.unknown()
                left.append(value)
            if item.optional_vars is not None:
                self.assign(item.optional_vars, entered, scope)
        flow = self.execute(node.body, scope)
        for value in reversed(left):
            leave = self.attribute(value, "__exit__", node, scope)
            if isinstance(leave, Bound) and flow != ENDED:
                self.call(leave, [None, None, None], {}, node, scope)
            elif isinstance(leave, Bound):
                self.risks += 1
                raised = self.raised
                kept = self.call(leave, [UNKNOWN] * 3, {}, node, scope)
                if self.truth(kept) is True:
                    flow = GOES_ON
                else:
                    self.raised = raised
        return flow

    def match_exactly(self, node: ast.Match, scope: Scope) -> int:
        """``match``."""
        subject = self.evaluate(node.subject, scope)
        said = ast.unparse(node.subject)
        ways: list[Way] = []
        for case in node.cases:
            taken: dict[str, Value] = {}
            known = Matching(self, scope, taken).matches(case.pattern, subject)
            if known is False:
                continue

            def run(case: ast.match_case = case, taken: dict[str, Value] = taken) -> int:
                for name, value in taken.items():
                    self.assign(ast.Name(name, ast.Store()), value, scope)
                return self.execute(case.body, scope)

            if known and case.guard is not None:
                for name, value in taken.items():
                    self.assign(ast.Name(name, ast.Store()), value, scope)
                known = self.truth(self.evaluate(case.guard, scope))
                if known is False:
                    continue
            if known and not ways:
                return run()
            ways += self.ways(f"{said} is {ast.unparse(case.pattern)}", run)
            if known:
                return self.meet(ways, scope.variables)
        return self.meet([*ways, ("", Branch())], scope.variables) if ways else GOES_ON

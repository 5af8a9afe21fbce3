"""Patterns of ``match``: does a value fit, and what is taken out of it."""

from __future__ import annotations

import ast

from launchlint.python import operations
from launchlint.python.functions import instance_of
from launchlint.python.values import UNKNOWN, Choice, External, Map, Outside, Scope, Seq, Text, Unknown, Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.python.expressions import Expressions

_WHOLE = tuple(External(f"builtins.{name}") for name in "bool bytes dict float frozenset int list set str tuple".split())
"""Classes whose only positional pattern is for the value itself."""


class Matching:
    """Matches in one scope; names that patterns bind are put into ``taken``."""

    def __init__(self, run: Expressions, scope: Scope, taken: dict[str, Value]) -> None:
        self._run = run
        self._scope = scope
        self._taken = taken

    def matches(self, pattern: ast.pattern, value: Value) -> bool | None:
        """Whether a value fits a pattern; None where that is not known."""
        if isinstance(pattern, ast.MatchAs):
            known = True if pattern.pattern is None else self.matches(pattern.pattern, value)
            if pattern.name is not None and known is not False:
                self._taken[pattern.name] = value
            return known
        if isinstance(pattern, ast.MatchOr):
            for each in pattern.patterns:
                known = self.matches(each, value)
                if known is not False:
                    return known
            return False
        if isinstance(value, (Unknown, Choice, Text, Outside)):
            self._open(pattern)
            return None
        if isinstance(pattern, ast.MatchValue):
            return operations.equal(value, self._run.evaluate(pattern.value, self._scope))
        if isinstance(pattern, ast.MatchSingleton):
            return operations.identical(value, pattern.value)
        if isinstance(pattern, ast.MatchSequence):
            return self._sequence(pattern, value)
        if isinstance(pattern, ast.MatchMapping):
            return self._mapping(pattern, value)
        if isinstance(pattern, ast.MatchClass):
            return self._class(pattern, value)
        return None

    def _open(self, pattern: ast.pattern) -> None:
        """What a pattern binds is not known."""
        for each in ast.walk(pattern):
            if isinstance(each, (ast.MatchAs, ast.MatchStar)) and each.name is not None:
                self._taken[each.name] = UNKNOWN
            elif isinstance(each, ast.MatchMapping) and each.rest is not None:
                self._taken[each.rest] = UNKNOWN

    def _all(self, pairs: list[tuple[ast.pattern, Value]]) -> bool | None:
        answer: bool | None = True
        for pattern, value in pairs:
            known = self.matches(pattern, value)
            if known is False:
                return False
            answer = None if known is None else answer
        return answer

    def _sequence(self, pattern: ast.MatchSequence, value: Value) -> bool | None:
        if not isinstance(value, Seq):
            return False if isinstance(value, (str, int, float, type(None), Map)) else None
        if value.kind not in ("list", "tuple", "range"):
            return False
        if not value.is_sure:
            self._open(pattern)
            return None
        items, wanted = value.items, pattern.patterns
        star = next((at for at, each in enumerate(wanted) if isinstance(each, ast.MatchStar)), None)
        if star is None:
            return self._all(list(zip(wanted, items, strict=True))) if len(items) == len(wanted) else False
        behind = len(wanted) - star - 1
        if len(items) < star + behind:
            return False
        starred = wanted[star]
        end = len(items) - behind
        if isinstance(starred, ast.MatchStar) and starred.name is not None:
            self._taken[starred.name] = Seq(items[star:end])
        return self._all([*zip(wanted[:star], items[:star], strict=True), *zip(wanted[star + 1 :], items[end:], strict=True)])

    def _mapping(self, pattern: ast.MatchMapping, value: Value) -> bool | None:
        if not isinstance(value, Map):
            return False if isinstance(value, (str, int, float, type(None), Seq)) else None
        keys = [self._run.evaluate(each, self._scope) for each in pattern.keys]
        if not value.is_sure or not all(isinstance(each, (str, int, float, type(None))) for each in keys):
            self._open(pattern)
            return None
        if any(each not in value.entries for each in keys):
            return False
        if pattern.rest is not None:
            self._taken[pattern.rest] = Map({key: each for key, each in value.entries.items() if key not in keys})
        return self._all([(each, value.entries[key]) for key, each in zip(keys, pattern.patterns, strict=True)])

    def _class(self, pattern: ast.MatchClass, value: Value) -> bool | None:
        type_ = self._run.evaluate(pattern.cls, self._scope)
        known = instance_of(value, type_)
        if known and type_ in _WHOLE and len(pattern.patterns) == 1 and not pattern.kwd_patterns:
            return self.matches(pattern.patterns[0], value)
        if known is False or (known and not pattern.patterns and not pattern.kwd_patterns):
            return known
        self._open(pattern)
        return None

"""Items of lists, dicts and strings."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from launchlint.python.comprehensions import Comprehensions
from launchlint.python.text import may_be
from launchlint.python.values import (
    MISSING,
    MOST_ALTERNATIVES,
    UNKNOWN,
    Argv,
    Choice,
    External,
    Function,
    Instance,
    Key,
    Map,
    Outside,
    Scope,
    Seq,
    Text,
    Value,
    alternatives,
    choice,
    is_maybe,
)

_CONSTANT = (str, int, float, bool, type(None))
_GENERIC = (
    "typing.",
    "typing_extensions.",
    "collections.",
    "builtins.list",
    "builtins.dict",
    "builtins.tuple",
    "builtins.set",
    "builtins.type",
)
"""What is a class or an annotation, and stays one with others in brackets: ``List[str]``."""


def _is_open(value: Map) -> bool:
    """Whether a key of a dict is a string of which only parts are known."""
    return any(isinstance(each, Text) for each in value.entries)


class Subscripts(Comprehensions):
    """``value[index]``."""

    def escape(self, values: Sequence[Value], when: str) -> None:
        """Values are given to code that is not followed."""
        raise NotImplementedError

    def _subscript(self, node: ast.Subscript, scope: Scope) -> Value:
        value = self.evaluate(node.value, scope)
        index = self._slice(node.slice, scope)
        if self.exact:
            return self.spread(lambda each: self.item(each, index), value)
        results = [(condition, self.item(each, index)) for condition, each in alternatives(value)]
        return choice(results)

    def _slice(self, node: ast.expr, scope: Scope) -> Value:
        if not isinstance(node, ast.Slice):
            return self.evaluate(node, scope)
        bounds = [self.evaluate(each, scope) for each in (node.lower, node.upper, node.step)]
        known = all(each is None or (isinstance(each, int) and abs(each) < 1 << 31 and each != 0) or each == 0 for each in bounds)
        return slice(*bounds) if known and bounds[2] != 0 else UNKNOWN

    def item(self, value: Value, index: Value) -> Value:
        """``value[index]``."""
        if self.exact and isinstance(index, Choice):
            return self.spread(lambda each: self.item(value, each), index)
        if self.exact and isinstance(value, External) and value.name.startswith(_GENERIC):
            inner = f"[{index.name}]" if isinstance(index, External) and "[" not in value.name else ""
            return External(f"{value.name}{inner}")
        if isinstance(value, Argv) and isinstance(index, int) and not isinstance(index, bool):
            position = value.offset + index if index >= 0 else index
            return Text(f"{{arg:{position}}}") if position and abs(position) < 1000 else UNKNOWN
        if isinstance(value, Argv) and isinstance(index, slice) and index.step is None and (index.start or 0) >= 0:
            return Argv(value.offset + (index.start or 0)) if index.stop is None else UNKNOWN
        if isinstance(value, Map):
            key = self.key(index)
            if key is not MISSING and key in value.entries:
                found = value.entries[key]
                return choice([*found.alternatives, ("", self.unknown())]) if is_maybe(found) and self.exact else found
            if self.exact and value.complete and isinstance(key, (str, int, float, type(None), Key)) and not _is_open(value):
                return self.fails("KeyError", index)
            self.risks += 1
            return self._one_of(value, index)
        if isinstance(value, (Seq, str)) and isinstance(index, (int, slice)):
            content = value if isinstance(value, str) else value.items
            if isinstance(value, Seq) and (not value.is_sure or value.kind not in ("list", "tuple", "range")):
                return self._item_of_some(value, index)
            try:
                found = content[index]
            except IndexError:
                return self.fails("IndexError", "index out of range")
            return Seq(found, kind=value.kind) if isinstance(value, Seq) and isinstance(found, list) else found
        if self.exact and isinstance(value, Instance):
            return self._by_method(value, "__getitem__", [index])
        self.risks += 1
        if self.exact and isinstance(value, (*_CONSTANT, Seq, Function)) and isinstance(index, (*_CONSTANT, Seq, Map)):
            return self.fails("TypeError", "indices must be integers or slices")
        if isinstance(value, Seq) and value.complete and value.items and len(value.items) <= 8:
            return choice([(f"item {at} is asked for", each) for at, each in enumerate(value.items)])
        return value.item(index) if isinstance(value, Outside) else UNKNOWN

    def _one_of(self, value: Map, index: Value) -> Value:
        """An item of a dict by a key that is not known: any whose key looks so. Of many functions each is called."""
        found = [(f"{key!r} is asked for", each) for key, each in value.entries.items() if not isinstance(key, str) or may_be(key, index)]
        if not value.complete or not found:
            return UNKNOWN
        if len(found) > MOST_ALTERNATIVES:
            self.escape([each for _, each in found], "start")
        return choice(found)

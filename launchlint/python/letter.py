"""What a program is followed to the letter with: exceptions, conditions of which both sides are worked out, generators, comparisons."""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence

from launchlint.python import operations
from launchlint.python.conditions import negated, written
from launchlint.python.containers import distinct, keys_of
from launchlint.python.failures import Raised, failure, of_python
from launchlint.python.memory import ENDED, Ended
from launchlint.python.plain import NotPlain, key_of, plain
from launchlint.python.text import distribute
from launchlint.python.values import (
    COMPLETE,
    ITEMS,
    MISSING,
    MOST_EXACT,
    UNKNOWN,
    UNORDERED,
    Choice,
    Class,
    External,
    Function,
    Instance,
    Map,
    Outside,
    Scope,
    Seq,
    Text,
    Unknown,
    Value,
    choice,
    is_maybe,
)
from launchlint.python.ways import Way, Ways

LATER = "\0later"
"""In the content of a generator: what it gives, to be worked out."""
MORE_ITEMS = External("\0more")
"""Among what a generator gives: there may be others that are not known."""
_CONSTANT = (str, int, float, bool, type(None))
_NEVER_FAIL = (ast.Eq, ast.NotEq, ast.Is, ast.IsNot)


class ToTheLetter(Ways):
    """What the values of expressions are worked out with."""

    def __init__(self) -> None:
        super().__init__()
        self.here: tuple[ast.AST, Scope] | None = None

    def evaluate(self, node: ast.expr | None, scope: Scope) -> Value:
        """The value of an expression."""
        raise NotImplementedError

    def call(self, function: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Call a value."""
        raise NotImplementedError

    def attribute(self, value: Value, name: str, node: ast.AST, scope: Scope) -> Value:
        """``value.name``."""
        raise NotImplementedError

    def truth(self, value: Value) -> bool | None:
        """Whether a value counts as true; None where that is not known."""
        raise NotImplementedError

    def rounds(self, value: Value) -> tuple[list[Value], bool]:
        """What a loop over ``value`` takes, and whether that is everything."""
        raise NotImplementedError

    def as_text(self, value: Value) -> Value:
        """``str(value)``."""
        raise NotImplementedError

    def exactly(self, make: Callable[[], Value]) -> Value:
        """What ``make`` gives, MISSING where it is not known. Raises Raised where the program is followed to the letter."""
        try:
            return make()
        except NotPlain:
            return MISSING
        except Raised:
            if self.exact:
                raise
            return UNKNOWN

    def spread(self, make: Callable[..., Value], *values: Value) -> Value:
        """``make`` of everything that ``values`` can be; MISSING where that is one thing and not known. Raises Raised."""
        if not any(isinstance(each, Choice) for each in values):
            return make(*values)

        def made(*each: Value) -> Value:
            try:
                found = make(*each)
            except Raised:
                return self.unknown()
            return UNKNOWN if found is MISSING else found

        return distribute(made, *values)

    def unknown(self) -> Value:
        """A value that is not known, of something that may have raised an exception as well."""
        self.risks += 1
        return UNKNOWN

    def fails(self, kind: str, *arguments: Value) -> Value:
        """Where the program is followed to the letter, it raises an exception; else nothing is known."""
        if self.exact:
            raise failure(kind, *arguments)
        return UNKNOWN

    def force(self, value: Seq) -> None:
        """Run a generator that nothing was taken of yet."""
        later = value.content.get(LATER)
        if later is None:
            return
        self.store(value.content, LATER, None)
        try:
            items, complete = later()
        except Raised:
            self.risks += 1
            items, complete = [], False
        self.store(value.content, ITEMS, items)
        self.store(value.content, COMPLETE, complete)

    def all_items(self, value: Value, *, ordered: bool = False) -> list[Value]:
        """The items of something that can be gone through, those of a set in any order. Raises NotPlain where not all are known."""
        if isinstance(value, Seq):
            self.force(value)
        if isinstance(value, Seq) and value.kind in UNORDERED and value.is_sure:
            if ordered and len(value.items) > 1:
                raise NotPlain
            return value.items
        if isinstance(value, Map) and not value.is_sure:
            raise NotPlain
        if isinstance(value, Seq) and not value.is_sure:
            raise NotPlain
        items, complete = self.rounds(value)
        if not complete:
            raise NotPlain
        return items

    def keys_for(self, items: Sequence[Value], key: Value = None) -> list[Value]:
        """What items are compared by. Raises NotPlain."""
        if key is None:
            return [plain(each) for each in items]
        node, scope = self.here or (None, None)
        if node is None or scope is None:
            raise NotPlain
        return [plain(self.call(key, [each], {}, node, scope)) for each in items]

    def sorted(self, items: Sequence[Value], keywords: dict[str, Value]) -> list[Value] | None:
        """Items in their order; None where that is not known. Raises Raised."""
        reverse = keywords.get("reverse", False)
        if not isinstance(reverse, (bool, int)) or keywords.keys() - {"reverse", "key"}:
            return None
        try:
            keys = self.keys_for(items, keywords.get("key"))
            return [items[at] for at in sorted(range(len(items)), key=keys.__getitem__, reverse=bool(reverse))]
        except NotPlain:
            return None
        except TypeError as error:
            raise of_python(error) from None

    def _by_method(self, owner: Instance, name: str, given: list[Value]) -> Value:
        """What the method that stands for an operator gives; unknown where its class has none."""
        if name and self.here is not None and any(isinstance(each, Class) and name in each.attributes for each in owner.type.order):
            node, scope = self.here
            made = self.call(self.attribute(owner, name, node, scope), given, {}, node, scope)
            return UNKNOWN if isinstance(made, External) else made
        return self.unknown()

    def either(self, parts: list[tuple[str, Callable[[], Value] | None]], scope: Scope) -> list[tuple[str, Value]]:
        """What comes of one of several parts, each with its condition; None is nothing. Raises Ended where all of them raise."""
        ways: list[Way] = []
        found: list[tuple[str, Value]] = []
        for said, part in parts:
            with self.branch(said) as branch:
                try:
                    if part is not None:
                        found.append((said, part()))
                except Ended as error:
                    branch.flow, branch.raised = ENDED, error
                    self.risks += 1
            ways.append((said, branch))
        if all(way.flow == ENDED for _, way in ways):
            raise ways[-1][1].raised or Ended
        self.join(ways, scope.variables)
        return found

    def _boolean_exactly(self, values: list[ast.expr], is_or: bool, scope: Scope) -> Value:
        first, *rest = values
        value = self.evaluate(first, scope)
        known = self.truth(value) if rest else True
        if not rest or known is is_or:
            return value
        if known is not None:
            return self._boolean_exactly(rest, is_or, scope)
        said = written(first)
        stops, goes = (said, negated(said)) if is_or else (negated(said), said)
        found = self.either([(stops, lambda: value), (goes, lambda: self._boolean_exactly(rest, is_or, scope))], scope)
        options = [each for condition, one in found[:1] for each in self._with_truth(one, condition, is_or)]
        return choice([*options, *found[1:]])

    def _with_truth(self, value: Value, condition: str, wanted: bool) -> list[tuple[str, Value]]:
        """Of what a value can be, what counts as true, or what does not."""
        if not isinstance(value, Choice):
            return [(condition, value)]
        return [(condition, each) for _, each in value.alternatives if self.truth(each) is not (not wanted)]

    def _compare_exactly(self, node: ast.Compare, scope: Scope) -> Value:
        left = self.evaluate(node.left, scope)
        result: Value = True
        for operation, each in zip(node.ops, node.comparators, strict=True):
            right = self.evaluate(each, scope)
            known = self.spread(self._comparison(type(operation)), left, right)
            if known is False:
                return False if result is True else UNKNOWN
            if known is not True:
                if len(node.ops) == 1:
                    return known
                result = UNKNOWN  # what follows is worked out, though it may not be
            left = right
        return result

    def _comparison(self, operation: type[ast.cmpop]) -> Callable[[Value, Value], Value]:
        return lambda one, other: self.compared(one, operation, other)

    def compared(self, left: Value, operation: type[ast.cmpop], right: Value) -> Value:
        """``left operation right``, where neither is a choice."""
        negative = operation in (ast.NotEq, ast.NotIn, ast.IsNot)
        if operation in (ast.Eq, ast.NotEq):
            known = operations.equal(left, right)
            if known is None and isinstance(left, Instance):
                made = self.truth(self._by_method(left, "__eq__", [right]))
                known = made
        elif operation in (ast.Is, ast.IsNot):
            known = operations.identical(left, right)
        elif operation in (ast.In, ast.NotIn):
            if isinstance(right, Seq):
                self.force(right)
            known = operations.contained(left, right)
            if isinstance(right, (str, int, float, type(None))) and known is None and not isinstance(left, (Unknown, Text, Outside)):
                return self.fails("TypeError", "argument is not iterable")
        else:
            known = operations.ordered(left, operation, right)
        if known is None:
            return UNKNOWN if operation in _NEVER_FAIL or self._is_container(left, right) else self.unknown()
        return known is not negative

    def _is_container(self, left: Value, right: Value) -> bool:
        """Whether ``left in right``, or that one is less than the other, raises nothing although it is not known."""
        return isinstance(right, (Seq, Map)) or (isinstance(left, (str, Text)) and isinstance(right, (str, Text)))

    def key(self, value: Value) -> Value:
        """A value as the key of a followed dict; MISSING where it cannot be one."""
        if isinstance(value, Seq) and value.kind == "tuple":
            try:
                value = key_of(value)
                hash(value)
            except NotPlain:
                return MISSING
            except TypeError as error:
                return MISSING if not self.exact else self.fails("TypeError", str(error))
            return value
        if self.exact and isinstance(value, (Map, Seq, slice)) and (not isinstance(value, Seq) or value.kind in ("list", "set")):
            return self.fails("TypeError", "unhashable type")
        return value if hashable(value) else MISSING

    def _item_of_some(self, value: Seq, index: int | slice) -> Value:
        """An item of a list of which some may not be there: those before them stand where they stand."""
        items = value.items
        if isinstance(index, slice):
            sure = next((at for at, each in enumerate(items) if is_maybe(each)), len(items))
            start: int = index.start if isinstance(index.start, int) else 0
            known = value.kind in ("list", "tuple") and index.stop is None and index.step is None and 0 <= start <= sure
            return Seq(items[start:], value.complete, kind=value.kind) if known and self.exact else UNKNOWN
        self.risks += 1
        if index < 0 or value.kind not in ("list", "tuple") or not value.complete or not self.exact:
            return UNKNOWN
        return items[index] if len(items) > index and not any(map(is_maybe, items[: index + 1])) else UNKNOWN

    def _rounds_exactly(self, value: Value) -> tuple[list[Value], bool]:
        if isinstance(value, Seq):
            self.force(value)
            items = value.items
            self.spend(len(items))
            if value.kind == "iterator" and (items or not value.complete):
                self.store(value.content, ITEMS, [])
            if not value.complete or (value.kind in UNORDERED and len(items) > 1):
                self.risks += 1
                return [*items, UNKNOWN], False
            return items, True
        if isinstance(value, Map):
            self.spend(len(value.entries))
            keys = keys_of(value)
            return (keys, True) if value.complete else ([*keys, UNKNOWN], False)
        if isinstance(value, str) and len(value) <= MOST_EXACT:
            self.spend(len(value))
            return list(value), True
        if isinstance(value, Instance):
            made = self._by_method(value, "__iter__", [])
            if isinstance(made, Seq):
                return self._rounds_exactly(made)
        if isinstance(value, (int, float, type(None), Function)):
            self.fails("TypeError", f"{type(value).__name__!r} object is not iterable")
        self.risks += 1
        return [UNKNOWN], False

    def _truth_of(self, value: Instance) -> bool | None:
        for name in ("__bool__", "__len__"):
            if any(
                not isinstance(each, Class) or name in each.attributes for each in value.type.order if each != External("builtins.object")
            ):
                return self.truth(self._by_method(value, name, []))
        return True

    def make_set(self, items: list[Value], complete: bool) -> Value:
        """A set of items that may be the same."""
        once = self.exactly(lambda: distinct(items) or [])
        if once is MISSING or (not once and items):
            return Seq(items, complete and not self.exact, kind="set")
        return Seq(once, complete, kind="set") if isinstance(once, list) else once


def hashable(value: Value) -> bool:
    """Whether a value can be a key of a followed dict."""
    return isinstance(value, (*_CONSTANT, Text, External))


METHODS: dict[type[ast.operator], str] = {
    ast.Add: "__add__",
    ast.Sub: "__sub__",
    ast.Mult: "__mul__",
    ast.Div: "__truediv__",
    ast.Mod: "__mod__",
}

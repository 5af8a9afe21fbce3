"""Expressions: what their value is, as far as it is known."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Sequence

from launchlint.python.arity import takes_fewer
from launchlint.python.conditions import negated, written
from launchlint.python.memory import Ended, Memory
from launchlint.python.recogniser import Recogniser
from launchlint.python.text import interpolated, joined, may_be, or_default, percent
from launchlint.python.values import (
    MISSING,
    MORE,
    MOST_ALTERNATIVES,
    UNKNOWN,
    Argv,
    Bound,
    Choice,
    Class,
    External,
    Function,
    Handle,
    Instance,
    Map,
    Module,
    Outside,
    Partial,
    Scope,
    Seq,
    Text,
    Thing,
    Value,
    alternatives,
    choice,
)

MOST_ROUNDS = 64
DEEPEST = 350

_COMPARE: dict[type[ast.cmpop], Callable[[Value, Value], bool]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}
_ARITHMETIC: dict[type[ast.operator], Callable[[Value, Value], Value]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
}
_CONSTANT = (str, int, float, bool, type(None))
_THING = (Class, Function, Bound, Handle, Instance, Module, Thing, Partial)


class Expressions(Memory):
    """Evaluation. What calls and statements need of each other is declared here and given by the classes below."""

    def __init__(self, recogniser: Recogniser) -> None:
        super().__init__()
        self.recogniser = recogniser
        self.depth = 0

    def call(self, function: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Call a value."""
        raise NotImplementedError

    def attribute(self, value: Value, name: str, node: ast.AST, scope: Scope) -> Value:
        """``value.name``."""
        raise NotImplementedError

    def lookup(self, name: str, scope: Scope) -> Value:
        """The value of a variable."""
        raise NotImplementedError

    def assign(self, target: ast.expr, value: Value, scope: Scope) -> None:
        """Write to a variable, attribute, item or several of them."""
        raise NotImplementedError

    def escape(self, values: Sequence[Value], when: str) -> None:
        """Values are given to code that is not followed."""
        raise NotImplementedError

    def evaluate(self, node: ast.expr | None, scope: Scope) -> Value:
        """The value of an expression."""
        if node is None:
            return None
        self.step()
        if self.depth > DEEPEST:
            return UNKNOWN
        self.depth += 1
        try:
            method = _EVALUATE.get(type(node))
            return UNKNOWN if method is None else method(self, node, scope)
        finally:
            self.depth -= 1

    # -- parts ----------------------------------------------------------------------------------------------------

    def _constant(self, node: ast.Constant, scope: Scope) -> Value:
        return node.value if isinstance(node.value, _CONSTANT) else UNKNOWN

    def _name(self, node: ast.Name, scope: Scope) -> Value:
        return self.lookup(node.id, scope)

    def _attribute(self, node: ast.Attribute, scope: Scope) -> Value:
        return self.attribute(self.evaluate(node.value, scope), node.attr, node, scope)

    def _call(self, node: ast.Call, scope: Scope) -> Value:
        function = self.evaluate(node.func, scope)
        positional: list[Value] = []
        more = False
        for argument in node.args:
            if isinstance(argument, ast.Starred):
                value = self.evaluate(argument.value, scope)
                positional += value.items if isinstance(value, Seq) else [UNKNOWN]
                more = more or not isinstance(value, Seq) or not value.complete
            else:
                positional.append(self.evaluate(argument, scope))
        keywords: dict[str, Value] = {}
        for keyword in node.keywords:
            value = self.evaluate(keyword.value, scope)
            if keyword.arg is not None:
                keywords[keyword.arg] = value
            elif isinstance(value, Map):
                keywords.update({key: item for key, item in value.entries.items() if isinstance(key, str)})
                more = more or not value.complete
            else:
                more = True
        if more:
            keywords[MORE] = UNKNOWN
        if not isinstance(function, Choice):
            return self._called(function, positional, keywords, node, scope)
        results: list[tuple[str, Value]] = []
        ways = []
        for condition, each in function.alternatives:
            with self.branch(condition) as branch:
                try:
                    results.append((condition, self._called(each, list(positional), dict(keywords), node, scope)))
                except Ended:
                    branch.flow = 4
            ways.append((condition, branch))
        self.join(ways, scope.variables)
        result = choice(results)
        return UNKNOWN if result is MISSING else result

    def _called(self, function: Value, positional: list[Value], keywords: dict[str, Value], node: ast.Call, scope: Scope) -> Value:
        if takes_fewer(function, len(positional)) and not any(isinstance(each, ast.Starred) for each in node.args):
            self.doubt(f"it calls {written(node.func)} with more arguments than that takes", scope.module.path, node.lineno)
            raise Ended
        return self.call(function, positional, keywords, node, scope)

    def _binary(self, node: ast.BinOp, scope: Scope) -> Value:
        left, right = self.evaluate(node.left, scope), self.evaluate(node.right, scope)
        return self.combine(left, type(node.op), right)

    def combine(self, left: Value, operation: type[ast.operator], right: Value) -> Value:
        """``left operation right``."""
        if operation is ast.Mod and isinstance(left, str):
            if isinstance(right, Map):
                return percent(left, (), right.entries)
            return percent(left, right.items if isinstance(right, Seq) else [right], None)
        if isinstance(left, Seq) and isinstance(right, Seq) and operation is ast.Add:
            return Seq([*left.items, *right.items], left.complete and right.complete)
        if isinstance(left, Argv) or isinstance(right, Argv):
            return UNKNOWN
        if isinstance(left, _NUMBER) and isinstance(right, _NUMBER) and operation in _ARITHMETIC:
            if abs(left) > 1e12 or abs(right) > 1e12:
                return UNKNOWN
            try:
                return _ARITHMETIC[operation](left, right)
            except (ArithmeticError, ValueError):
                return UNKNOWN
        if operation is ast.Add and (_is_text(left) or _is_text(right)):
            return joined([left, right])
        if operation is ast.Mult and isinstance(left, str) and isinstance(right, int) and len(left) * right < 1000:
            return left * right
        return UNKNOWN

    def _boolean(self, node: ast.BoolOp, scope: Scope) -> Value:
        is_or = isinstance(node.op, ast.Or)
        options: list[tuple[str, Value]] = []
        conditions: list[str] = []
        mark = len(self.conditions)
        try:
            for position, each in enumerate(node.values):
                value = self.evaluate(each, scope)
                if position == len(node.values) - 1:
                    options.append((" and ".join(conditions), value))
                    break
                known = self.truth(value)
                if known is None:
                    said = written(each)
                    options.append((said if is_or else negated(said), value))
                    conditions.append(negated(said) if is_or else said)
                    self.conditions.append(conditions[-1])
                elif known is is_or:
                    options.append((" and ".join(conditions), value))
                    break
        finally:
            del self.conditions[mark:]
        if len(options) > 1 and is_or and isinstance(options[0][1], (Outside, Text)) and len(options) == 2:
            merged = or_default(options[0][1], options[1][1])
            if merged is not MISSING:
                return merged
        return choice(options)

    def _unary(self, node: ast.UnaryOp, scope: Scope) -> Value:
        value = self.evaluate(node.operand, scope)
        if isinstance(node.op, ast.Not):
            known = self.truth(value)
            return UNKNOWN if known is None else not known
        if isinstance(value, _NUMBER):
            return -value if isinstance(node.op, ast.USub) else +value if isinstance(node.op, ast.UAdd) else UNKNOWN
        return UNKNOWN

    def _compare(self, node: ast.Compare, scope: Scope) -> Value:
        values = [self.evaluate(each, scope) for each in (node.left, *node.comparators)]
        if len(node.ops) != 1:
            return UNKNOWN
        left, right, operation = values[0], values[1], node.ops[0]
        if isinstance(operation, (ast.Is, ast.IsNot, ast.Eq, ast.NotEq)) and (left is None or right is None):
            other = right if left is None else left
            positive = isinstance(operation, (ast.Is, ast.Eq))
            if other is None:
                return positive
            return not positive if isinstance(other, (*_THING, Seq, Map, str, int, float, Thing, External)) else UNKNOWN
        if isinstance(operation, (ast.In, ast.NotIn)):
            return self._contained(left, right, isinstance(operation, ast.In))
        if isinstance(left, _CONSTANT) and isinstance(right, _CONSTANT) and type(operation) in _COMPARE:
            try:
                return bool(_COMPARE[type(operation)](left, right))
            except TypeError:
                return UNKNOWN
        return UNKNOWN

    def _contained(self, left: Value, right: Value, positive: bool) -> Value:
        if not isinstance(left, _CONSTANT):
            return UNKNOWN
        if isinstance(right, str) and isinstance(left, str):
            return (left in right) is positive
        if isinstance(right, Map):
            return positive if left in right.entries else (not positive if right.complete else UNKNOWN)
        if isinstance(right, Seq) and right.complete and all(isinstance(each, _CONSTANT) for each in right.items):
            return (left in right.items) is positive
        return UNKNOWN

    def _conditional(self, node: ast.IfExp, scope: Scope) -> Value:
        known = self.truth(self.evaluate(node.test, scope))
        if known is not None:
            return self.evaluate(node.body if known else node.orelse, scope)
        said = written(node.test)
        options = []
        for condition, part in ((said, node.body), (negated(said), node.orelse)):
            self.conditions.append(condition)
            try:
                options.append((condition, self.evaluate(part, scope)))
            finally:
                self.conditions.pop()
        return choice(options)

    def _joined(self, node: ast.JoinedStr, scope: Scope) -> Value:
        parts: list[Value] = []
        for each in node.values:
            if isinstance(each, ast.FormattedValue):
                spec = self.evaluate(each.format_spec, scope) if each.format_spec is not None else ""
                value = self.evaluate(each.value, scope)
                parts.append(interpolated(value, spec, each.conversion) if isinstance(spec, str) else UNKNOWN)
            else:
                parts.append(self.evaluate(each, scope))
        return joined(parts)

    def _sequence(self, node: ast.List | ast.Tuple | ast.Set, scope: Scope) -> Value:
        items: list[Value] = []
        complete = True
        for each in node.elts:
            if isinstance(each, ast.Starred):
                inner = self.evaluate(each.value, scope)
                items += inner.items if isinstance(inner, Seq) else []
                complete = complete and isinstance(inner, Seq) and inner.complete
            else:
                items.append(self.evaluate(each, scope))
        return Seq(items, complete, isinstance(node, ast.Tuple))

    def _mapping(self, node: ast.Dict, scope: Scope) -> Value:
        entries: dict[Value, Value] = {}
        complete = True
        for key, each in zip(node.keys, node.values, strict=True):
            value = self.evaluate(each, scope)
            name = self.evaluate(key, scope) if key is not None else UNKNOWN
            if key is None and isinstance(value, Map):
                entries.update(value.entries)
                complete = complete and value.complete
            elif hashable(name):
                entries[name] = value
            else:
                complete = False
        return Map(entries, complete)

    def _subscript(self, node: ast.Subscript, scope: Scope) -> Value:
        value = self.evaluate(node.value, scope)
        index = self._slice(node.slice, scope)
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
        if isinstance(value, Argv) and isinstance(index, int) and not isinstance(index, bool):
            position = value.offset + index if index >= 0 else index
            return Text(f"{{arg:{position}}}") if position and abs(position) < 1000 else UNKNOWN
        if isinstance(value, Argv) and isinstance(index, slice) and index.step is None and (index.start or 0) >= 0:
            return Argv(value.offset + (index.start or 0)) if index.stop is None else UNKNOWN
        if isinstance(value, Map):
            if hashable(index) and index in value.entries:
                return value.entries[index]
            return self._one_of(value, index)
        if isinstance(value, (Seq, str)) and isinstance(index, (int, slice)):
            content = value if isinstance(value, str) else value.items
            if isinstance(value, Seq) and not value.complete:
                return UNKNOWN
            try:
                found = content[index]
            except IndexError:
                return UNKNOWN
            return Seq(found) if isinstance(found, list) else found
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

    # -- comprehensions and functions -----------------------------------------------------------------------------------

    def _comprehension(self, node: ast.ListComp | ast.SetComp | ast.GeneratorExp, scope: Scope) -> Value:
        found: list[Value] = []
        inner = Scope(scope.module, scope)
        complete = self._generate(node.generators, inner, lambda: found.append(self.evaluate(node.elt, inner)))
        return Seq(found, complete)

    def _mapping_comprehension(self, node: ast.DictComp, scope: Scope) -> Value:
        entries: dict[Value, Value] = {}
        inner = Scope(scope.module, scope)
        unhashable: list[bool] = []

        def take() -> None:
            key, value = self.evaluate(node.key, inner), self.evaluate(node.value, inner)
            if hashable(key):
                entries[key] = value
            else:
                unhashable.append(True)

        complete = self._generate(node.generators, inner, take)
        return Map(entries, complete and not unhashable)

    def _generate(self, generators: Sequence[ast.comprehension], scope: Scope, take: Callable[[], None]) -> bool:
        """Go through the loops of a comprehension; whether all of their rounds were gone through."""
        if not generators:
            take()
            return True
        first = generators[0]
        items, complete = self.rounds(self.evaluate(first.iter, scope))
        for item in items:
            self.assign(first.target, item, scope)
            mark = len(self.conditions)
            skipped = False
            for test in first.ifs:
                known = self.truth(self.evaluate(test, scope))
                skipped = skipped or known is False
                if known is None:
                    complete = False
                    self.conditions.append(written(test))
            if not skipped:
                complete = self._generate(generators[1:], scope, take) and complete
            del self.conditions[mark:]
        return complete

    def rounds(self, value: Value) -> tuple[list[Value], bool]:
        """What a loop over ``value`` takes, and whether that is everything; one unknown thing where nothing is known."""
        if isinstance(value, Seq) and len(value.items) <= MOST_ROUNDS:
            if value.complete:
                return value.items, True
            return [*value.items, UNKNOWN], False
        if isinstance(value, Map) and value.complete and len(value.entries) <= MOST_ROUNDS:
            return list(value.entries), True
        if isinstance(value, str) and len(value) <= MOST_ROUNDS:
            return list(value), True
        return [UNKNOWN], False

    def _function(self, node: ast.Lambda, scope: Scope) -> Value:
        return self.function(node, scope)

    def function(
        self, node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda, scope: Scope, owner: Class | None = None, kind: str = ""
    ) -> Function:
        """A function with its defaults as they are now."""
        arguments = node.args
        defaults = tuple(self.evaluate(each, scope) for each in arguments.defaults)
        keyword_defaults = tuple(
            (argument.arg, self.evaluate(default, scope))
            for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)
            if default is not None
        )
        return Function(node, scope, defaults, keyword_defaults, owner, kind)

    def _named(self, node: ast.NamedExpr, scope: Scope) -> Value:
        value = self.evaluate(node.value, scope)
        self.assign(node.target, value, scope)
        return value

    def _awaited(self, node: ast.Await, scope: Scope) -> Value:
        return self.evaluate(node.value, scope)

    def _yielded(self, node: ast.Yield | ast.YieldFrom, scope: Scope) -> Value:
        value = self.evaluate(node.value, scope)
        self.yielded(value if isinstance(node, ast.Yield) else UNKNOWN)
        return UNKNOWN

    def yielded(self, value: Value) -> None:
        """Take what a generator gives."""
        raise NotImplementedError

    def truth(self, value: Value) -> bool | None:
        """Whether a value counts as true; None where that is not known."""
        if isinstance(value, _CONSTANT):
            return bool(value)
        if isinstance(value, _THING):
            return True
        if isinstance(value, Seq) and (value.items or value.complete):
            return bool(value.items)
        if isinstance(value, Map) and (value.entries or value.complete):
            return bool(value.entries)
        if isinstance(value, Choice):
            known = {self.truth(each) for _, each in value.alternatives}
            return known.pop() if len(known) == 1 else None
        return None


_NUMBER = (int, float)
_EVALUATE: dict[type[ast.expr], Callable[[Expressions, Value, Scope], Value]] = {
    ast.Constant: Expressions._constant,
    ast.Name: Expressions._name,
    ast.Attribute: Expressions._attribute,
    ast.Call: Expressions._call,
    ast.BinOp: Expressions._binary,
    ast.BoolOp: Expressions._boolean,
    ast.UnaryOp: Expressions._unary,
    ast.Compare: Expressions._compare,
    ast.IfExp: Expressions._conditional,
    ast.JoinedStr: Expressions._joined,
    ast.List: Expressions._sequence,
    ast.Tuple: Expressions._sequence,
    ast.Set: Expressions._sequence,
    ast.Dict: Expressions._mapping,
    ast.Subscript: Expressions._subscript,
    ast.ListComp: Expressions._comprehension,
    ast.SetComp: Expressions._comprehension,
    ast.GeneratorExp: Expressions._comprehension,
    ast.DictComp: Expressions._mapping_comprehension,
    ast.Lambda: Expressions._function,
    ast.NamedExpr: Expressions._named,
    ast.Await: Expressions._awaited,
    ast.Yield: Expressions._yielded,
    ast.YieldFrom: Expressions._yielded,
}


def hashable(value: Value) -> bool:
    """Whether a value can be a key of a followed dict."""
    return isinstance(value, (*_CONSTANT, Text, External))


def _is_text(value: Value) -> bool:
    return isinstance(value, (str, Text)) or (
        isinstance(value, Choice) and any(isinstance(each, (str, Text)) for _, each in value.alternatives)
    )

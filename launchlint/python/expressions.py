"""Expressions: what their value is, as far as it is known."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Sequence

from launchlint.python import operations
from launchlint.python.arity import takes_fewer
from launchlint.python.conditions import negated, written
from launchlint.python.letter import METHODS, MORE_ITEMS
from launchlint.python.memory import ENDED, Ended
from launchlint.python.recogniser import Recogniser
from launchlint.python.subscripts import Subscripts
from launchlint.python.text import interpolated, joined, or_default, percent
from launchlint.python.values import (
    MISSING,
    MORE,
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
    choice,
    is_maybe,
)

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


class Expressions(Subscripts):
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

    def as_text(self, value: Value) -> Value:
        """``str(value)``."""
        raise NotImplementedError

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
                if self.exact:
                    items, complete = self.rounds(value)
                    complete = complete and not any(map(is_maybe, items))
                else:
                    items = value.items if isinstance(value, Seq) else [UNKNOWN]
                    complete = isinstance(value, Seq) and value.complete
                positional += items
                more = more or not complete
            else:
                positional.append(self.evaluate(argument, scope))
        keywords: dict[str, Value] = {}
        for keyword in node.keywords:
            value = self.evaluate(keyword.value, scope)
            if keyword.arg is not None:
                keywords[keyword.arg] = value
            elif self.exact and isinstance(value, (*_CONSTANT, Seq)):
                self.fails("TypeError", "argument after ** must be a mapping")
            elif isinstance(value, Map):
                if self.exact and any(not isinstance(key, (str, Text)) for key in value.entries):
                    self.fails("TypeError", "keywords must be strings")
                keywords.update({key: item for key, item in value.entries.items() if isinstance(key, str)})
                more = more or not value.is_sure
            else:
                more = True
        if more:
            self.risks += 1
            keywords[MORE] = UNKNOWN
        self.here = (node, scope)
        if not isinstance(function, Choice):
            return self._called(function, positional, keywords, node, scope)
        results: list[tuple[str, Value]] = []
        ways = []
        for condition, each in function.alternatives:
            with self.branch(condition) as branch:
                try:
                    results.append((condition, self._called(each, list(positional), dict(keywords), node, scope)))
                except Ended as error:
                    branch.flow, branch.raised = ENDED, error
                    self.risks += 1
            ways.append((condition, branch))
        if self.exact and not results:
            raise ways[-1][1].raised or Ended
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
        if isinstance(left, Choice) or isinstance(right, Choice):
            if self.exact:
                return self.spread(lambda one, other: self.combine(one, operation, other), left, right)
        else:
            made = self.exactly(lambda: operations.binary(left, operation, right))
            if made is not MISSING:
                return made
            if self.exact and isinstance(left, Instance):
                return self._by_method(left, METHODS.get(operation, ""), [right])
            self.risks += not (operation is ast.Add and isinstance(left, (str, Text)) and isinstance(right, (str, Text)))
        if operation is ast.Mod and isinstance(left, str):
            if isinstance(right, Map):
                return percent(left, (), right.entries)
            return percent(left, right.items if isinstance(right, Seq) else [right], None)
        if isinstance(left, Seq) and isinstance(right, Seq) and operation is ast.Add and not self.exact:
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
        if self.exact:
            return self._boolean_exactly(node.values, isinstance(node.op, ast.Or), scope)
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
        if isinstance(value, Choice):
            return self.spread(lambda each: self._negative(node.op, each), value)
        return self._negative(node.op, value)

    def _negative(self, operation: ast.unaryop, value: Value) -> Value:
        made = self.exactly(lambda: operations.unary(type(operation), value))
        return self.unknown() if made is MISSING else made

    def _compare(self, node: ast.Compare, scope: Scope) -> Value:
        if self.exact:
            return self._compare_exactly(node, scope)
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
        if self.exact:
            ways = [(said, lambda: self.evaluate(node.body, scope)), (negated(said), lambda: self.evaluate(node.orelse, scope))]
            return choice(self.either(list(ways), scope))
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
                parts.append(self._interpolated(value, spec, each.conversion) if isinstance(spec, str) else UNKNOWN)
            else:
                parts.append(self.evaluate(each, scope))
        return joined(parts)

    def _interpolated(self, value: Value, spec: str, conversion: int) -> Value:
        if not isinstance(value, Choice):
            made = self.exactly(lambda: operations.shown(value, spec, chr(conversion) if conversion > 0 else ""))
            if made is not MISSING:
                return made
            if self.exact and not spec and conversion in (-1, ord("s")):
                return self.as_text(value)
        return interpolated(value, spec, conversion)

    def _sequence(self, node: ast.List | ast.Tuple | ast.Set, scope: Scope) -> Value:
        items: list[Value] = []
        complete = True
        for each in node.elts:
            if isinstance(each, ast.Starred):
                inner = self.evaluate(each.value, scope)
                if self.exact:
                    more, known = self.rounds(inner)
                    items += [one for one in more if known or one is not UNKNOWN]
                    complete = complete and known
                    continue
                items += inner.items if isinstance(inner, Seq) else []
                complete = complete and isinstance(inner, Seq) and inner.complete
            else:
                items.append(self.evaluate(each, scope))
        self.spend(len(items))
        if isinstance(node, ast.Set):
            return self.make_set(items, complete)
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
                continue
            if key is None and self.exact:
                self.risks += 1
                if isinstance(value, (*_CONSTANT, Seq)):
                    self.fails("TypeError", "object is not a mapping")
                entries, complete = {}, False
                continue
            name = self.key(name)
            if name is not MISSING and not isinstance(name, Text):
                entries[name] = value
            elif self.exact:
                entries, complete = {}, False
            elif name is not MISSING:
                entries[name] = value
            else:
                complete = False
        return Map(entries, complete)

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
        while scope.around is not None:  # a comprehension has no variables but those of its loops
            scope = scope.around
        self.assign(node.target, value, scope)
        return value

    def _awaited(self, node: ast.Await, scope: Scope) -> Value:
        return self.evaluate(node.value, scope)

    def _yielded(self, node: ast.Yield | ast.YieldFrom, scope: Scope) -> Value:
        value = self.evaluate(node.value, scope)
        if isinstance(node, ast.YieldFrom) and self.exact:
            items, complete = self.rounds(value)
            for each in items if complete else [*items, MORE_ITEMS]:
                self.yielded(each)
            return UNKNOWN
        self.yielded(value if isinstance(node, ast.Yield) else UNKNOWN)
        return None if self.exact else UNKNOWN

    def yielded(self, value: Value) -> None:
        """Take what a generator gives."""
        raise NotImplementedError

    def truth(self, value: Value) -> bool | None:
        """Whether a value counts as true; None where that is not known."""
        if isinstance(value, _CONSTANT):
            return bool(value)
        if self.exact and isinstance(value, Instance):
            return self._truth_of(value)
        if self.exact and isinstance(value, (Seq, Map)):
            inner = value.items if isinstance(value, Seq) else list(value.entries.values())
            if isinstance(value, Seq) and value.kind == "iterator":
                return True
            return True if any(not is_maybe(each) for each in inner) else (None if inner or not value.complete else False)
        if isinstance(value, _THING):
            return True
        if isinstance(value, (Seq, Map)) and value.complete:
            held = value.items if isinstance(value, Seq) else value.entries.values()
            return None if held and all(map(is_maybe, held)) else bool(held)
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


def _is_text(value: Value) -> bool:
    return isinstance(value, (str, Text)) or (
        isinstance(value, Choice) and any(isinstance(each, (str, Text)) for _, each in value.alternatives)
    )

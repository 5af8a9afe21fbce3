"""Walks the tree of an expression and computes its value, step by counted step."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Iterator
from typing import Any

from launchlint.evaluate.expression.bounds import MOST_STEPS, Function, Stream
from launchlint.evaluate.expression.computation import Computation
from launchlint.evaluate.expression.errors import UnknownValue
from launchlint.evaluate.expression.methods import attribute

_MOST_DEPTH = 200
_UNBOUND = object()
NOT_INNER = object()
"""There is no such name in a lambda or comprehension."""


class Scope:
    """Names of a lambda or comprehension."""

    __slots__ = ("names", "parent")

    def __init__(self, parent: Scope | None, names: dict[str, Any]) -> None:
        self.parent = parent
        self.names = names


class Interpreter(Computation):
    """One evaluation of an expression, nested ones included."""

    __slots__ = ()

    def look_up(self, node: ast.Name, scope: Scope | None) -> Any:
        """The value of a name: that of a lambda or comprehension, then what the dialect knows, then Python's builtins."""
        raise NotImplementedError

    def inner(self, node: ast.Name, scope: Scope | None) -> Any:
        """The value of a name of a lambda or comprehension around ``node``; ``NOT_INNER`` where it has none of that name."""
        name = node.id
        inner = scope
        while inner is not None:
            if name in inner.names:
                if inner.names[name] is _UNBOUND:
                    raise self.failure(node, NameError(f"cannot access free variable {name!r} where it is not associated with a value"))
                return inner.names[name]
            inner = inner.parent
        return NOT_INNER

    def evaluate(self, node: ast.AST, scope: Scope | None) -> Any:
        """The value of ``node``."""
        self.steps -= 1
        if self.steps < 0:
            raise UnknownValue(f"the expression needs more than {MOST_STEPS} steps")
        visit = getattr(self, "_visit_" + type(node).__name__.lower(), None)
        if visit is None:
            raise UnknownValue(f"{type(node).__name__} is a part of Python that launchlint does not look into")
        self.depth += 1
        if self.depth > _MOST_DEPTH:
            raise UnknownValue("the expression is nested too deeply to be looked into")
        try:
            return visit(node, scope)
        finally:
            self.depth -= 1

    def _visit_constant(self, node: ast.Constant, scope: Scope | None) -> Any:
        return self.admit(node.value)

    def _visit_name(self, node: ast.Name, scope: Scope | None) -> Any:
        return self.look_up(node, scope)

    def _visit_namedexpr(self, node: ast.NamedExpr, scope: Scope | None) -> Any:
        if scope is not None:
            raise UnknownValue("an assignment inside a comprehension or lambda is not looked into")
        self.evaluate(node.value, scope)
        raise self.failure(node, TypeError("'_DictWrapper' object does not support item assignment"))

    def _visit_tuple(self, node: ast.Tuple, scope: Scope | None) -> Any:
        return self.admit(tuple(self.elements(node.elts, scope)))

    def _visit_list(self, node: ast.List, scope: Scope | None) -> Any:
        return self.admit(self.elements(node.elts, scope))

    def _visit_set(self, node: ast.Set, scope: Scope | None) -> Any:
        return self.admit(self.do(node, set, self.elements(node.elts, scope)))

    def _visit_dict(self, node: ast.Dict, scope: Scope | None) -> Any:
        result: dict[Any, Any] = {}
        for key, value in zip(node.keys, node.values, strict=True):
            if key is None:
                more = self.evaluate(value, scope)
                if not isinstance(more, dict):
                    raise self.failure(value, TypeError(f"{type(more).__name__!r} object is not a mapping"))
                self.charge(10 * len(more))
                result.update(more)
            else:
                made_key = self.evaluate(key, scope)
                if isinstance(made_key, (Function, Stream)):
                    raise UnknownValue("a dict with functions as keys is not looked into")
                self.do(key, result.__setitem__, made_key, self.evaluate(value, scope))
        return self.admit(result)

    def elements(self, nodes: list[ast.expr], scope: Scope | None) -> list[Any]:
        """Values of the items of a list or of call arguments, ``*starred`` ones laid out."""
        values: list[Any] = []
        for node in nodes:
            if isinstance(node, ast.Starred):
                values.extend(self.items(node, self.evaluate(node.value, scope)))
            else:
                values.append(self.evaluate(node, scope))
        return values

    def _visit_unaryop(self, node: ast.UnaryOp, scope: Scope | None) -> Any:
        value = self.evaluate(node.operand, scope)
        if isinstance(node.op, ast.Not):
            return not self.truth(value)
        self.plain(value)
        if isinstance(node.op, ast.Invert):
            return self.admit(self.do(node, operator.invert, int(value) if isinstance(value, bool) else value))
        return self.admit(self.do(node, operator.neg if isinstance(node.op, ast.USub) else operator.pos, value))

    def _visit_binop(self, node: ast.BinOp, scope: Scope | None) -> Any:
        left = self.evaluate(node.left, scope)
        return self.operate(node, type(node.op), left, self.evaluate(node.right, scope))

    def _visit_boolop(self, node: ast.BoolOp, scope: Scope | None) -> Any:
        stops_at = isinstance(node.op, ast.Or)
        value: Any = None
        for part in node.values:
            value = self.evaluate(part, scope)
            if self.truth(value) is stops_at:
                break
        return value

    def _visit_ifexp(self, node: ast.IfExp, scope: Scope | None) -> Any:
        return self.evaluate(node.body if self.truth(self.evaluate(node.test, scope)) else node.orelse, scope)

    def _visit_compare(self, node: ast.Compare, scope: Scope | None) -> Any:
        left = self.evaluate(node.left, scope)
        result: Any = True
        for operation, comparator in zip(node.ops, node.comparators, strict=True):
            right = self.evaluate(comparator, scope)
            result = self.compare(node, operation, left, right)
            if not self.truth(result):
                return result
            left = right
        return result

    def _visit_subscript(self, node: ast.Subscript, scope: Scope | None) -> Any:
        value = self.evaluate(node.value, scope)
        index = self.evaluate(node.slice, scope)
        if isinstance(value, (Function, Stream)) or isinstance(index, (Function, Stream)):
            raise UnknownValue("a function is not looked into")
        return self.admit(self.do(node, operator.getitem, value, index))

    def _visit_slice(self, node: ast.Slice, scope: Scope | None) -> Any:
        parts = [None if part is None else self.evaluate(part, scope) for part in (node.lower, node.upper, node.step)]
        self.plain(*parts)
        return slice(*parts)

    def _visit_attribute(self, node: ast.Attribute, scope: Scope | None) -> Any:
        return attribute(self, node, self.evaluate(node.value, scope))

    def _visit_joinedstr(self, node: ast.JoinedStr, scope: Scope | None) -> Any:
        return self.admit("".join([self.evaluate(part, scope) for part in node.values]))

    def _visit_formattedvalue(self, node: ast.FormattedValue, scope: Scope | None) -> Any:
        value = self.evaluate(node.value, scope)
        specification = "" if node.format_spec is None else self.evaluate(node.format_spec, scope)
        if node.conversion == ord("s"):
            value = self.show(value, node)
        elif node.conversion in (ord("r"), ord("a")):
            self.showable(value)
            value = (repr if node.conversion == ord("r") else ascii)(value)
        return self.format(node, value, specification)

    def _visit_call(self, node: ast.Call, scope: Scope | None) -> Any:
        function = self.evaluate(node.func, scope)
        positional = self.elements(node.args, scope)
        named: dict[str, Any] = {}
        for keyword in node.keywords:
            value = self.evaluate(keyword.value, scope)
            if keyword.arg is not None:
                named[keyword.arg] = value
            elif isinstance(value, dict) and all(isinstance(name, str) and name not in named for name in value):
                self.charge(10 * len(value))
                named.update(value)
            else:
                raise self.failure(node, TypeError("argument after ** must be a mapping of new names"))
        if not isinstance(function, Function):
            if isinstance(function, Stream):
                raise UnknownValue("a generator is not looked into")
            raise self.failure(node, TypeError(f"{type(function).__name__!r} object is not callable"))
        return self.admit(self.do(node, function.call, self, node, scope, positional, named))

    def call(self, node: ast.AST, scope: Scope | None, function: Any) -> Callable[..., Any]:
        """``function`` as Python's own ``map``, ``sorted`` and the like can call it."""
        if not isinstance(function, Function) or function.name == "eval":
            raise UnknownValue("this use of a function is not looked into")

        def called(*values: Any) -> Any:
            self.steps -= 1
            if self.steps < 0:
                raise UnknownValue(f"the expression needs more than {MOST_STEPS} steps")
            return self.admit(function.call(self, node, scope, list(values), {}))

        return called

    def _visit_lambda(self, node: ast.Lambda, scope: Scope | None) -> Any:
        given = node.args
        if given.posonlyargs or given.kwonlyargs or given.vararg or given.kwarg:
            raise UnknownValue("a lambda with special arguments is not looked into")
        names = [argument.arg for argument in given.args]
        defaults = [self.evaluate(default, scope) for default in given.defaults]

        def call(interpreter: Interpreter, at: ast.AST, _scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
            missing = len(names) - len(positional)
            if named:
                raise UnknownValue("a lambda called with named arguments is not looked into")
            if missing < 0 or missing > len(defaults):
                raise TypeError(f"<lambda>() takes {len(names)} positional arguments but {len(positional)} were given")
            values = positional + defaults[len(defaults) - missing :]
            return interpreter.evaluate(node.body, Scope(scope, dict(zip(names, values, strict=True))))

        return Function("lambda", call)

    def _visit_listcomp(self, node: ast.ListComp, scope: Scope | None) -> Any:
        return self.admit([self.evaluate(node.elt, inner) for inner in self.rounds(node, node.generators, scope)])

    def _visit_setcomp(self, node: ast.SetComp, scope: Scope | None) -> Any:
        made = [self.evaluate(node.elt, inner) for inner in self.rounds(node, node.generators, scope)]
        return self.admit(self.do(node, set, made))

    def _visit_dictcomp(self, node: ast.DictComp, scope: Scope | None) -> Any:
        result: dict[Any, Any] = {}
        for inner in self.rounds(node, node.generators, scope):
            key = self.evaluate(node.key, inner)
            self.plain(key)
            self.do(node, result.__setitem__, key, self.evaluate(node.value, inner))
        return self.admit(result)

    def _visit_generatorexp(self, node: ast.GeneratorExp, scope: Scope | None) -> Any:
        rounds = self.rounds(node, node.generators, scope)
        return Stream(self.evaluate(node.elt, inner) for inner in rounds)

    def rounds(self, node: ast.AST, generators: list[ast.comprehension], scope: Scope | None) -> Iterator[Scope]:
        """The scopes of a comprehension, one per round; only its first iterable is computed outside, and at once."""
        first = self.items(generators[0].iter, self.evaluate(generators[0].iter, scope))
        targets = [name.id for clause in generators for name in ast.walk(clause.target) if isinstance(name, ast.Name)]
        inner = Scope(scope, dict.fromkeys(targets, _UNBOUND))
        return self.turn(node, generators, 0, first, inner)

    def turn(self, node: ast.AST, generators: list[ast.comprehension], level: int, items: Iterator[Any], scope: Scope) -> Iterator[Scope]:
        """Go through the items of the clause ``level``, and for each through the clauses after it."""
        clause = generators[level]
        if clause.is_async:
            raise UnknownValue("an asynchronous comprehension is not looked into")
        for item in items:
            self.bind(clause.target, item, scope)
            if all(self.truth(self.evaluate(condition, scope)) for condition in clause.ifs):
                if level + 1 == len(generators):
                    yield scope
                else:
                    following = generators[level + 1].iter
                    yield from self.turn(node, generators, level + 1, self.items(following, self.evaluate(following, scope)), scope)

    def bind(self, target: ast.expr, value: Any, scope: Scope) -> None:
        """Give the names of ``target`` their values."""
        if isinstance(target, ast.Name):
            scope.names[target.id] = value
        elif isinstance(target, (ast.Tuple, ast.List)) and not any(isinstance(part, ast.Starred) for part in target.elts):
            values = list(self.items(target, value))
            if len(values) != len(target.elts):
                raise self.failure(target, ValueError(f"cannot unpack {len(values)} values into {len(target.elts)} names"))
            for part, item in zip(target.elts, values, strict=True):
                self.bind(part, item, scope)
        else:
            raise UnknownValue("this target of a comprehension is not looked into")

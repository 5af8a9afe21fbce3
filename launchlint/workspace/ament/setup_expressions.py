"""Expressions of a ``setup.py``: what they come to without running them."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from pathlib import PurePosixPath

from launchlint.workspace.ament.setup_calls import attribute, call_method, call_named
from launchlint.workspace.ament.setup_files import Files
from launchlint.workspace.ament.setup_values import UNKNOWN, Function, Method, Name, is_known, items

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.ament.setup_values import Value

_MOST_ITEMS = 20_000
_LONGEST = 100_000
_BUILTINS = frozenset("list tuple set sorted reversed zip enumerate str len dict print open range".split())


class TooMuch(Exception):
    """There is more to work out than anybody would write."""


class Evaluator:
    """Expressions among ``variables``; ``setups`` keeps the arguments of each call of ``setup()``, ``run`` calls functions of the file."""

    def __init__(self, files: Files, variables: dict[str, Value], run: Callable[[Function, list[Value], dict[str, Value]], Value]) -> None:
        self.files = files
        self.variables = variables
        self.setups: list[dict[str, Value]] = []
        self._run = run
        self._left = 200_000

    def value(self, node: ast.expr | None) -> Value:
        """What ``node`` comes to.

        Raises:
            TooMuch: there is a bound.
        """
        self._left -= 1
        if self._left < 0:
            raise TooMuch
        if node is None:
            return None
        does = getattr(self, f"_{type(node).__name__.lower()}", None)
        return UNKNOWN if does is None else does(node)

    def truth(self, node: ast.expr) -> bool | None:
        """Whether it is true; ``None`` where that is not known."""
        value = self.value(node)
        return bool(value) if is_known(value) else None

    def assign(self, target: ast.expr, value: Value) -> None:
        """``target = value``."""
        if isinstance(target, ast.Name):
            self.variables[target.id] = value
        elif isinstance(target, (ast.Tuple, ast.List)):
            parts = list(value) if isinstance(value, (list, tuple)) and len(value) == len(target.elts) else [UNKNOWN] * len(target.elts)
            for each, part in zip(target.elts, parts, strict=True):
                self.assign(each.value if isinstance(each, ast.Starred) else each, UNKNOWN if isinstance(each, ast.Starred) else part)
        elif isinstance(target, ast.Subscript):
            self._store(self.value(target.value), self.value(target.slice), value)

    def _store(self, holder: Value, key: Value, value: Value) -> None:
        if isinstance(holder, dict) and isinstance(key, (str, int)):
            holder[key] = value
        elif isinstance(holder, list):
            if isinstance(key, int) and -len(holder) <= key < len(holder):
                holder[key] = value
            else:
                holder.append(UNKNOWN)

    # -- one for each kind of node ------------------------------------------------------------------------------------

    def _constant(self, node: ast.Constant) -> Value:
        return node.value if isinstance(node.value, (str, int, float, bool, type(None))) else UNKNOWN

    def _name(self, node: ast.Name) -> Value:
        if node.id in self.variables:
            return self.variables[node.id]
        return Name(node.id) if node.id in _BUILTINS else UNKNOWN

    def _attribute(self, node: ast.Attribute) -> Value:
        return attribute(self.value(node.value), node.attr)

    def _joinedstr(self, node: ast.JoinedStr) -> Value:
        parts: list[str] = []
        for each in node.values:
            value = self.value(each.value) if isinstance(each, ast.FormattedValue) and each.format_spec is None else self.value(each)
            if not isinstance(value, (str, int, PurePosixPath)):
                return UNKNOWN
            parts.append(str(value))
        return "".join(parts) if sum(map(len, parts)) <= _LONGEST else UNKNOWN

    def _list(self, node: ast.List | ast.Tuple | ast.Set) -> Value:
        found: list[Value] = []
        for each in node.elts:
            if isinstance(each, ast.Starred):
                listed = items(self.value(each.value))
                found += [UNKNOWN] if listed is None else listed
            else:
                found.append(self.value(each))
        return self._bounded(found)

    def _tuple(self, node: ast.Tuple) -> Value:
        return tuple(self._list(node))

    def _set(self, node: ast.Set) -> Value:
        return self._list(node)

    def _dict(self, node: ast.Dict) -> Value:
        found: dict[Value, Value] = {}
        for key, value in zip(node.keys, node.values, strict=True):
            each = self.value(value)
            if key is None:
                if not isinstance(each, dict):
                    return UNKNOWN
                found.update(each)
            elif isinstance(name := self.value(key), (str, int)):
                found[name] = each
            else:
                return UNKNOWN
        return found

    def _subscript(self, node: ast.Subscript) -> Value:
        holder = self.value(node.value)
        if isinstance(node.slice, ast.Slice):
            parts = [self.value(each) for each in (node.slice.lower, node.slice.upper, node.slice.step)]
            sliced = (
                isinstance(holder, (list, tuple, str)) and is_known(holder) and all(isinstance(each, (int, type(None))) for each in parts)
            )
            return holder[slice(*parts)] if sliced and parts[2] != 0 else UNKNOWN
        key = self.value(node.slice)
        if isinstance(holder, dict):
            return holder[key] if isinstance(key, (str, int)) and (key in holder or hasattr(holder, "default_factory")) else UNKNOWN
        if isinstance(holder, (list, tuple, str)) and isinstance(key, int) and is_known(holder) and -len(holder) <= key < len(holder):
            return holder[key]
        return UNKNOWN

    def _binop(self, node: ast.BinOp) -> Value:
        left, right = self.value(node.left), self.value(node.right)
        if isinstance(node.op, ast.Add):
            return self.add(left, right)
        if isinstance(node.op, ast.Div) and isinstance(left, (PurePosixPath, str)) and isinstance(right, (PurePosixPath, str)):
            return PurePosixPath(left) / right
        if isinstance(node.op, ast.Mod) and isinstance(left, str) and is_known(right) and left.count("%") == left.count("%s"):
            try:
                return left % (tuple(right) if isinstance(right, tuple) else (right,))
            except TypeError:
                return UNKNOWN
        return UNKNOWN

    def add(self, left: Value, right: Value) -> Value:
        """``left + right``; a list with one that is not known has more than is known."""
        if isinstance(left, list) and isinstance(right, list):
            return self._bounded(left + right)
        if isinstance(left, tuple) and isinstance(right, tuple):
            return self._bounded(left + right)
        if isinstance(left, str) and isinstance(right, str):
            return left + right if len(left) + len(right) <= _LONGEST else UNKNOWN
        if isinstance(left, list) and right is UNKNOWN:
            return [*left, UNKNOWN]
        if isinstance(right, list) and left is UNKNOWN:
            return [UNKNOWN, *right]
        known = isinstance(left, int) and isinstance(right, int) and abs(left) + abs(right) < 1 << 40
        return left + right if known else UNKNOWN

    def _bounded(self, found: Value) -> Value:
        if len(found) > _MOST_ITEMS:
            raise TooMuch
        self._left -= len(found) // 8
        return found

    def _unaryop(self, node: ast.UnaryOp) -> Value:
        value = self.value(node.operand)
        if isinstance(node.op, ast.Not):
            return not value if is_known(value) else UNKNOWN
        return -value if isinstance(node.op, ast.USub) and isinstance(value, int) else UNKNOWN

    def _boolop(self, node: ast.BoolOp) -> Value:
        value: Value = UNKNOWN
        for each in node.values:
            value = self.value(each)
            if not is_known(value):
                return UNKNOWN
            if bool(value) is isinstance(node.op, ast.Or):
                break
        return value

    def _compare(self, node: ast.Compare) -> Value:
        left, right = self.value(node.left), self.value(node.comparators[0])
        if len(node.ops) != 1 or not is_known(left) or not is_known(right):
            return UNKNOWN
        operator = node.ops[0]
        if isinstance(operator, (ast.Eq, ast.Is)):
            return left == right
        if isinstance(operator, (ast.NotEq, ast.IsNot)):
            return left != right
        if isinstance(operator, (ast.In, ast.NotIn)) and (
            isinstance(right, (list, tuple, dict)) or isinstance(left, str) is isinstance(right, str)
        ):
            return (left in right) is isinstance(operator, ast.In)
        return UNKNOWN

    def _ifexp(self, node: ast.IfExp) -> Value:
        truth = self.truth(node.test)
        return UNKNOWN if truth is None else self.value(node.body if truth else node.orelse)

    def _lambda(self, node: ast.Lambda) -> Value:
        return Function(node.args, node.body, self.variables)

    def _namedexpr(self, node: ast.NamedExpr) -> Value:
        value = self.value(node.value)
        self.assign(node.target, value)
        return value

    def _listcomp(self, node: ast.ListComp | ast.GeneratorExp | ast.SetComp) -> Value:
        outer = self.variables
        self.variables = dict(outer)
        try:
            return self._bounded([self.value(node.elt) if sure else UNKNOWN for sure in self._through(node.generators)])
        finally:
            self.variables = outer

    def _generatorexp(self, node: ast.GeneratorExp) -> Value:
        return self._listcomp(node)

    def _setcomp(self, node: ast.SetComp) -> Value:
        return self._listcomp(node)

    def _dictcomp(self, node: ast.DictComp) -> Value:
        outer = self.variables
        self.variables = dict(outer)
        found: dict[Value, Value] = {}
        try:
            for sure in self._through(node.generators):
                key = self.value(node.key)
                if not sure or not isinstance(key, (str, int)):
                    return UNKNOWN
                found[key] = self.value(node.value)
            return found
        finally:
            self.variables = outer

    def _through(self, generators: list[ast.comprehension]) -> Iterator[bool]:
        """Set the variables of a comprehension one way after another; false where it is not sure that there is this one."""
        first, *rest = generators
        listed = items(self.value(first.iter))
        for item in [UNKNOWN] if listed is None else listed:
            self.value(None)
            self.assign(first.target, item)
            truths = [self.truth(test) for test in first.ifs]
            if False in truths:
                continue
            sure = item is not UNKNOWN and None not in truths
            for inner in self._through(rest) if rest else (True,):
                yield sure and inner

    def _call(self, node: ast.Call) -> Value:
        called = self.value(node.func)
        given: list[Value] = []
        for each in node.args:
            if isinstance(each, ast.Starred):
                listed = items(self.value(each.value))
                given += [UNKNOWN] if listed is None else listed
            else:
                given.append(self.value(each))
        named: dict[str, Value] = {}
        for keyword in node.keywords:
            value = self.value(keyword.value)
            if keyword.arg is not None:
                named[keyword.arg] = value
            elif isinstance(value, dict) and all(isinstance(key, str) for key in value):
                named.update(value)
            else:
                named["**"] = UNKNOWN
        if isinstance(called, Function):
            return self._run(called, given, named)
        if isinstance(called, Name) and called.dotted.rpartition(".")[2] == "setup":
            self.setups.append(named)
            return None
        try:
            if isinstance(called, Method):
                return call_method(called.of, called.name, given, named, self.files)
            return call_named(called.dotted, given, named, self.files) if isinstance(called, Name) else UNKNOWN
        except (TypeError, ValueError, KeyError, IndexError, AttributeError):  # what would stop the real one, too
            return UNKNOWN

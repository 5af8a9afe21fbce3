"""What an expression asks for, read from its tree without computing anything."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from functools import lru_cache
from types import MappingProxyType

from launchlint.evaluate.expression.compiled import compiled
from launchlint.evaluate.ros1.expression.names import RESERVED
from launchlint.evaluate.ros1.expression.resolver import ExpressionError, UnknownValue
from launchlint.evaluate.ros1.values import automatic

_WORD = re.compile(r"[^\W\d]\w*")
_KEYWORDS = frozenset("and else False for if in is lambda None not or True".split())
_MOST_NESTED = 5
#: Methods and functions that pass on what the arg is, so that a comparison behind them is one with the arg.
_TRANSPARENT_METHODS = frozenset({"casefold", "lower", "lstrip", "replace", "rstrip", "strip", "upper"})
_TRANSPARENT_FUNCTIONS = frozenset({"bool", "float", "int", "str"})
_LITERAL_METHODS = frozenset({"count", "endswith", "find", "index", "startswith"})
_ORDER = (ast.Lt, ast.LtE, ast.Gt, ast.GtE)
_WHOLE = 1e15  # up to here a float still tells neighbouring whole numbers apart
#: Every configuration of every entry file that reaches a file asks the same of its expressions.
_MOST_KEPT = 512


@lru_cache(maxsize=_MOST_KEPT)
def names_read(text: str) -> frozenset[str]:
    """See :func:`launchlint.evaluate.ros1.expression.arguments_read`."""
    try:
        tree = compiled(text).tree
    except (ExpressionError, UnknownValue):
        return frozenset(_WORD.findall(text)) - RESERVED - _KEYWORDS
    return frozenset(_names(tree, _MOST_NESTED))


def _names(tree: ast.AST, nested: int) -> Iterator[str]:
    bound = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load)}
    bound |= {node.arg for node in ast.walk(tree) if isinstance(node, ast.arg)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and node.id not in RESERVED and node.id not in bound:
            yield node.id
        elif isinstance(node, ast.Call):
            name = _arg_call(node)
            if name is not None:
                yield name
            inner = _nested(node, nested)
            if inner is not None:
                yield from _names(inner, nested - 1)


@lru_cache(maxsize=_MOST_KEPT)
def literals_compared(text: str, *, exact: bool = False, parts: bool = True) -> Mapping[str, tuple[str, ...]]:
    """See :func:`launchlint.evaluate.ros1.expression.compared_literals`."""
    try:
        tree = compiled(text).tree
    except (ExpressionError, UnknownValue):
        return {}
    found: dict[str, dict[str, None]] = {}
    _collect(tree, found, _MOST_NESTED, exact=exact, parts=parts and not exact)
    return MappingProxyType({name: tuple(values) for name, values in found.items() if values})


@lru_cache(maxsize=_MOST_KEPT)
def names_as_text(text: str) -> frozenset[str]:
    """See :func:`launchlint.evaluate.ros1.expression.made_into_text`."""
    try:
        waiting: list[tuple[ast.AST, bool]] = [(compiled(text).tree, False)]
    except (ExpressionError, UnknownValue):
        return frozenset()
    found = set()
    while waiting:
        node, computed = waiting.pop()
        name = _arg_call(node) if isinstance(node, ast.Call) else node.id if isinstance(node, ast.Name) else None
        if name is not None and computed and name not in RESERVED:
            found.add(name)
        method = isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)
        if method or isinstance(node, (ast.BinOp, ast.JoinedStr, ast.Subscript)):
            computed = True
        elif isinstance(node, (ast.BoolOp, ast.Compare)) or (isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not)):
            computed = False
        test = node.test if isinstance(node, ast.IfExp) else None
        waiting.extend((child, computed and child is not test) for child in ast.iter_child_nodes(node))
    return frozenset(found)


@lru_cache(maxsize=_MOST_KEPT)
def names_as_truth(text: str) -> frozenset[str]:
    """See :func:`launchlint.evaluate.ros1.expression.truth_tested`."""
    try:
        tree = compiled(text).tree
    except (ExpressionError, UnknownValue):
        return frozenset()
    tested: list[ast.AST] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.BoolOp):
            tested += node.values
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            tested.append(node.operand)
        elif isinstance(node, ast.IfExp):
            tested.append(node.test)
    return frozenset(name for name in map(_arg_name, tested) if name is not None)


@lru_cache(maxsize=_MOST_KEPT)
def only_name(text: str) -> str | None:
    """See :func:`launchlint.evaluate.ros1.expression.whole_arg`."""
    try:
        body = compiled(text).tree.body
    except (ExpressionError, UnknownValue):
        return None
    return _arg_name(body) if isinstance(body, ast.Name) or (isinstance(body, ast.Call) and _arg_call(body) is not None) else None


@lru_cache(maxsize=_MOST_KEPT)
def comparisons_never_equal(text: str) -> tuple[tuple[int, int, str, str, bool], ...]:
    """See :func:`launchlint.evaluate.ros1.expression.never_equal`."""
    return tuple(_never_equal(text))


def _never_equal(text: str) -> Iterator[tuple[int, int, str, str, bool]]:
    try:
        whole = compiled(text)
    except (ExpressionError, UnknownValue):
        return
    bound = {node.id for node in ast.walk(whole.tree) if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load)}
    for node in _in_order(whole.tree):
        if not isinstance(node, ast.Compare) or len(node.ops) != 1 or not isinstance(node.ops[0], (ast.Eq, ast.NotEq)):
            continue
        for side, other in ((node.left, node.comparators[0]), (node.comparators[0], node.left)):
            name = side.id if isinstance(side, ast.Name) else _arg_call(side) if isinstance(side, ast.Call) else None
            if name is None or name in bound or (isinstance(side, ast.Name) and name in RESERVED):
                continue
            if isinstance(other, ast.Constant) and isinstance(other.value, str) and not isinstance(automatic(other.value), str):
                yield (*whole.span(node), name, other.value, isinstance(node.ops[0], ast.NotEq))


def _collect(tree: ast.Expression, found: dict[str, dict[str, None]], nested: int, *, exact: bool, parts: bool) -> None:
    _condition(tree.body, found)
    for node in _in_order(tree):
        if isinstance(node, ast.Compare):
            left = node.left
            for operation, right in zip(node.ops, node.comparators, strict=True):
                _comparison(left, operation, right, found, exact=exact, parts=parts)
                left = right
        elif isinstance(node, ast.BoolOp):
            for value in node.values:
                _condition(value, found)
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            _condition(node.operand, found)
        elif isinstance(node, ast.IfExp):
            _condition(node.test, found)
        elif isinstance(node, ast.Subscript):
            _note(_arg_name(node.slice), _keys(node.value), found)
        elif isinstance(node, ast.Call):
            if isinstance(node.func, ast.Attribute) and node.args:
                if node.func.attr == "get":
                    _note(_arg_name(node.args[0]), _keys(node.func.value), found)
                elif node.func.attr in _LITERAL_METHODS and not exact:
                    _note(_arg_name(node.func.value), _spelled(node.args[0]), found)
            inner = _nested(node, nested)
            if inner is not None:
                _collect(inner, found, nested - 1, exact=exact, parts=parts)


def _in_order(node: ast.AST) -> Iterator[ast.AST]:
    """The nodes of a tree as they stand in the text."""
    waiting = [node]
    while waiting:
        node = waiting.pop()
        yield node
        waiting.extend(reversed(list(ast.iter_child_nodes(node))))


def _condition(node: ast.expr, found: dict[str, dict[str, None]]) -> None:
    _note(_arg_name(node), ["true", "false"], found)


def _comparison(
    left: ast.expr, operation: ast.cmpop, right: ast.expr, found: dict[str, dict[str, None]], *, exact: bool, parts: bool
) -> None:
    for side, other in ((left, right), (right, left)):
        name = _arg_name(side)
        if name is None or (not parts and side is right and isinstance(operation, (ast.In, ast.NotIn))):
            continue
        values = _keys(other) or _spelled(other)
        if isinstance(operation, _ORDER) and not exact:
            values = [spelled for value in values for spelled in _neighbours(value)]
        _note(name, values, found)


def _note(name: str | None, values: list[str], found: dict[str, dict[str, None]]) -> None:
    if name is not None:
        found.setdefault(name, {}).update(dict.fromkeys(values))


def _arg_name(node: ast.AST) -> str | None:
    """The arg whose value ``node`` is, perhaps as text, as number or in lower case."""
    while True:
        if isinstance(node, ast.Name):
            return None if node.id in RESERVED else node.id
        if not isinstance(node, ast.Call):
            return None
        name = _arg_call(node)
        if name is not None:
            return name
        if isinstance(node.func, ast.Attribute) and node.func.attr in _TRANSPARENT_METHODS:
            node = node.func.value
        elif isinstance(node.func, ast.Name) and node.func.id in _TRANSPARENT_FUNCTIONS and len(node.args) == 1:
            node = node.args[0]
        else:
            return None


def _arg_call(node: ast.Call) -> str | None:
    """The name in ``arg('name')``."""
    if isinstance(node.func, ast.Name) and node.func.id == "arg":
        for value in (*node.args, *(keyword.value for keyword in node.keywords)):
            if isinstance(value, ast.Constant) and isinstance(value.value, str):
                return value.value
    return None


def _nested(node: ast.Call, nested: int) -> ast.Expression | None:
    """The tree of the text in ``eval('text')``."""
    if nested > 0 and isinstance(node.func, ast.Name) and node.func.id == "eval" and len(node.args) == 1:
        text = node.args[0]
        if isinstance(text, ast.Constant) and isinstance(text.value, str):
            try:
                return compiled(text.value).tree
            except (ExpressionError, UnknownValue):
                return None
    return None


def _keys(node: ast.AST) -> list[str]:
    """The literals in a list, tuple, set or in the keys of a dict."""
    if isinstance(node, (ast.List, ast.Tuple, ast.Set)):
        return [spelled for item in node.elts for spelled in _spelled(item)]
    if isinstance(node, ast.Dict):
        return [spelled for item in node.keys if item is not None for spelled in _spelled(item)]
    return []


def _spelled(node: ast.AST) -> list[str]:
    """A literal as a user would pass it to roslaunch."""
    if isinstance(node, ast.Name) and node.id in ("true", "false"):
        return [node.id]
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return ["-" + spelled for spelled in _spelled(node.operand) if spelled[:1].isdigit() or spelled[:1] == "."]
    if isinstance(node, ast.Constant) and not isinstance(node.value, (bytes, complex, type(None), type(...))):
        if isinstance(node.value, bool):
            return [str(node.value).lower()]
        try:
            return [str(node.value)]
        except ValueError:  # thousands of digits
            return []
    if isinstance(node, ast.Tuple):
        return _keys(node)
    return []


def _neighbours(spelled: str) -> list[str]:
    try:
        if "." not in spelled and "e" not in spelled:
            number = int(spelled)
            return [spelled, str(number - 1), str(number + 1)]
        real = float(spelled)
    except ValueError:
        return [spelled]
    return [spelled, repr(real - 1), repr(real + 1)] if abs(real) < _WHOLE else [spelled]

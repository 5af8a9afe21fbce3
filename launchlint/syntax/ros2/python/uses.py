"""Where a program uses a value as what it is at that moment: in a test, a comparison, a text, a path.

A substitution of launch is only an object then: it has its text when launch executes the description.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator

from launchlint.python.walking import walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.python.problems import Use

STOPS = frozenset(("join", "path"))
"""Uses that Python does not let pass: it raises a TypeError."""
_PATHS = frozenset("os.path.join os.path.exists os.path.isfile os.path.isdir os.path.basename os.path.dirname os.path.abspath open".split())
_NUMBERS = frozenset(("int", "float"))


def uses(tree: ast.Module) -> dict[int, tuple[Use, ast.expr]]:
    """Expressions of a module, by identity: how each is used, and the whole expression in which that is done."""
    found: dict[int, tuple[Use, ast.expr]] = {}
    for node in walk(tree):
        for use, each, whole in _uses(node):
            found.setdefault(id(each), (use, whole))
    return found


def _uses(node: ast.AST) -> Iterator[tuple[Use, ast.expr, ast.expr]]:
    if isinstance(node, (ast.If, ast.IfExp, ast.While, ast.Assert)):
        yield "test", node.test, node.test
    elif isinstance(node, ast.BoolOp):
        yield from (("test", each, each) for each in node.values[:-1])
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        yield "test", node.operand, node
    elif isinstance(node, ast.Compare):
        yield from _compared(node)
    elif isinstance(node, ast.FormattedValue):
        yield "format", node.value, node.value
    elif isinstance(node, ast.BinOp):
        if isinstance(node.op, ast.Add):
            yield "join", node.left, node
            yield "join", node.right, node
        elif isinstance(node.op, ast.Mod):
            yield from (("format", each, node) for each in (node.right.elts if isinstance(node.right, ast.Tuple) else [node.right]))
    elif isinstance(node, ast.Call):
        yield from _given(node)


def _compared(node: ast.Compare) -> Iterator[tuple[Use, ast.expr, ast.expr]]:
    sides = [node.left, *node.comparators]
    if len(node.ops) != 1 or not isinstance(node.ops[0], (ast.Eq, ast.NotEq, ast.In, ast.NotIn)):
        return
    if any(isinstance(each, ast.Constant) and each.value is None for each in sides):
        return
    looked_for = isinstance(node.ops[0], (ast.In, ast.NotIn))
    yield from (("compare", each, node) for each in (sides[:1] if looked_for else sides))


def _given(node: ast.Call) -> Iterator[tuple[Use, ast.expr, ast.expr]]:
    if isinstance(node.func, ast.Attribute) and node.func.attr == "format":
        for each in (*node.args, *(keyword.value for keyword in node.keywords)):
            yield "format", each, each
        return
    name = ast.unparse(node.func) if isinstance(node.func, (ast.Name, ast.Attribute)) else ""
    if name in _PATHS or name in _NUMBERS:
        for each in node.args[: None if name == "os.path.join" else 1]:
            yield "path", each, each
    elif name in ("str", "bool") and len(node.args) == 1:
        yield "str" if name == "str" else "test", node.args[0], node

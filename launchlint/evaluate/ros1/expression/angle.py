"""The expressions in rosparam's ``rad(…)``: like ``$(eval …)``, but with the module ``math`` by its name, and without args."""

from __future__ import annotations

import ast
from typing import Any

from launchlint.evaluate.expression.compiled import compiled
from launchlint.evaluate.expression.functions import builtin, math_name
from launchlint.evaluate.expression.interpreter import Interpreter, Scope
from launchlint.evaluate.expression.names import BUILTINS, MATH
from launchlint.evaluate.ros1.expression.resolver import ExpressionError, UnknownValue


class _AngleInterpreter(Interpreter):
    __slots__ = ("unknown",)

    def __init__(self, text: str, unknown: frozenset[str]) -> None:
        super().__init__(compiled(text))
        self.unknown = unknown

    def look_up(self, node: ast.Name, scope: Scope | None) -> Any:
        name = node.id
        if scope is not None or name in self.unknown or "__" in name or name == "math":
            raise UnknownValue(f"{name} in an angle is not looked into")
        if name in BUILTINS:
            return builtin(name)
        raise self.failure(node, NameError(f"name {name!r} is not defined"))

    def _visit_attribute(self, node: ast.Attribute, scope: Scope | None) -> Any:
        if not (isinstance(node.value, ast.Name) and node.value.id == "math"):
            return super()._visit_attribute(node, scope)
        if node.attr in MATH:
            return math_name(node.attr)
        if "__" in node.attr:
            raise UnknownValue("names with two underscores are not looked into")
        raise self.failure(node, AttributeError(f"module 'math' has no attribute {node.attr!r}"))


def angle(text: str, unknown: frozenset[str]) -> float:
    """``float()`` of the value of ``text``; ``unknown`` are names that mean something there, but nothing we look into.

    Raises ExpressionError and UnknownValue.
    """
    run = _AngleInterpreter(text, unknown)
    value = run.evaluate(run.compiled.tree.body, None)
    run.plain(value)
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise ExpressionError(f"the result is not a number (Python says: {error})", 0, len(text), type(error).__name__) from None

"""What every step of an evaluation shares: its bounds, its errors with their places, and operations on plain values."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Iterator
from typing import Any

from launchlint.evaluate.expression.bounds import (
    CONTAINERS,
    LARGEST_VALUE,
    MOST_STEPS,
    MOST_WORK,
    SETS,
    Function,
    Stream,
    check_order,
    check_power,
    check_product,
    check_shift,
    check_width,
    percent_size,
    shown_size,
    size_of,
    too_large,
)
from launchlint.evaluate.expression.compiled import Compiled
from launchlint.evaluate.expression.errors import ExpressionError, UnknownValue

_BINARY: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.MatMult: operator.matmul,
    ast.Div: operator.truediv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    ast.LShift: operator.lshift,
    ast.RShift: operator.rshift,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
    ast.BitAnd: operator.and_,
    ast.FloorDiv: operator.floordiv,
}
_COMPARISON: dict[type, Callable[[Any, Any], Any]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.In: lambda left, right: left in right,
    ast.NotIn: lambda left, right: left not in right,
}
_CHECKED_BEFORE: dict[type, Callable[[object, object], None]] = {
    ast.Pow: check_power,
    ast.LShift: check_shift,
    ast.Mult: check_product,
}
_PLAIN_WORDS = {
    "ZeroDivisionError": "this divides by zero",
    "TypeError": "this cannot be done with values of these types",
    "IndexError": "there is no element at this place",
    "KeyError": "there is no such key",
    "ValueError": "this value does not fit here",
    "AttributeError": "a value of this type does not have that",
    "OverflowError": "this number becomes too large",
    "NameError": "this name is not known",
}


class Computation:
    """One evaluation: what is left of the bounds, and where in the text we are."""

    __slots__ = ("compiled", "depth", "outer", "steps", "work")

    def __init__(self, compiled: Compiled) -> None:
        self.compiled = compiled
        self.steps = MOST_STEPS
        self.work = MOST_WORK
        self.depth = 0
        self.outer: tuple[int, int] | None = None

    def charge(self, work: int) -> None:
        """Count ``work`` against the whole; over the bound the value is unknown."""
        self.work -= work
        if self.work < 0 or work > LARGEST_VALUE:
            raise too_large("what the expression computes")

    def plain(self, *values: object) -> None:
        """Make sure that ``values`` are plain ones, and count them."""
        for value in values:
            self.charge(size_of(value))

    def span(self, node: ast.AST) -> tuple[int, int]:
        """Where ``node`` stands in the text; what a nested ``eval`` reads stands where the call stands."""
        return self.compiled.span(node) if self.outer is None else self.outer

    def failure(self, node: ast.AST, error: Exception) -> ExpressionError:
        """The error that the launcher would meet at ``node``."""
        kind = type(error).__name__
        words = _PLAIN_WORDS.get(kind, "this cannot be computed")
        said = str(error)
        said = said if len(said) <= 200 else said[:197] + "..."
        return ExpressionError(f"{words} (Python says: {kind}: {said})", *self.span(node), kind)

    def do(self, node: ast.AST, function: Callable[..., Any], *values: Any) -> Any:
        """Call ``function``; what it raises becomes an error at ``node``."""
        try:
            return function(*values)
        except (ExpressionError, UnknownValue):
            raise
        except (RecursionError, MemoryError):
            raise too_large("what the expression computes") from None
        except Exception as error:  # whatever Python says about harmless values, the launcher would meet too
            raise self.failure(node, error) from None

    def admit(self, value: Any) -> Any:
        """Let a result in: functions and streams as they are, plain values within their bounds."""
        if not isinstance(value, (Function, Stream)):
            self.charge(size_of(value, functions=True))
        return value

    def items(self, node: ast.AST, value: Any, any_order: bool = False) -> Iterator[Any]:
        """Go through ``value``, counting; with ``any_order`` a set may be gone through too."""
        if isinstance(value, Function):
            raise UnknownValue("a function is not looked into")
        if isinstance(value, SETS) and not (any_order and len({type(item) for item in value}) <= 1):
            check_order(value)
        source = value.items if isinstance(value, Stream) else self.do(node, iter, value)
        return self.counted(source)

    def counted(self, source: Any) -> Iterator[Any]:
        """The items of ``source``, each counted."""
        for item in source:
            self.charge(10)
            yield item

    def truth(self, value: Any) -> bool:
        """``bool(value)``; functions and generators are true."""
        return True if isinstance(value, (Function, Stream)) else bool(value)

    def operate(self, node: ast.AST, operation: type, left: Any, right: Any) -> Any:
        """``left operation right``, if the result stays within the bounds."""
        self.plain(left, right)
        check = _CHECKED_BEFORE.get(operation)
        if check is not None:
            check(left, right)
        if operation is ast.Mod and isinstance(left, str):
            check_order(right)
            self.charge(percent_size(left, right))
        return self.admit(self.do(node, _BINARY[operation], left, right))

    def compare(self, node: ast.AST, operation: ast.cmpop, left: Any, right: Any) -> Any:
        """One comparison. ``is`` is answered where it does not depend on how Python stores values."""
        if isinstance(operation, (ast.In, ast.NotIn)) and isinstance(right, Stream):
            self.plain(left)
            found = self.do(node, operator.contains, self.items(node, right), left)
            return found is isinstance(operation, ast.In)
        self.plain(left, right)
        if isinstance(operation, (ast.Is, ast.IsNot)):
            return same_object(left, right) is isinstance(operation, ast.Is)
        return self.do(node, _COMPARISON[type(operation)], left, right)

    def showable(self, value: Any) -> None:
        """Make sure that ``str(value)`` is the same everywhere and not too long."""
        self.plain(value)
        check_order(value)
        self.charge(shown_size(value) if isinstance(value, (dict, *CONTAINERS)) else 1)

    def show(self, value: Any, node: ast.AST) -> str:
        """``str(value)``."""
        self.showable(value)
        text: str = self.do(node, str, value)
        return text

    def format(self, node: ast.AST, value: Any, specification: Any) -> str:
        """``format(value, specification)``."""
        self.showable(value)
        if isinstance(specification, str):
            self.charge(check_width(specification))
            if specification.endswith("n"):
                raise UnknownValue("numbers written as the language of the user wants them differ between machines")
        text: str = self.admit(self.do(node, format, value, specification))
        return text


def same_object(left: Any, right: Any) -> bool:
    """``left is right``, where that follows from the values."""
    if any(value is single for value in (left, right) for single in (None, True, False)):
        return left is right
    if type(left) is not type(right) or (left != right and left == left):
        return False
    if type(left) is int and -5 <= left <= 256:
        return True
    raise UnknownValue("whether equal values are one object depends on how Python stores them")

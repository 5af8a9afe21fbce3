"""``$(eval …)``: Python's own ``eval`` over its builtins and the names of some modules (launch.substitutions.PythonExpression).

The values of other substitutions are in the text before it is evaluated: an expression knows no launch configurations.
"""

from __future__ import annotations

import ast
import os
from typing import Any

from launchlint.evaluate.expression.bounds import Function
from launchlint.evaluate.expression.compiled import Compiled, compiled
from launchlint.evaluate.expression.errors import ExpressionError, UnknownValue
from launchlint.evaluate.expression.functions import builtin, math_name
from launchlint.evaluate.expression.interpreter import NOT_INNER, Interpreter, Scope
from launchlint.evaluate.expression.methods import attribute
from launchlint.evaluate.expression.names import BUILTINS, MATH
from launchlint.evaluate.problems import EvalError, EvalNotCovered
from launchlint.evaluate.ros2.context import Value
from launchlint.evaluate.ros2.performing import Failure, Performer
from launchlint.model import Unknown
from launchlint.syntax.ros2.description import Substitution

_IMPORT = "__import__"


class Module:
    """A module of Python: ``name`` is what follows of it is looked up in."""

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        self.name = name


def _text_function(name: str, function: Any) -> Function:
    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        run.plain(*positional, *named.values())
        return function(*positional, **named)

    return Function(name, call)


_KNOWN: dict[str, dict[str, Any]] = {
    "os": {"sep": os.sep, "linesep": os.linesep, "pathsep": os.pathsep, "path": Module("os.path")},
    "os.path": {
        "sep": os.sep,
        **{
            name: _text_function(name, getattr(os.path, name))
            for name in ("basename", "commonprefix", "dirname", "isabs", "join", "normpath", "split", "splitext")
        },
    },
}
"""What modules hold that only computes, besides ``math``: nothing that looks at files or at the environment."""
_MODULES = frozenset(_KNOWN) | {"math"}
_NO_MODULE = frozenset(" '\"()/")
"""Characters that stand in the name of no module: a piece of an expression is taken for one, in which a quote ended too early."""


class _PythonInterpreter(Interpreter):
    """One evaluation; ``modules`` are those that are there by their names."""

    __slots__ = ("modules", "whole")

    def __init__(self, compiled: Compiled, modules: tuple[str, ...], by_name: tuple[str, ...]) -> None:
        super().__init__(compiled)
        self.whole = "math" in modules
        self.modules = frozenset(name for name in modules if name != "math" or name in by_name)

    def look_up(self, node: ast.Name, scope: Scope | None) -> Any:
        """The value of a name: inner names; at the top level those of the modules; then Python's builtins."""
        name = node.id
        found = self.inner(node, scope)
        if found is not NOT_INNER:
            return found
        if name == _IMPORT:
            return Function(_IMPORT, _import)
        if "__" in name:
            raise UnknownValue("names with two underscores are not looked into")
        if name in self.modules or (self.whole and name in MATH):
            if scope is not None:
                raise UnknownValue("what a comprehension or lambda sees of modules depends on the version of Python")
            return Module(name) if name in self.modules else math_name(name)
        if name in BUILTINS:
            return builtin(name)
        raise self.failure(node, NameError(f"name {name!r} is not defined"))

    def admit(self, value: Any) -> Any:
        return value if isinstance(value, Module) else super().admit(value)

    def _visit_attribute(self, node: ast.Attribute, scope: Scope | None) -> Any:
        value = self.evaluate(node.value, scope)
        return self._of_module(node, value) if isinstance(value, Module) else attribute(self, node, value)

    def _of_module(self, node: ast.Attribute, module: Module) -> Any:
        name = node.attr
        if module.name == "math" and name in MATH:
            return math_name(name)
        if name in _KNOWN.get(module.name, ()):
            return _KNOWN[module.name][name]
        if module.name == "math" and "__" not in name:
            raise self.failure(node, AttributeError(f"module 'math' has no attribute {name!r}"))
        raise UnknownValue(f"{module.name}.{name} is not looked into")


def _import(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    if len(positional) != 1 or named or positional[0] not in _MODULES:
        raise UnknownValue("what an expression imports is not looked into")
    return Module(positional[0].partition(".")[0])


def evaluate(performer: Performer, substitution: Substitution, text: str, modules: tuple[str, ...]) -> Value:
    """What ``$(eval text)`` becomes: ``str()`` of the value. Raises Failure where Python would raise; unknown where it cannot be told."""
    by_name = performer.rules.modules if modules == ("math",) and len(substitution.arguments) < 2 else modules
    place = substitution.place
    performer.spend(len(text), place)
    none = next((name for name in modules if not name or not _NO_MODULE.isdisjoint(name)), None)
    if none is not None:
        reason = f"ModuleNotFoundError: No module named {none!r}" if none else "ValueError: Empty module name"
        raise Failure(EvalError(origin=performer.where(place), refused=True, reason=reason, expression=text, known=()))
    try:
        missing = next((name for name in modules if name not in _MODULES), None)
        if missing is not None:
            raise UnknownValue(f"the module {missing} is not looked into")
        run = _PythonInterpreter(compiled(text), modules, by_name)
        body = run.compiled.tree.body
        return run.show(run.evaluate(body, None), body)
    except (UnknownValue, RecursionError) as unknown:
        reason = unknown.reason if isinstance(unknown, UnknownValue) else "the expression is nested too deeply to be looked into"
        performer.notice(EvalNotCovered(origin=performer.where(place), reason=reason))
        return Unknown(place.text, reason)
    except ExpressionError as error:
        problem = EvalError(origin=performer.where(place), refused=True, reason=str(error), expression=text, known=())
        raise Failure(problem) from None

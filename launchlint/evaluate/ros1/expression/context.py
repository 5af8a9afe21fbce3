"""The functions that roslaunch itself hands to an expression (roslaunch.substitution_args._eval)."""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING, Any

from launchlint.evaluate.expression.bounds import Function
from launchlint.evaluate.expression.errors import ExpressionError, UnknownValue
from launchlint.evaluate.expression.functions import bound

if TYPE_CHECKING:
    from launchlint.evaluate.expression.interpreter import Scope
    from launchlint.evaluate.ros1.expression.interpreter import ArgInterpreter

_UNIQUE_DEFAULT = "\0 the default of optenv \0"


def context_function(name: str) -> Function:
    """``arg``, ``anon``, ``dirname``, ``env``, ``optenv`` or ``find``, as roslaunch hands them in."""
    return _CONTEXT[name]


def _arg(run: ArgInterpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    from launchlint.evaluate.ros1.values import automatic

    (name,) = bound("arg", ("name",), 0, positional, named)
    if isinstance(name, (list, dict, set)):
        raise TypeError(f"unhashable type: {type(name).__name__!r}")
    if not isinstance(name, str):
        shown = run.show(name, node)
        words = f"the name of an arg is a text, so there is no arg {shown} (roslaunch says: ArgException: {shown})"
        raise ExpressionError(words, *run.span(node), "ArgException", undefined_arg=shown)
    return automatic(run.ask(node, run.resolver.arg, name))


def _anon(run: ArgInterpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    (identifier,) = bound("anon", ("id",), 0, positional, named)
    if not isinstance(identifier, str):
        raise UnknownValue("an anonymous name for something that is not a text is not looked into")
    return run.ask(node, run.resolver.anon, identifier)


def _dirname(run: ArgInterpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    bound("dirname", (), 0, positional, named)
    return run.ask(node, run.resolver.dirname)


def _env(run: ArgInterpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    (name,) = bound("env", ("name",), 0, positional, named)
    if not isinstance(name, str):
        raise TypeError(f"str expected, not {type(name).__name__}")
    return run.ask(node, run.resolver.env, name)


def _optenv(run: ArgInterpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    name, *default = bound("optenv", ("name", "default"), 1, positional, named)
    if not isinstance(name, str):
        raise TypeError(f"str expected, not {type(name).__name__}")
    fallback = default[0] if default else ""
    if isinstance(fallback, str):
        return run.ask(node, run.resolver.optenv, name, fallback)
    text = run.ask(node, run.resolver.optenv, name, _UNIQUE_DEFAULT)
    return fallback if text == _UNIQUE_DEFAULT else text  # roslaunch hands back any default, whatever its type


def _find(run: ArgInterpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    (package,) = bound("find", ("pkg",), 0, positional, named)
    if not isinstance(package, str):
        raise TypeError(f"the name of a package is a text, not of type {type(package).__name__}")
    return run.ask(node, run.resolver.find, package)


_CONTEXT = {
    "anon": Function("anon", _anon),
    "arg": Function("arg", _arg),
    "dirname": Function("dirname", _dirname),
    "env": Function("env", _env),
    "find": Function("find", _find),
    "optenv": Function("optenv", _optenv),
}

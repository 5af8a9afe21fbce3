"""The names that ``$(eval …)`` knows, looked up as roslaunch does."""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Any

from launchlint.evaluate.expression.compiled import Compiled, compiled
from launchlint.evaluate.expression.errors import ExpressionError, UnknownValue
from launchlint.evaluate.expression.functions import builtin, math_name
from launchlint.evaluate.expression.interpreter import NOT_INNER, Interpreter, Scope
from launchlint.evaluate.expression.names import BUILTINS, MATH
from launchlint.evaluate.ros1.expression.context import context_function
from launchlint.evaluate.ros1.expression.names import CONTEXT_FUNCTIONS, TRUTH
from launchlint.evaluate.ros1.expression.resolver import EnvironmentUnset, UndefinedArg
from launchlint.evaluate.ros1.values import automatic

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros1.expression.resolver import Resolver


class Passing(BaseException):
    """Carries an exception of the resolver that is not ours past every ``except Exception`` on the way."""

    def __init__(self, carried: Exception) -> None:
        super().__init__()
        self.carried = carried


def run(text: str, resolver: Resolver) -> str:
    """See :func:`launchlint.evaluate.ros1.expression.evaluate`."""
    at = text.find("__")
    if at >= 0:
        raise ExpressionError("roslaunch refuses every $(eval) that contains two underscores in a row", at, at + 2, "SubstitutionException")
    interpreter = ArgInterpreter(compiled(text), resolver)
    try:
        return interpreter.show(interpreter.evaluate(interpreter.compiled.tree.body, None), interpreter.compiled.tree.body)
    except Passing as passing:
        raise passing.carried from None
    except RecursionError:
        raise UnknownValue("the expression is nested too deeply to be looked into") from None


class ArgInterpreter(Interpreter):
    """One evaluation of an expression with args. In a lambda or comprehension Python looks straight at the builtins: args are not seen."""

    __slots__ = ("resolver",)

    def __init__(self, compiled: Compiled, resolver: Resolver) -> None:
        super().__init__(compiled)
        self.resolver = resolver

    def ask(self, node: ast.AST, question: Callable[..., Any], *values: Any) -> Any:
        """Ask the resolver; its own exceptions pass through."""
        try:
            return question(*values)
        except UnknownValue:
            raise
        except UndefinedArg as undefined:
            name = str(undefined.name)
            raise ExpressionError(
                f"there is no arg {name!r} with a value here",
                *self.span(node),
                "ArgException",
                undefined_arg=name,
            ) from None
        except EnvironmentUnset as unset:
            name = str(unset.name)
            raise ExpressionError(
                f"the environment variable {name!r} is not set", *self.span(node), "SubstitutionException", unset_env=name
            ) from None
        except Exception as foreign:
            raise Passing(foreign) from None

    def look_up(self, node: ast.Name, scope: Scope | None) -> Any:
        """The value of a name: inner names; for the top level also roslaunch's functions and args; then Python's builtins."""
        name = node.id
        if "__" in name:
            raise UnknownValue("names with two underscores are not looked into")
        if scope is None:
            if name in CONTEXT_FUNCTIONS:
                return context_function(name)
            if name in TRUTH:
                return TRUTH[name]
            if name in MATH:
                return math_name(name)
            if self.ask(node, self.resolver.has_arg, name):
                return self.admit(automatic(self.ask(node, self.resolver.arg, name)))
        found = self.inner(node, scope)
        if found is not NOT_INNER:
            return found
        if name in BUILTINS:
            return builtin(name)
        said = f"(Python says: NameError: name {name!r} is not defined)"
        if scope is None:
            words = f"there is no arg {name!r} with a value here, and $(eval) knows no other {name!r} {said}"
            raise ExpressionError(words, *self.span(node), "NameError", undefined_arg=name)
        words = f"inside a comprehension or lambda neither args nor roslaunch's own names can be used, so {name!r} is unknown {said}"
        raise ExpressionError(words, *self.span(node), "NameError")

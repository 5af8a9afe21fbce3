"""``$(eval …)`` in the exported file: the same expression, with other names for the args it reads."""

from __future__ import annotations

import ast
import keyword
from collections.abc import Callable, Iterator, Mapping

from launchlint.evaluate.expression.compiled import Compiled, compiled
from launchlint.evaluate.ros1.expression import ExpressionError, UnknownValue, arguments_read
from launchlint.evaluate.ros1.expression.names import RESERVED
from launchlint.export.written import Written

VARIABLES = ("env", "optenv")


class NotCovered(Exception):
    """The expression does something whose names cannot be exchanged safely."""


def variables_read(expression: str) -> frozenset[str]:
    """Names of the environment variables that ``expression`` asks for. Raises NotCovered where a name is computed."""
    return frozenset(_variable(call) for call in _calls(_parsed(expression), VARIABLES))


def names_read(expression: str) -> frozenset[str]:
    """Names of the args that ``expression`` reads."""
    return arguments_read(expression)


def uses(expression: str, function: str) -> bool:
    """Whether ``expression`` calls ``function``, one of those that roslaunch hands in."""
    return any(True for _ in _calls(_parsed(expression), (function,)))


def exchanged(
    expression: str, argument: Callable[[str], Written | None], fixed: Mapping[str, str | None], directory: Callable[[], str]
) -> str:
    """``expression`` with what ``argument`` says instead of each arg (None: as it is), the value of each environment variable that is
    ``fixed`` (None: not set), and ``directory()``, the name of an arg, instead of ``dirname()``. Raises NotCovered.
    """
    whole = _parsed(expression)
    edits: list[tuple[int, int, str]] = []
    bound = {node.id for node in ast.walk(whole.tree) if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load)}
    bound |= {node.arg for node in ast.walk(whole.tree) if isinstance(node, ast.arg)}
    for call in _calls(whole, ("eval",)):
        raise NotCovered(f"eval at {call.col_offset}")
    for node in ast.walk(whole.tree):
        if isinstance(node, ast.Name) and node.id not in RESERVED and node.id not in bound:
            written = argument(node.id)
            if written is not None:
                edits.append((*whole.span(node), _reading(written, bare=True)))
    for call in _calls(whole, ("arg",)):
        if len(call.args) != 1 or not isinstance(call.args[0], ast.Constant) or not isinstance(call.args[0].value, str):
            raise NotCovered("arg")
        written = argument(call.args[0].value)
        if written is not None:
            edits.append((*whole.span(call), _reading(written, bare=False)))
    for call in _calls(whole, VARIABLES):
        name = _variable(call)
        if name in fixed:
            value = fixed[name]
            default = expression[slice(*whole.span(call.args[1]))] if len(call.args) > 1 else "''"
            edits.append((*whole.span(call), default if value is None else repr(value)))
    edits += [(*whole.span(call), f"str(arg('{directory()}'))") for call in _calls(whole, ("dirname",))]
    for start, end, text in sorted(edits, reverse=True):
        expression = expression[:start] + text + expression[end:]
    return expression


def _parsed(expression: str) -> Compiled:
    try:
        return compiled(expression)
    except (ExpressionError, UnknownValue):
        raise NotCovered(expression) from None


def _calls(whole: Compiled, names: tuple[str, ...]) -> Iterator[ast.Call]:
    for node in ast.walk(whole.tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in names:
            yield node


def _variable(call: ast.Call) -> str:
    if call.args and isinstance(call.args[0], ast.Constant) and isinstance(call.args[0].value, str):
        return call.args[0].value
    raise NotCovered("env")


def _reading(written: Written, *, bare: bool) -> str:
    """How an expression reads an arg (``written`` is ``$(arg name)``) or says a value, which roslaunch makes a number where it looks
    like one.
    """
    name = written.only_arg
    if name is None:
        from launchlint.evaluate.ros1.values import automatic

        value = automatic(written.known)
        text = repr(value)
        return text if text.lstrip("-")[:1] not in ("i", "n") else f"float('{text}')"
    plain = name.isidentifier() and not keyword.iskeyword(name) and name not in RESERVED
    return name if bare and plain else f"arg({name!r})"

"""The functions an expression can call: those of ``math``, and the harmless ones of Python's builtins."""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from launchlint.evaluate.expression.bounds import (
    LARGEST_BITS,
    LARGEST_COUNTED,
    SETS,
    Function,
    Stream,
    check_power,
    size_of,
    too_large,
)
from launchlint.evaluate.expression.errors import ExpressionError, UnknownValue

if TYPE_CHECKING:
    from launchlint.evaluate.expression.interpreter import Interpreter, Scope

Call = Callable[["Interpreter", ast.AST, "Scope | None", list[Any], dict[str, Any]], Any]

_SEVERAL_TIMES = 20  # what sorting looks at each item


def math_name(name: str) -> Any:
    """A constant or function of the module ``math``."""
    value = getattr(math, name, None)
    if value is None:
        raise UnknownValue(f"{name} is not there in this version of Python")
    return value if isinstance(value, float) else Function(name, _math_call(name, value))


def builtin(name: str) -> Function:
    """A function of Python's builtins; UnknownValue for one that is not covered."""
    function = _BUILTIN.get(name)
    if function is None:
        raise UnknownValue(f"Python's {name} is not something launchlint computes")
    return function


def bound(function: str, parameters: tuple[str, ...], optional: int, positional: list[Any], named: dict[str, Any]) -> list[Any]:
    """Arguments in the order of ``parameters``, or the TypeError Python has for them."""
    if len(positional) > len(parameters):
        raise TypeError(f"{function}() takes {len(parameters)} positional arguments but {len(positional)} were given")
    values = dict(zip(parameters, positional, strict=False))
    for name, value in named.items():
        if name not in parameters or name in values:
            raise TypeError(f"{function}() got an unexpected or repeated argument {name!r}")
        values[name] = value
    missing = [name for name in parameters[: len(parameters) - optional] if name not in values]
    if missing:
        raise TypeError(f"{function}() is missing its argument {missing[0]!r}")
    return [values[name] for name in parameters if name in values]


# math


def _math_call(name: str, function: Callable[..., Any]) -> Call:
    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        values = [list(run.items(node, value)) if isinstance(value, Stream) else value for value in positional]
        run.plain(*values, *named.values())
        if name in ("factorial", "comb", "perm") and any(isinstance(value, int) and abs(value) > LARGEST_COUNTED for value in values):
            raise too_large("the number of possibilities")
        if name == "lcm" and sum(value.bit_length() for value in values if isinstance(value, int)) > LARGEST_BITS:
            raise too_large("the multiple")
        if name == "prod":
            return _folded(run, node, ast.Mult, values, dict({"start": 1}, **named), "prod")
        return function(*values, **named)

    return call


def _folded(run: Interpreter, node: ast.AST, operation: type, values: list[Any], named: dict[str, Any], name: str) -> Any:
    """``sum`` and ``math.prod``: one operation after the other, each within the bounds."""
    keywords = dict(named)
    result = keywords.pop("start")
    if len(values) != 1 or keywords:
        raise TypeError(f"{name}() takes one list and a start")
    for item in run.items(node, values[0], any_order=_whole_numbers(values[0])):
        result = run.operate(node, operation, result, item)
    return result


def _whole_numbers(value: Any) -> bool:
    return isinstance(value, SETS) and all(isinstance(item, int) for item in value)


# Python's builtins


def _materialised(run: Interpreter, node: ast.AST, values: list[Any], any_order: bool = False) -> list[Any]:
    """``values`` with each stream gone through, and sets turned into lists where their order does not matter."""
    return [list(run.items(node, value, any_order)) if isinstance(value, (Stream, *SETS)) else value for value in values]


def _simple(function: Callable[..., Any], times: int = 1) -> Call:
    """A function of plain values whose result is no larger than they are."""

    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        for value in (*positional, *named.values()):
            run.charge(times * size_of(value))
        return function(*positional, **named)

    return call


def _number(kind: Callable[..., Any]) -> Call:
    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        for value in (*positional, *named.values()):
            run.plain(value)
            if isinstance(value, str) and len(value) > LARGEST_BITS // 4:
                raise too_large("the number")
        return kind(*positional, **named)

    return call


def _text(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    if len(positional) + len(named) > 1 or named.keys() - {"object"}:
        raise UnknownValue("text made from bytes is not looked into")
    values = [*positional, *named.values()]
    return run.show(values[0], node) if values else ""


def _written(function: Callable[[Any], str]) -> Call:
    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        for value in positional:
            run.showable(value)
        return function(*positional, **named)

    return call


def _format(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    if named or not 1 <= len(positional) <= 2:
        raise TypeError("format() takes a value and a format specification")
    return run.format(node, positional[0], positional[1] if len(positional) == 2 else "")


def _collection(kind: Callable[..., Any]) -> Call:
    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        if kind is not dict or not (positional and isinstance(positional[0], dict)):
            unordered = kind in SETS
            positional = [list(run.items(node, value, unordered)) for value in positional[:1]] + positional[1:]
        if kind is dict:
            positional = [_pairs(run, node, value) for value in positional]
        return kind(*positional, **named)

    return call


def _pairs(run: Interpreter, node: ast.AST, value: Any) -> Any:
    """What ``dict`` is made from, each pair gone through beforehand."""
    if not isinstance(value, list):
        return value
    return [list(run.items(node, pair)) if isinstance(pair, (Stream, *SETS)) else pair for pair in value]


def _ordering(function: Callable[..., Any]) -> Call:
    """``sorted``, ``min``, ``max``."""

    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        keywords = dict(named)
        key = keywords.get("key")
        values = _materialised(run, node, positional, any_order=key is None) if len(positional) == 1 else positional
        for value in values:
            run.charge(_SEVERAL_TIMES * size_of(value))
        if key is not None:
            keywords["key"] = run.call(node, scope, key)
        run.plain(*(value for name, value in keywords.items() if name != "key"))
        return function(*values, **keywords)

    return call


def _sum(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    keywords = dict(named)
    if len(positional) == 2 and "start" not in keywords:
        keywords["start"] = positional[1]
        positional = positional[:1]
    keywords.setdefault("start", 0)
    if isinstance(keywords["start"], str):
        raise TypeError("sum() can't sum strings [use ''.join(seq) instead]")
    return _folded(run, node, ast.Add, positional, keywords, "sum")


def _some(function: Callable[[Iterable[Any]], bool]) -> Call:
    """``any`` and ``all``, which stop as soon as they know."""

    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        if named or len(positional) != 1:
            raise TypeError("exactly one list is needed")
        return function(run.truth(item) for item in run.items(node, positional[0], any_order=True))

    return call


def _streaming(function: Callable[..., Iterable[Any]]) -> Call:
    """``zip`` and ``enumerate``."""

    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        counted = len(positional) if function is zip else 1
        sources = [run.items(node, value) for value in positional[:counted]]
        run.plain(*positional[counted:], *named.values())
        return Stream(run.counted(function(*sources, *positional[counted:], **named)))

    return call


def _mapping(function: Callable[..., Iterable[Any]]) -> Call:
    """``map`` and ``filter``."""

    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        if len(positional) < 2 or named:
            raise TypeError("a function and a list are needed")
        first = None if positional[0] is None else run.call(node, scope, positional[0])
        return Stream(run.counted(function(first, *(run.items(node, value) for value in positional[1:]))))

    return call


def _reversed(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    run.plain(*positional)
    return Stream(run.counted(reversed(*positional, **named)))


def _power(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    base, exponent, *modulus = bound("pow", ("base", "exp", "mod"), 1, positional, named)
    run.plain(base, exponent, *modulus)
    if modulus and modulus[0] is not None:
        if any(isinstance(value, int) and value.bit_length() > LARGEST_COUNTED for value in (base, exponent, modulus[0])):
            raise too_large("the power")
    else:
        check_power(base, exponent)
    return pow(base, exponent, *modulus)


def _round(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    run.plain(*positional, *named.values())
    for digits in (*positional[1:], *named.values()):
        if isinstance(digits, int) and abs(digits) > LARGEST_COUNTED:  # to the billionth digit is a number of a billion digits on the way
            raise too_large("the rounded number")
    return round(*positional, **named)


def _isinstance(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    if len(positional) != 2 or named:
        raise TypeError("isinstance expected 2 arguments")
    value, wanted = positional
    run.plain(value)
    kinds = [kind.type_ if isinstance(kind, Function) else None for kind in (wanted if isinstance(wanted, tuple) else (wanted,))]
    if None in kinds:
        raise UnknownValue("this use of isinstance is not looked into")
    return isinstance(value, tuple(kind for kind in kinds if kind is not None))


def _eval(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
    """An ``eval`` inside the expression sees the same names, if it stands at the top level."""
    from launchlint.evaluate.expression.compiled import compiled

    if named or not positional:
        raise TypeError("eval() needs one text")
    if len(positional) > 1 or scope is not None:
        raise UnknownValue("an eval with names of its own is not looked into")
    text = positional[0]
    run.plain(text)
    if not isinstance(text, str):
        raise TypeError("eval() arg 1 must be a string, bytes or code object")
    run.steps -= 100 + len(text) // 10  # parsing is work too
    outer_text, outer_span = run.compiled, run.outer
    span = run.span(node)
    try:
        run.compiled, run.outer = compiled(text), span
        return run.evaluate(run.compiled.tree.body, None)
    except ExpressionError as error:
        raise ExpressionError(error.message, *span, error.kind, error.undefined_arg, error.unset_env) from None
    finally:
        run.compiled, run.outer = outer_text, outer_span


_BUILTIN = {
    "abs": Function("abs", _simple(abs)),
    "all": Function("all", _some(all)),
    "any": Function("any", _some(any)),
    "ascii": Function("ascii", _written(ascii)),
    "bin": Function("bin", _simple(bin)),
    "bool": Function("bool", _simple(bool), bool),
    "chr": Function("chr", _simple(chr)),
    "dict": Function("dict", _collection(dict), dict),
    "divmod": Function("divmod", _simple(divmod)),
    "enumerate": Function("enumerate", _streaming(enumerate)),
    "eval": Function("eval", _eval),
    "filter": Function("filter", _mapping(filter)),
    "float": Function("float", _number(float), float),
    "format": Function("format", _format),
    "frozenset": Function("frozenset", _collection(frozenset), frozenset),
    "hex": Function("hex", _simple(hex)),
    "int": Function("int", _number(int), int),
    "isinstance": Function("isinstance", _isinstance),
    "len": Function("len", _simple(len)),
    "list": Function("list", _collection(list), list),
    "map": Function("map", _mapping(map)),
    "max": Function("max", _ordering(max)),
    "min": Function("min", _ordering(min)),
    "oct": Function("oct", _simple(oct)),
    "ord": Function("ord", _simple(ord)),
    "pow": Function("pow", _power),
    "range": Function("range", _simple(range), range),
    "repr": Function("repr", _written(repr)),
    "reversed": Function("reversed", _reversed),
    "round": Function("round", _round),
    "set": Function("set", _collection(set), set),
    "sorted": Function("sorted", _ordering(sorted)),
    "str": Function("str", _text, str),
    "sum": Function("sum", _sum),
    "tuple": Function("tuple", _collection(tuple), tuple),
    "zip": Function("zip", _streaming(zip)),
}

"""Attributes and methods of plain values: those that only compute, each with a look at how large its result would be."""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from launchlint.evaluate.expression.bounds import SETS, Function, Stream, check_order, format_size, size_of, too_large
from launchlint.evaluate.expression.errors import UnknownValue

if TYPE_CHECKING:
    from launchlint.evaluate.expression.interpreter import Interpreter, Scope

_METHODS: dict[type, frozenset[str]] = {
    str: frozenset(
        """capitalize casefold center count endswith expandtabs find format index isalnum isalpha isascii isdecimal isdigit isidentifier
    islower isnumeric isprintable isspace istitle isupper join ljust lower lstrip partition removeprefix removesuffix replace
    rfind rindex rjust rpartition rsplit rstrip split splitlines startswith strip swapcase title upper zfill""".split()
    ),
    list: frozenset({"copy", "count", "index"}),
    tuple: frozenset({"count", "index"}),
    dict: frozenset({"copy", "get", "items", "keys", "values"}),
    set: frozenset({"copy", "difference", "intersection", "isdisjoint", "issubset", "issuperset", "symmetric_difference", "union"}),
    int: frozenset({"bit_length", "conjugate"}),
    float: frozenset({"as_integer_ratio", "conjugate", "hex", "is_integer"}),
    range: frozenset({"count", "index"}),
}
_METHODS[frozenset] = _METHODS[set]
_METHODS[bool] = _METHODS[int]

_ATTRIBUTES: dict[type, frozenset[str]] = {
    int: frozenset({"denominator", "imag", "numerator", "real"}),
    float: frozenset({"imag", "real"}),
    range: frozenset({"start", "step", "stop"}),
}
_ATTRIBUTES[bool] = _ATTRIBUTES[int]

_GROWTH = 4  # upper case can make three characters of one


def attribute(run: Interpreter, node: ast.Attribute, value: Any) -> Any:
    """``value.name``: a method that can be called, or a number; AttributeError where Python has none, UnknownValue where we do not look."""
    name, kind = node.attr, type(value)
    if isinstance(value, (Function, Stream)) or "__" in name:
        raise UnknownValue("attributes of functions and of generators are not looked into")
    if name in _METHODS.get(kind, ()):
        return Function(name, _method(value, name))
    if name in _ATTRIBUTES.get(kind, ()):
        return run.admit(getattr(value, name))
    if hasattr(kind, name):
        raise UnknownValue(f"{kind.__name__}.{name} is not something launchlint computes")
    raise run.failure(node, AttributeError(f"{kind.__name__!r} object has no attribute {name!r}"))


def _method(value: Any, name: str) -> Callable[..., Any]:
    def call(run: Interpreter, node: ast.AST, scope: Scope | None, positional: list[Any], named: dict[str, Any]) -> Any:
        if positional and name in (
            "join",
            "difference",
            "intersection",
            "issubset",
            "issuperset",
            "isdisjoint",
            "symmetric_difference",
            "union",
        ):
            positional = [list(run.items(node, item, name != "join")) if isinstance(item, (Stream, *SETS)) else item for item in positional]
        run.plain(value, *positional, *named.values())
        if isinstance(value, str):
            _check_text(run, value, name, positional, named)
        return getattr(value, name)(*positional, **named)

    return call


def _check_text(run: Interpreter, text: str, name: str, positional: list[Any], named: dict[str, Any]) -> None:
    """Count what a method of a text would produce."""
    run.charge(_GROWTH * len(text))
    if name in ("center", "ljust", "rjust", "zfill"):
        if positional and isinstance(positional[0], int):
            run.charge(max(0, positional[0]))
    elif name == "expandtabs":
        width = positional[0] if positional else named.get("tabsize", 8)
        if isinstance(width, int) and width > 0:
            run.charge(text.count("\t") * width)
    elif name == "replace":
        if len(positional) >= 2 and isinstance(positional[0], str) and isinstance(positional[1], str):
            run.charge(max(0, text.count(positional[0]) * (len(positional[1]) - len(positional[0]))))
    elif name == "join":
        for pieces in positional:
            run.charge(size_of(pieces) * (1 + len(text)))
    elif name == "format":
        for value in (*positional, *named.values()):
            check_order(value)
        run.charge(format_size(text, [*positional, *named.values()]))
    elif name in ("split", "rsplit", "splitlines", "count", "find", "index", "rfind", "rindex", "partition", "rpartition"):
        longest = max((len(value) for value in positional if isinstance(value, str)), default=0)
        if longest > 100 and longest * len(text) > 10_000_000:
            raise too_large("the search")

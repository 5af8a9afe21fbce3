"""Python's own functions where all that they are given is known, as Python has them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from launchlint.python import operations
from launchlint.python.containers import distinct, entries_of
from launchlint.python.failures import failure, is_failure_class, of_python
from launchlint.python.plain import SIMPLE, NotPlain, plain, value_of
from launchlint.python.values import (
    ITEMS,
    MISSING,
    MOST_EXACT,
    UNKNOWN,
    UNORDERED,
    Bound,
    Class,
    External,
    Failure,
    Function,
    Handle,
    Instance,
    Map,
    Seq,
    Text,
    Value,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.python.expressions import Expressions


def call(run: Expressions, name: str, given: Sequence[Value], keywords: dict[str, Value]) -> Value:
    """The value of a call of a built-in function; MISSING where it is not known exactly. Raises Raised."""
    if is_failure_class(External(f"builtins.{name}")):
        return Failure(External(f"builtins.{name}"), tuple(given))
    made = _MADE.get(name)
    try:
        if made is not None:
            return made(run, list(given), keywords)
        pure = _PURE.get(name)
        return MISSING if pure is None else _worked_out(pure, given, keywords)
    except NotPlain:
        return MISSING


def _worked_out(function: Callable[..., Any], given: Sequence[Value], keywords: Mapping[str, Value]) -> Value:
    """What Python makes of values that are known."""
    try:
        return value_of(function(*map(plain, given), **{name: plain(each) for name, each in keywords.items()}))
    except (ArithmeticError, TypeError, ValueError, LookupError) as error:
        raise of_python(error) from None


def _text(value: Any = "") -> str:
    if operations.has_set(value):
        raise NotPlain
    return str(value)


def _shown(value: Any) -> str:
    if operations.has_set(value):
        raise NotPlain
    return repr(value)


def _power(base: Any, exponent: Any, *modulus: Any) -> Any:
    if modulus or (isinstance(base, int) and isinstance(exponent, int) and base.bit_length() * abs(exponent) > operations.LONGEST_INTEGER):
        raise NotPlain
    made = pow(base, exponent)
    if isinstance(made, complex):
        raise NotPlain
    return made


def _range(*bounds: Any) -> Any:
    steps = range(*bounds)
    if len(steps) > MOST_EXACT:
        raise NotPlain
    return steps


_PURE: Mapping[str, Callable[..., Any]] = {
    "abs": abs,
    "ascii": ascii,
    "bin": bin,
    "bool": bool,
    "chr": chr,
    "divmod": divmod,
    "float": float,
    "hex": hex,
    "int": int,
    "oct": oct,
    "ord": ord,
    "pow": _power,
    "repr": _shown,
    "round": round,
    "unichr": chr,
    "unicode": _text,
    "long": int,
}


def _str(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    if len(given) == 1 and isinstance(given[0], Failure):
        arguments = given[0].arguments
        if len(arguments) == 1:
            return run.as_text(arguments[0]) if given[0].type != External("builtins.KeyError") else _worked_out(_shown, arguments, {})
        return _worked_out(_text, [Seq(list(arguments), is_tuple=True)], {}) if arguments else ""
    return _worked_out(_text, given, keywords) if len(given) <= 1 and not keywords else MISSING


def text_of(run: Expressions, value: Value) -> Value:
    """``str(value)``; MISSING where it is not known exactly."""
    try:
        return _str(run, [value], {})
    except NotPlain:
        return MISSING


def _format(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    spec = given[1] if len(given) == 2 else ""
    return operations.shown(given[0], spec, "") if given and isinstance(spec, str) else MISSING


def _iterable(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> list[Value]:
    """The items of the only argument, in their order. Raises NotPlain."""
    if len(given) > 1 or keywords:
        raise NotPlain
    items, complete = run.rounds(given[0]) if given else ([], True)
    if not complete:
        raise NotPlain
    return list(items)


def _sequence(kind: str) -> Callable[[Expressions, list[Value], dict[str, Value]], Value]:
    def make(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
        if kind in ("set", "frozenset"):
            if len(given) > 1 or keywords:
                return MISSING
            items = distinct(run.all_items(given[0]) if given else [])
            return MISSING if items is None else Seq(items, kind=kind)
        if len(given) > 1 or keywords:
            return MISSING
        if kind == "list" and given and isinstance(given[0], Seq) and given[0].kind in UNORDERED:
            found = list(run.all_items(given[0]))
            return Seq(found, kind="listing" if len(found) > 1 else kind)
        items, complete = run.rounds(given[0]) if given else ([], True)
        return Seq([each for each in items if complete or each is not UNKNOWN], complete, kind=kind)

    return make


def _reversed(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    return Seq(_iterable(run, given, keywords)[::-1], kind="iterator")


def _sorted(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    if len(given) != 1:
        return MISSING
    items = run.sorted(run.all_items(given[0]), keywords)
    return MISSING if items is None else Seq(items)


def _extreme(name: str) -> Callable[[Expressions, list[Value], dict[str, Value]], Value]:
    def find(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
        keywords = dict(keywords)
        default = keywords.pop("default", MISSING)
        items = run.all_items(given[0]) if len(given) == 1 else given
        if not items:
            if default is not MISSING:
                return default
            raise failure("ValueError", f"{name}() arg is an empty sequence")
        if keywords.keys() - {"key"}:
            return MISSING
        keys = run.keys_for(items, keywords.get("key"))
        try:
            return items[keys.index((min if name == "min" else max)(keys))]
        except TypeError as error:
            raise of_python(error) from None

    return find


def _sum(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    start = given[1] if len(given) == 2 else keywords.get("start", 0)
    total = start
    if not given or isinstance(start, str):
        return MISSING
    import ast

    for each in run.all_items(given[0]):
        run.spend(len(total.items) if isinstance(total, Seq) else 0)
        total = operations.binary(total, ast.Add, each)
        if total is MISSING:
            return MISSING
    return total


def _any_or_all(wanted: bool) -> Callable[[Expressions, list[Value], dict[str, Value]], Value]:
    def find(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
        if len(given) != 1:
            return MISSING
        answers = [run.truth(each) for each in run.all_items(given[0])]
        return wanted if wanted in answers else (MISSING if None in answers else not wanted)

    return find


def _length(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    value = given[0] if len(given) == 1 else MISSING
    if isinstance(value, str):
        return len(value)
    if isinstance(value, Seq) and value.is_sure and value.kind != "iterator":
        return len(value.items)
    if isinstance(value, Map) and value.is_sure:
        return len(value.entries)
    if isinstance(value, (*SIMPLE, Failure, Function)):
        raise failure("TypeError", f"object of type {type(value).__name__!r} has no len()")
    return MISSING


def _dict(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    entries = entries_of(run, given[0]) if given else {}
    return MISSING if entries is None or len(given) > 1 else Map({**entries, **keywords})


def _steps(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    if keywords:
        return MISSING
    try:
        return Seq(list(_range(*map(plain, given))), kind="range")
    except (TypeError, ValueError) as error:
        raise of_python(error) from None


def _enumerate(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    start = given[1] if len(given) > 1 else keywords.get("start", 0)
    value = given[0] if given else MISSING
    if not isinstance(start, int) or (isinstance(value, Seq) and not value.is_sure):
        return MISSING
    items = _iterable(run, given[:1], {})
    return Seq([Seq([start + at, each], is_tuple=True) for at, each in enumerate(items)], kind="iterator")


def _zip(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    if any(isinstance(each, Seq) and not each.is_sure for each in given) or keywords.keys() - {"strict"}:
        return MISSING
    lists = [_iterable(run, [each], {}) for each in given]
    if keywords.get("strict", False) is not False and len({len(each) for each in lists}) > 1:
        return MISSING
    return Seq([Seq(list(each), is_tuple=True) for each in zip(*lists, strict=False)], kind="iterator")


def _iter(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    if len(given) == 1 and isinstance(given[0], Seq) and given[0].kind == "iterator":
        return given[0]
    return Seq(_iterable(run, given, keywords), kind="iterator")


def _next(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    value = given[0] if given else MISSING
    if not isinstance(value, Seq) or value.kind != "iterator" or len(given) > 2:
        return MISSING
    run.force(value)
    if not value.is_sure:
        return MISSING
    if value.items:
        first = value.items[0]
        run.spend(len(value.items))
        run.store(value.content, ITEMS, value.items[1:])
        return first
    if len(given) == 2:
        return given[1]
    raise failure("StopIteration")


_TYPES: Mapping[str, type | tuple[type, ...]] = {
    "str": str,
    "int": int,
    "float": float,
    "bool": bool,
    "basestring": str,
    "unicode": str,
    "long": int,
    "complex": complex,
    "bytes": bytes,
}
_KINDS: Mapping[str, str] = {"list": "list", "tuple": "tuple", "set": "set", "frozenset": "frozenset", "range": "range"}


def _is_instance(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    if len(given) != 2:
        return MISSING
    answer = instance_of(given[0], given[1])
    return MISSING if answer is None else answer


_ABSTRACT = frozenset(
    f"{module}.{name}"
    for module in ("typing", "collections.abc")
    for name in ("Mapping", "MutableMapping", "Dict", "Collection", "Container", "Iterable", "Sized")
)
"""Classes that every dict is one of."""


def instance_of(value: Value, type_: Value) -> bool | None:
    """``isinstance(value, type_)``; None where that is not known."""
    if isinstance(type_, Seq):
        answers = [instance_of(value, each) for each in type_.items]
        return True if True in answers else (None if None in answers or not type_.complete else False)
    if type_ == External("builtins.object"):
        return True
    if isinstance(type_, Class):
        if isinstance(value, Instance):
            return any(type_ is each for each in value.type.order)
        return False if isinstance(value, (*SIMPLE, Seq, Map, Text, Function)) else None
    if not isinstance(type_, External):
        return None
    word = type_.name.removeprefix("builtins.")
    builtin = type_.name.startswith("builtins.")
    if isinstance(value, Failure):
        from launchlint.python.failures import taken_by

        return taken_by(value, type_)
    if isinstance(value, Text):
        value = ""
    if isinstance(value, SIMPLE):
        if word in ("NoneType", "types.NoneType"):
            return value is None
        return isinstance(value, _TYPES[word]) if word in _TYPES and builtin else (False if builtin or _is_of_library(word) else None)
    if isinstance(value, Seq):
        return (
            value.kind.replace("listing", "list") == word if word in _KINDS else (False if builtin or word.startswith("launch") else None)
        )
    if isinstance(value, Map):
        if not builtin:
            return True if word in _ABSTRACT else None
        return word == "dict"
    if isinstance(value, (Instance, Handle, Function)) and word in (*_KINDS, *_TYPES, "dict") and builtin:
        return False if not isinstance(value, Instance) or all(isinstance(each, Class) for each in value.type.order) else None
    return None


def _is_of_library(name: str) -> bool:
    return name.startswith(("launch.", "launch_ros.", "pathlib."))


def _type(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    value = given[0] if len(given) == 1 else MISSING
    if isinstance(value, Instance):
        return value.type
    if isinstance(value, Failure):
        return value.type
    if value is None:
        return External("types.NoneType")
    if isinstance(value, SIMPLE):
        return External(f"builtins.{type(value).__name__}")
    if isinstance(value, Text):
        return External("builtins.str")
    if isinstance(value, Seq) and value.kind in _KINDS:
        return External(f"builtins.{value.kind}")
    return External("builtins.dict") if isinstance(value, Map) else MISSING


def _callable(run: Expressions, given: list[Value], keywords: dict[str, Value]) -> Value:
    value = given[0] if len(given) == 1 else MISSING
    if isinstance(value, (Function, Bound, Class)):
        return True
    return False if isinstance(value, (*SIMPLE, Seq, Map, Text)) else MISSING


_MADE: Mapping[str, Callable[[Any, list[Value], dict[str, Value]], Value]] = {
    "all": _any_or_all(False),
    "any": _any_or_all(True),
    "callable": _callable,
    "dict": _dict,
    "enumerate": _enumerate,
    "format": _format,
    "frozenset": _sequence("frozenset"),
    "isinstance": _is_instance,
    "iter": _iter,
    "len": _length,
    "list": _sequence("list"),
    "max": _extreme("max"),
    "min": _extreme("min"),
    "next": _next,
    "range": _steps,
    "reversed": _reversed,
    "set": _sequence("set"),
    "sorted": _sorted,
    "str": _str,
    "sum": _sum,
    "tuple": _sequence("tuple"),
    "type": _type,
    "xrange": _steps,
    "zip": _zip,
}

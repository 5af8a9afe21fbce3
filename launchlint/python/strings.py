"""Methods of strings that are known, with what they make kept to a size."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from string import Formatter
from typing import Any

from launchlint.python import operations
from launchlint.python.failures import of_python
from launchlint.python.plain import LARGEST_TEXT, NotPlain, plain, value_of
from launchlint.python.values import MISSING, Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.python.expressions import Expressions

WIDEST = 10_000
_PURE = frozenset(
    """capitalize casefold count endswith find index isalnum isalpha isascii isdecimal isdigit isidentifier islower isnumeric isprintable
    isspace istitle isupper lower lstrip maketrans partition removeprefix removesuffix rfind rindex rpartition rsplit rstrip split
    splitlines startswith strip swapcase title translate upper""".split()
)
_FIELD = re.compile(r"(\w*)((?:\[[^\[\]]*\])*)")
_DEEPEST = 2


def method(run: Expressions, receiver: str, name: str, positional: Sequence[Value], keywords: Mapping[str, Value]) -> Value:
    """The value of a call; MISSING where it is not known exactly. Raises Raised."""
    run.spend(len(receiver) // 16)
    try:
        if name == "format":
            return _format(receiver, positional, keywords)
        if name == "format_map":
            return _format(receiver, (), plain(positional[0])) if len(positional) == 1 else MISSING
        if name == "join":
            items = run.all_items(positional[0], ordered=True) if len(positional) == 1 else [None]
            run.spend(len(items))
            return _made(receiver.join, [[plain(each) for each in items]], {}, _is_small(receiver, items))
        given = [plain(each) for each in positional]
        named = {key: plain(value) for key, value in keywords.items()}
        bounded = name in _PURE or _is_bounded(receiver, name, given)
        return _made(getattr(receiver, name), given, named, bounded)
    except (NotPlain, AttributeError):
        return MISSING


def _made(function: Callable[..., Any], given: list[Any], named: dict[str, Any], bounded: bool) -> Value:
    if not bounded:
        return MISSING
    try:
        return value_of(function(*given, **named))
    except (TypeError, ValueError, LookupError) as error:
        raise of_python(error) from None


def _is_small(receiver: str, items: Sequence[Value]) -> bool:
    return sum(len(each) if isinstance(each, str) else 0 for each in items) + len(receiver) * len(items) <= LARGEST_TEXT


def _is_bounded(receiver: str, name: str, given: list[Any]) -> bool:
    """Whether a method that may make a large string makes a small one."""
    if name in ("center", "ljust", "rjust", "zfill", "expandtabs"):
        return all(not isinstance(each, int) or each <= WIDEST for each in given[:1]) and len(receiver) <= WIDEST
    if name == "replace" and len(given) >= 2 and isinstance(given[0], str) and isinstance(given[1], str):
        return len(receiver) + receiver.count(given[0]) * len(given[1]) <= LARGEST_TEXT
    return False


def _format(pattern: str, positional: Sequence[Value], keywords: Mapping[str, Value], depth: int = 0) -> Value:
    """``pattern.format(*positional, **keywords)``. Raises NotPlain, Raised."""
    parts: list[str] = []
    automatic = 0
    try:
        fields = list(Formatter().parse(pattern))
    except ValueError as error:
        raise of_python(error) from None
    for literal, field, spec, conversion in fields:
        parts.append(literal)
        if field is None:
            continue
        match = _FIELD.fullmatch(field)
        if match is None or depth > _DEEPEST:
            raise NotPlain
        name = match[1]
        if not name:
            name, automatic = str(automatic), automatic + 1
        elif name.isdecimal() and automatic:
            raise NotPlain
        value = _item(positional, keywords, name)
        for key in re.findall(r"\[([^\[\]]*)\]", match[2]):
            content = plain(value)
            try:
                value = value_of(content[int(key) if key.isdecimal() else key])
            except (LookupError, TypeError) as error:
                raise of_python(error) from None
        inner = spec or ""
        if "{" in inner:
            if "{}" in inner:
                raise NotPlain
            made = _format(inner, positional, keywords, depth + 1)
            inner = made if isinstance(made, str) else ""
        shown = operations.shown(value, inner, conversion or "")
        if not isinstance(shown, str):
            raise NotPlain
        parts.append(shown)
    return value_of("".join(parts))


def _item(positional: Sequence[Value], keywords: Mapping[str, Value], name: str) -> Value:
    try:
        return positional[int(name)] if name.isdecimal() else keywords[name]
    except LookupError:
        if name.isdecimal():
            error = IndexError("Replacement index " + name + " out of range for positional args tuple")
        raise of_python(error) from None

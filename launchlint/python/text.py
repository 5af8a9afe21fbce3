"""Strings that are partly known."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from launchlint.python.values import (
    LONGEST_TEXT,
    MISSING,
    MOST_ALTERNATIVES,
    SIGNS,
    UNKNOWN,
    Choice,
    Outside,
    Text,
    Value,
    alternatives,
    choice,
    conjunction,
)

ANY = "{any}"
ANY_TEXT = Text(ANY)
"""A string of which nothing is known."""
ANYS = re.compile(r"(?:\{any\}){2,}")
_FORMAT = re.compile(r"%(?:\((?P<key>[^()]*)\))?[#0\- +]*(?P<width>[1-9]\d*|\*)?(?:\.\d+)?[hlL]?(?P<kind>[diouxXeEfFgGcrsa%])")


def escaped(text: str) -> str:
    """A plain string as a template."""
    return text.replace("{", "{{").replace("}", "}}") if "{" in text or "}" in text else text


def template(value: Value) -> str:
    """The template of what ``str()`` makes of a value (not of a choice)."""
    if isinstance(value, str):
        return escaped(value)
    if isinstance(value, Text):
        return value.template
    if isinstance(value, bool) or value is None:
        return str(value)
    if isinstance(value, (int, float)):
        return _number(value)
    if isinstance(value, Outside):
        return value.template()
    return ANY


def _number(value: float) -> str:
    try:
        return str(value)
    except ValueError:  # too many digits to be written
        return ANY


def text(template_: str) -> Value:
    """A value for a template: a plain string where nothing in it is open."""
    if len(template_) > LONGEST_TEXT:
        return UNKNOWN
    template_ = ANYS.sub(ANY, template_)
    if template_ == ANY:
        return UNKNOWN
    if SIGNS[0] in template_ or SIGNS[1] in template_ or "{" in template_.replace("{{", ""):
        return Text(template_)
    return template_.replace("{{", "{").replace("}}", "}")


def distribute(make: Callable[..., Value], *values: Value) -> Value:
    """``make`` of every combination of what ``values`` can be."""
    if not any(isinstance(each, Choice) for each in values):
        return make(*values)
    combined: list[tuple[tuple[str, ...], tuple[Value, ...]]] = [((), ())]
    for value in values:
        combined = [((*known, condition), (*taken, each)) for known, taken in combined for condition, each in alternatives(value)]
        if len(combined) > MOST_ALTERNATIVES:
            return UNKNOWN
    return choice([(conjunction(conditions), make(*taken)) for conditions, taken in combined])


def joined(parts: Sequence[Value]) -> Value:
    """Strings one behind the other."""
    return distribute(lambda *each: text("".join(template(part) for part in each)), *parts)


def percent(pattern: str, values: Sequence[Value], mapping: dict[str, Value] | None) -> Value:
    """``pattern % values``; ``mapping`` where the pattern takes keys."""
    parts: list[Value] = []
    at, used = 0, 0
    for match in _FORMAT.finditer(pattern):
        parts.append(pattern[at : match.start()])
        at = match.end()
        if match["kind"] == "%":
            parts.append("%")
        elif match["width"] == "*":
            return UNKNOWN
        elif match["key"] is not None:
            parts.append(_formatted((mapping or {}).get(match["key"], UNKNOWN), match[0].replace(f"({match['key']})", ""), percent=True))
        else:
            parts.append(_formatted(values[used] if used < len(values) else UNKNOWN, match[0], percent=True))
            used += 1
    parts.append(pattern[at:])
    return joined(parts)


def _formatted(value: Value, how: str, *, percent: bool) -> Value:
    """One value in a format of its own."""
    if how in ("%s", ""):
        return value if isinstance(value, (Choice, Outside, Text, str)) else text(template(value))
    if isinstance(value, (int, float, str)) and len(how) <= 8 and not re.search(r"\d{4}", how):
        try:
            return how % value if percent else format(value, how)
        except (TypeError, ValueError, OverflowError):
            return UNKNOWN
    return value if how in ("%d", "%i", "d", "s") and isinstance(value, (Outside, Text)) else UNKNOWN


def braces(pattern: str, positional: Sequence[Value], keywords: dict[str, Value]) -> Value:
    """``pattern.format(*positional, **keywords)``."""
    from string import Formatter

    parts: list[Value] = []
    automatic = 0
    try:
        for literal, field, spec, conversion in Formatter().parse(pattern):
            parts.append(literal)
            if field is None:
                continue
            value: Value = UNKNOWN
            if field == "":
                value = positional[automatic] if automatic < len(positional) else UNKNOWN
                automatic += 1
            elif field.isdecimal() and len(field) < 4:
                value = positional[int(field)] if int(field) < len(positional) else UNKNOWN
            else:
                value = keywords.get(field, UNKNOWN)
            parts.append(UNKNOWN if conversion == "r" else _formatted(value, spec or "", percent=False))
    except ValueError:
        return UNKNOWN
    return joined(parts)


def interpolated(value: Value, spec: str, conversion: int) -> Value:
    """A value in an f-string."""
    return UNKNOWN if conversion == ord("r") else _formatted(value, spec, percent=False)


def path_joined(parts: Sequence[Value]) -> Value:
    """``os.path.join``."""

    def join(*pieces: Value) -> Value:
        result = ""
        for piece in pieces:
            each = template(piece)
            result = each if each.startswith(("/", *SIGNS)) or not result else result.removesuffix("/") + "/" + each
        return text(result)

    return distribute(join, *parts)


def may_be(name: str, value: Value) -> bool:
    """Whether ``value`` can be the string ``name``."""
    if isinstance(value, str):
        return name == value
    if not isinstance(value, Text):
        return True
    pattern = ".*".join(map(re.escape, re.sub(r"\{(?:[^{}]|\{[^{}]*\})*\}|[\ue000\ue001]", "\0", value.template).split("\0")))
    return re.fullmatch(pattern, name) is not None


def or_default(first: Value, second: Value) -> Value:
    """``first or second`` where ``first`` is one slot without default, which then gets one; MISSING where it is not so."""
    spelled = template(first)
    if isinstance(second, Choice) or not isinstance(second, (str, int, float)):
        return MISSING
    if isinstance(first, Outside):
        return first.otherwise(second)
    if spelled.startswith("{arg:") and spelled.endswith("}") and "|" not in spelled and spelled.count("{") == 1:
        return text(f"{spelled[:-1]}|{template(second)}}}")
    return MISSING

"""When an entry of a library exists: conditions over the instance (see ``docs/library-format.md``)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from launchlint.library.template import UNKNOWN, Thing, Undetermined

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.library.template import Situation

QUESTIONS = ("param", "arg", "option", "remap")
"""What a condition can ask about, apart from ``not``, ``all``, ``any`` and ``text``."""

_MEMBER = re.compile(r"\{([a-z]{1,20})\}")
_FALSE_WORDS = frozenset({"", "0", "false", "False", "FALSE", "no", "off"})


def holds(condition: Any, situation: Situation) -> bool | None:
    """Whether a (validated) condition is true in a situation; None where that cannot be known."""
    if "text" in condition:
        return None
    if "not" in condition:
        value = holds(condition["not"], situation)
        return None if value is None else not value
    if "all" in condition:
        return _all(holds(each, situation) for each in condition["all"])
    if "any" in condition:
        value = _all(_not(holds(each, situation)) for each in condition["any"])
        return _not(value)
    if "remap" in condition:
        return situation.is_remapped(condition["remap"])
    value = _asked(condition, situation)
    if isinstance(value, Undetermined):
        return None
    if "set" in condition:
        return bool((value is not None) == condition["set"])
    if value is None:
        value = condition.get("default")
    if "is" in condition:
        return _same(value, condition["is"])
    if "in" in condition:
        return any(_same(value, each) for each in condition["in"])
    if "param" in condition:
        return _is_true(value)
    return value is not None


def _asked(condition: Any, situation: Situation) -> Any:
    if "param" in condition:
        return situation.param(condition["param"])
    if "arg" in condition:
        return situation.argument(condition["arg"])
    return situation.option(condition["option"])


def _not(value: bool | None) -> bool | None:
    return None if value is None else not value


def _all(values: Iterator[bool | None]) -> bool | None:
    unknown = False
    for value in values:
        if value is False:
            return False
        unknown = unknown or value is None
    return None if unknown else True


def _same(value: Any, wanted: Any) -> bool:
    """Equal, also where one of them is the text of the other: args are always text."""
    if isinstance(value, bool) or isinstance(wanted, bool):
        return _is_true(value) == _is_true(wanted) if value is not None else False
    return bool(value == wanted) or (value is not None and str(value) == str(wanted))


def _is_true(value: Any) -> bool:
    return value not in _FALSE_WORDS if isinstance(value, str) else bool(value)


def pattern_of(like: str) -> re.Pattern[str] | None:
    """What ``{topic}@{type}`` asks of an argument; None where it is no such pattern.

    Each name stands for one character or more, and for none of those that stand outside the names.
    """
    words = _MEMBER.split(like)
    outside, names = words[::2], words[1::2]
    if not names or len(set(names)) < len(names) or not all(outside[1:-1]) or any(brace in text for text in outside for brace in "{}"):
        return None
    some = f"[^{re.escape(''.join(outside))}]+" if any(outside) else ".+"
    return re.compile("".join(f"(?P<{word}>{some})" if number % 2 else re.escape(word) for number, word in enumerate(words)))


def _alike(found: Sequence[Any], pattern: re.Pattern[str] | None) -> list[Thing] | Undetermined:
    """The arguments of that form; of one that is known in part the parts. One of which the form cannot be told may be any of them."""
    if pattern is None:
        return []
    result: list[Thing] = []
    for value in found:
        partly = isinstance(value, Undetermined)
        match = pattern.fullmatch(value.pattern if partly else value)
        if match is not None:
            parts = match.groupdict()
            result.append(Thing(value, {name: Undetermined(part) if partly and "*" in part else part for name, part in parts.items()}))
        elif partly:
            return UNKNOWN
    return result


def things(each: Any, situation: Situation) -> list[Thing] | Undetermined:
    """What a (validated) ``each`` goes through: :data:`UNKNOWN` where that cannot be known."""
    if "args" in each:
        found = situation.arguments_from(each["args"])
        if isinstance(found, Undetermined):
            return UNKNOWN
        if "like" not in each:
            return [Thing(value, value) for value in found]
        return _alike(found, pattern_of(each["like"]))
    value = situation.param(each["param"] if "param" in each else each["words"])
    if value is None:
        value = each.get("default", [])
    elif "words" in each and isinstance(value, str):
        value = value.split()
    if isinstance(value, dict):
        return [Thing(key, inner) for key, inner in value.items()]
    return [Thing(item, item) for item in value] if isinstance(value, list) else UNKNOWN

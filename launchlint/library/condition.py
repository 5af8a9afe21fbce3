"""When an entry of a library exists: conditions over the instance (see ``docs/library-format.md``)."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.library.template import UNKNOWN, Thing, Undetermined

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.library.template import Situation

QUESTIONS = ("param", "arg", "option", "remap")
"""What a condition can ask about, apart from ``not``, ``all``, ``any`` and ``text``."""

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


def things(each: Any, situation: Situation) -> list[Thing] | Undetermined:
    """What a (validated) ``each`` goes through: :data:`UNKNOWN` where that cannot be known."""
    if "args" in each:
        found = situation.arguments_from(each["args"])
        return UNKNOWN if isinstance(found, Undetermined) else [Thing(value, value) for value in found]
    value = situation.param(each["param"] if "param" in each else each["words"])
    if value is None:
        value = each.get("default", [])
    elif "words" in each and isinstance(value, str):
        value = value.split()
    if isinstance(value, dict):
        return [Thing(key, inner) for key, inner in value.items()]
    return [Thing(item, item) for item in value] if isinstance(value, list) else UNKNOWN

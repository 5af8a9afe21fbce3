"""Parameter values side by side, for the rules that compare settings."""

from __future__ import annotations

from itertools import islice

from launchlint.evaluate.names import UNKNOWN_NAMESPACE
from launchlint.model import Binary, Command, ParameterSetting

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

LONGEST_SHOWN = 40
DEEPEST_SHOWN = 2
_PLAIN = (str, int, float, bool, list, dict, tuple, bytes, Binary, type(None))


def is_known(value: Any) -> bool:
    """Whether the value is certain: it depends on no command, environment or missing package."""
    return isinstance(value, _PLAIN) and not isinstance(value, Command)


def is_certain(setting: ParameterSetting) -> bool:
    """Whether the setting surely happens, under a name that is meant: not one that only ROS 2 understands (LL515 tells of that)."""
    if UNKNOWN_NAMESPACE in setting.name or "/ros__parameters/" in setting.name:
        return False
    return not setting.conditions or not any(condition.assumed for condition in setting.conditions)


def is_same(first: Any, second: Any) -> bool:
    """Whether two values are the same for whoever reads the parameter: 1, 1.0, "1" and true are four different ones."""
    return type(first) is type(second) and (first == second or repr(first) == repr(second))


def shown(value: Any) -> str:
    """The value as one would write it in YAML, shortened: texts in quotes, so that 1 and "1" can be told apart."""
    text = _written(value)
    return text if len(text) <= LONGEST_SHOWN else text[: LONGEST_SHOWN - 1] + "…"


def _written(value: Any, depth: int = 0) -> str:
    if isinstance(value, Binary):
        return f"a file of {value.length} bytes"
    if isinstance(value, bytes):
        return f"{len(value)} bytes"
    if value is None or isinstance(value, bool):
        return {None: "null", True: "true", False: "false"}[value]
    if isinstance(value, str):
        return f'"{value[:LONGEST_SHOWN]}"'
    if isinstance(value, (dict, list, tuple)) and depth == DEEPEST_SHOWN:
        return "…"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {_written(item, depth + 1)}" for key, item in islice(value.items(), LONGEST_SHOWN)) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_written(item, depth + 1) for item in value[:LONGEST_SHOWN]) + "]"
    return str(value)[: LONGEST_SHOWN + 1]

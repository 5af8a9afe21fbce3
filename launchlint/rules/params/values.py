"""Parameter values side by side, for the rules that compare settings."""

from __future__ import annotations

import json
from typing import Any

from launchlint.evaluate.names import UNKNOWN_NAMESPACE
from launchlint.model import Binary, Command, ParameterSetting

LONGEST_SHOWN = 40
_PLAIN = (str, int, float, bool, list, dict, tuple, bytes, Binary, type(None))


def is_known(value: Any) -> bool:
    """Whether the value is certain: it depends on no command, environment or missing package."""
    return isinstance(value, _PLAIN) and not isinstance(value, Command)


def is_certain(setting: ParameterSetting) -> bool:
    """Whether the setting surely happens, under this very name."""
    if UNKNOWN_NAMESPACE in setting.name:
        return False
    return not any(condition.assumed for condition in setting.conditions)


def is_same(first: Any, second: Any) -> bool:
    """Whether two values are the same for whoever reads the parameter: 1, 1.0, "1" and true are four different ones."""
    return type(first) is type(second) and (first == second or repr(first) == repr(second))


def shown(value: Any) -> str:
    """The value as one would write it in YAML, shortened: texts in quotes, so that 1 and "1" can be told apart."""
    if isinstance(value, Binary):
        return f"a file of {value.length} bytes"
    try:
        text = json.dumps(value, ensure_ascii=False)
    except (TypeError, ValueError, RecursionError):
        text = str(value)
    return text if len(text) <= LONGEST_SHOWN else text[: LONGEST_SHOWN - 1] + "…"

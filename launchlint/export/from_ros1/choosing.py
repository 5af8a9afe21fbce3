"""Conditions of remaps and params inside of a node, which ROS 2 has not, as values that are chosen: ``$(if condition one other)``.

A remap that is there on one side only is, on the other, one of the name to itself, which does nothing.
"""

from __future__ import annotations

from launchlint.export.from_ros1.frame import Setting
from launchlint.export.ros2.comparing import normal
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.ros2.description import Parameter, Substitution, Text, TypedValue

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from launchlint.syntax.ros2.description import Condition

SUBSTITUTION = "if"


class _Value(NamedTuple):
    text: Text
    type: str | None


def chosen(settings: Sequence[Setting]) -> list[Setting]:
    """``settings`` with choices in place of conditions, as far as that says the same."""
    found = list(settings)
    for number, setting in enumerate(found):
        if setting.condition is None:
            continue
        same = [other for other, each in enumerate(found) if other != number and _about(each) == _about(setting) != ""]
        if setting.remap is not None and not same and setting.key:
            source, target = setting.remap
            found[number] = setting._replace(condition=None, remap=(source, _choice(setting.condition, target, source)))
        elif len(same) == 1 and _are_opposite(setting, found[same[0]]):
            made = _joined(setting, found[same[0]], setting.condition)
            if made is not None:
                found[same[0]] = made
                return chosen(found[:number] + found[number + 1 :])
    return found


def _about(setting: Setting) -> str:
    """What a setting sets; empty where that is computed, or more than one thing."""
    if setting.remap is not None:
        return f"remap {setting.key}" if setting.key else ""
    if len(setting.sources) == 1 and isinstance(setting.sources[0], Parameter) and setting.sources[0].value is not None:
        return f"param {setting.sources[0].name.literal}"
    return ""


def _are_opposite(one: Setting, other: Setting) -> bool:
    if one.condition is None or other.condition is None or one.condition.kind == other.condition.kind:
        return False
    return normal(one.condition.operands) == normal(other.condition.operands)


def _joined(one: Setting, other: Setting, condition: Condition) -> Setting | None:
    if one.remap is not None and other.remap is not None:
        return other._replace(condition=None, remap=(one.remap[0], _choice(condition, one.remap[1], other.remap[1])))
    first, second = (each.sources[0] for each in (one, other))
    if not isinstance(first, Parameter) or not isinstance(second, Parameter) or first.value is None or second.value is None:
        return None
    values = _value(first.value), _value(second.value)
    if values[0] is None or values[1] is None or values[0].type != values[1].type:
        return None
    value = TypedValue(_choice(condition, values[0].text, values[1].text), values[0].type)
    return other._replace(condition=None, sources=(second._replace(value=value),))


def _value(value: TypedValue) -> _Value | None:
    """A value as a text that is read as the same again; None for a list."""
    if not isinstance(value.value, Text) or isinstance(value.plain, tuple):
        return None
    plain = value.plain
    if isinstance(plain, str):
        return _Value(value.value._replace(pieces=(plain,) if plain else ()), "str")
    if plain is None:
        return _Value(value.value, value.type)
    kind = "bool" if isinstance(plain, bool) else "int" if isinstance(plain, int) else "float"
    return _Value(value.value._replace(pieces=(str(plain).lower() if isinstance(plain, bool) else repr(plain),)), kind)


def _choice(condition: Condition, one: Text, other: Text) -> Text:
    """``one`` where the condition holds, else ``other``."""
    first, second = (one, other) if condition.kind == "if" else (other, one)
    place = condition.place
    return Text((Substitution(SUBSTITUTION, (condition.operands[0], first, second), place),), place)

"""Conditions of actions as objects of a followed launch file."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.python.values import Handle, Value
from launchlint.source import Place
from launchlint.syntax.ros2.description import Condition, Text, unknown
from launchlint.syntax.ros2.python.texts import Texts, why

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Literal

_BY_TRUTH: Mapping[str, Literal["if", "unless"]] = {"IfCondition": "if", "UnlessCondition": "unless"}
_BY_VALUE: Mapping[str, Literal["equals", "not-equals"]] = {
    "LaunchConfigurationEquals": "equals",
    "LaunchConfigurationNotEquals": "not-equals",
}


def is_condition(value: Value) -> bool:
    """Whether a value is a condition of which it is known when it holds."""
    return isinstance(value, Handle) and (value.kind in _BY_TRUTH or value.kind in _BY_VALUE)


def condition_of(value: Value, texts: Texts, place: Place) -> Condition | None:
    """The condition that a value is, None for None; one that is not known where the value is not."""
    if value is None:
        return None
    if not isinstance(value, Handle) or not is_condition(value):
        return Condition("unknown", (unknown(why(value, "a condition of its own"), place),), place)
    place = value.state["place"]
    if value.kind in _BY_TRUTH:
        return Condition(
            _BY_TRUTH[value.kind],
            (texts.text(value.state["predicate_expression"], value.state.get("places", {}).get("predicate_expression", place)),),
            place,
        )
    name = value.state["launch_configuration_name"]
    if not isinstance(name, str):
        return Condition("unknown", (unknown("it is not known which launch configuration it compares", place),), place)
    operands: tuple[Text, ...] = (Text((name,), place),)
    expected = value.state["expected_value"]
    return Condition(_BY_VALUE[value.kind], operands if expected is None else (*operands, texts.text(expected, place)), place)


def condition(given: Mapping[Any, Value], texts: Texts) -> Condition | None:
    """The condition of an action with these arguments."""
    return condition_of(given.get("condition"), texts, given.get("places", {}).get("condition", given["place"]))

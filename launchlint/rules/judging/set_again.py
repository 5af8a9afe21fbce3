"""Parameters that are set, and afterwards set again whenever that has happened."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import ParamReplaced
from launchlint.model import Launch, ParameterSetting
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.param_values import is_certain, is_known
from launchlint.source import Origin

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class SetAgain(NamedTuple):
    """The parameter ``name`` is set to ``old`` at ``first`` and then, without another value in between, to ``new`` at ``second``.

    Both values are known, and may be the same. ``settings`` are the two; None for params of a node, and for a ``~param``, which the second
    replaces before it is set for any node.
    """

    name: str
    first: Origin
    second: Origin
    old: Any
    new: Any
    settings: tuple[ParameterSetting, ParameterSetting] | None = None


def set_again(launch: Launch) -> Iterator[SetAgain]:
    """Each parameter and each next setting of it that surely takes its place."""
    last: dict[str, ParameterSetting] = {}
    scoped = {setting.origin.place.key for setting in launch.settings if setting.kind == "param"}
    for setting in launch.parameter_settings:
        earlier = last.get(setting.name)
        last[setting.name] = setting
        if earlier is None or not (is_known(earlier.value) and is_known(setting.value)) or earlier.origin.place.key in scoped:
            continue
        if _are_equal_numbers(earlier.value, setting.value):
            continue
        if is_certain(earlier) and is_certain(setting) and set(setting.conditions) <= set(earlier.conditions):
            yield SetAgain(setting.name, earlier.origin, setting.origin, earlier.value, setting.value, (earlier, setting))
    yield from _in_one_scope(launch)
    for problem in launch.noticed(ParamReplaced):
        if problem.always and not problem.assumed and is_known(problem.old) and is_known(problem.new):
            if _are_equal_numbers(problem.old, problem.new):
                continue
            first = Origin(problem.related[0][0], problem.origin.step)
            yield SetAgain(problem.name, first, problem.origin, problem.old, problem.new)


def _are_equal_numbers(old: object, new: object) -> bool:
    """Whether 1 is set after 1.0, or the reverse: roscpp and rospy take the one for the other."""
    return {type(old), type(new)} == {int, float} and old == new


def _in_one_scope(launch: Launch) -> Iterator[SetAgain]:
    """A ``~param`` that is set again before any node has followed."""
    settings = {setting.origin.place.key: setting for setting in launch.settings if setting.kind == "param"}
    for setting in settings.values():
        earlier = settings.get(setting.replaced.key) if setting.replaced is not None else None
        if earlier is None or earlier.reached or not set(setting.conditions) <= set(earlier.conditions):
            continue
        if any(condition.assumed for condition in (*earlier.conditions, *setting.conditions)):
            continue
        if is_known(earlier.value) and is_known(setting.value):
            yield SetAgain(setting.key, earlier.origin, setting.origin, earlier.value, setting.value)

"""What a launch file of ROS 1 starts, compared with what its translation starts: what must be the same, in the words of both."""

from __future__ import annotations

import re

from launchlint.export.from_ros1.params import dotted
from launchlint.model import Command, Unknown, UnknownText
from launchlint.words import split_words

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from typing import Any

    from launchlint.model import Launch, Node, ParameterSetting
    from launchlint.source import Place

_ANONYMOUS = re.compile(r"_anon\d+|_[\w.]{1,100}_\d{1,20}_-?\d+")
PLACEHOLDER = "launchlint_placeholder"
"""The one param of files that a person has to rewrite, as long as nobody has."""
_NOT_ITS_OWN = ("use_sim_time", PLACEHOLDER)


class Dropped:
    """The elements that are said to be lost, by their places."""

    def __init__(self, places: Iterable[Place]) -> None:
        self._spans = [(each.source.path, *each.span) for each in places]

    def holds(self, place: Place) -> bool:
        """Whether ``place`` is one of them, or lies in one."""
        return any(path == place.source.path and start <= place.span.start < max(end, start + 1) for path, start, end in self._spans)


def difference(before: Launch, after: Launch, dropped: Dropped) -> str:
    """What differs first, in one plain sentence without a full stop; empty where nothing does."""
    old = [each for each in before.nodes if not any(map(dropped.holds, (each.origin.place, *each.origin.chain)))]
    new = list(after.nodes)
    for one, other in zip(old, new):  # noqa: B905 - the shorter one ends it
        found = _node(before, one, other, dropped)
        if found:
            return f"the node {one.full_name} {found}"
    if len(old) > len(new):
        return f"the node {old[len(new)].full_name} would be missing"
    return f"there would be a node {new[len(old)].full_name}" if len(new) > len(old) else ""


def _node(launch: Launch, one: Node, other: Node, dropped: Dropped) -> str:
    for role, attribute in (("package", "package"), ("executable", "executable"), ("prefix", "launch_prefix")):
        if one.knows(role) and other.knows(role) and getattr(one, attribute) != getattr(other, attribute):  # type: ignore[arg-type]  # roles
            return f"would have the {role} {getattr(other, attribute)!r}, and not {getattr(one, attribute)!r}"
    if not one.knows("name", "namespace") or not other.knows("name", "namespace"):
        return ""
    if _ANONYMOUS.sub("", one.full_name) != _ANONYMOUS.sub("", other.full_name):
        return f"would be {other.full_name}"
    for name in ("respawn", "required"):
        if getattr(one, name) != getattr(other, name):
            return f"would differ in {name}"
    if (one.output or "log") != (other.output or "log") and other.knows("output"):
        return "would differ in output"
    found = _words(one, other) or _remaps(one, other) or _environment(one, other)
    return found or _params(launch, one, other, dropped)


def _words(one: Node, other: Node) -> str:
    if not one.knows("arguments") or not other.knows("arguments") or other.process is None:
        return ""
    try:
        words = [each for each in split_words(" ".join(split_words(one.arguments))) if ":=" not in each]
        after = [each for each in split_words(" ".join(other.process.arguments)) if ":=" not in each]  # that it may be one word is said
    except ValueError:
        return ""
    same = [_ANONYMOUS.sub("", each) for each in words] == [_ANONYMOUS.sub("", each) for each in after]
    return "" if same else f"would have the arguments {after}, and not {words}"


def _remaps(one: Node, other: Node) -> str:
    if not one.knows("remaps") or not other.knows("remaps"):
        return ""
    before = {_resolved(each.source, one): _resolved(each.target, one) for each in one.remaps}
    after: dict[str, str] = {}
    for each in other.remaps:
        after.setdefault(_resolved(each.source, other), _resolved(each.target, other))
    before, after = ({key: value for key, value in each.items() if key != value} for each in (before, after))
    return "" if before == after else f"would have the remaps {after}, and not {before}"


def _resolved(name: str, node: Node) -> str:
    if name.startswith("/"):
        found = name
    elif name.startswith("~"):
        found = f"{node.full_name}/{name[1:].lstrip('/')}"
    else:
        found = f"{node.namespace}{name}"
    return _ANONYMOUS.sub("", found)


def _environment(one: Node, other: Node) -> str:
    before = {each.name: each.value for each in one.environment}
    after = {each.name: each.value for each in other.environment}
    if any(isinstance(value, (Unknown, UnknownText)) for value in (*before.values(), *after.values())):
        return ""
    return "" if before == after else f"would have the environment {after}, and not {before}"


def _params(launch: Launch, one: Node, other: Node, dropped: Dropped) -> str:
    if other.own is None:
        return ""
    inside = f"{one.full_name}/"
    mine = {name.removeprefix(inside): setting for name, setting in launch.parameters.items() if name.startswith(inside)}
    before = {dotted(name): setting.value for name, setting in mine.items() if not _left_out(setting, dropped, launch)}
    flat = dict(_flat(before))
    on_command_line = {dotted(each.partition(":=")[0][1:]) for each in one.arguments.split() if each.startswith("_") and ":=" in each}
    after = {name: value for name, (_, value) in other.own.items() if name not in {*_NOT_ITS_OWN, *on_command_line} or name in flat}
    for name, value in flat.items():
        if name not in after:
            return f"would not have the param {name}"
        if not _same(value, after[name]):
            return f"would have the param {name} as {after[name]!r}, and not {value!r}"
    more = [name for name in after if name not in flat] if len(before) == len(mine) else []
    return f"would have a param {more[0]}" if more else ""


def _flat(values: Mapping[str, Any]) -> Iterable[tuple[str, Any]]:
    for name, value in values.items():
        if isinstance(value, dict):
            yield from ((f"{name}.{inner}", each) for inner, each in _flat({str(key): item for key, item in value.items()}))
        else:
            yield name, value


def _left_out(setting: ParameterSetting, dropped: Dropped, launch: Launch) -> bool:
    """Whether it is said to be lost, or stands in a file of params, which a person has to rewrite."""
    place = setting.origin.place
    return place.source.file not in launch.files or any(map(dropped.holds, (place, *setting.origin.chain)))


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, (Unknown, UnknownText)) or isinstance(other, (Unknown, UnknownText)):
        return True
    if isinstance(one, Command):
        return True
    if isinstance(one, (list, tuple)) and isinstance(other, (list, tuple)):
        if {type(each) for each in one} == {int, float}:
            one = [float(each) for each in one]  # ROS 2 has lists of one type
        return len(one) == len(other) and all(_same(*each) for each in zip(one, other, strict=True))
    if isinstance(one, bool) is not isinstance(other, bool):
        return False
    if isinstance(one, str) and isinstance(other, str):
        return _ANONYMOUS.sub("", one) == _ANONYMOUS.sub("", other)
    return type(one) is type(other) and bool(one == other)

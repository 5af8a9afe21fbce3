"""The params that a launch file of ROS 2 gives to a node, beside those that the node declares."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Instance, Reading
from launchlint.library.program import Declared
from launchlint.model import Unknown
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.name_places import node_origin
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView
from launchlint.source import Origin
from launchlint.spelling import closest
from launchlint.workspace.ros2_distributions import AGE, DISTRIBUTIONS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.library.lookup import Library

TYPES = {
    "bool": "bool",
    "int": "integer",
    "double": "double",
    "str": "string",
    "bool[]": "bool_array",
    "int[]": "integer_array",
    "double[]": "double_array",
    "str[]": "string_array",
}
"""What rcl calls the types of values, and what rclcpp and rclpy do."""
WORDS = {
    "bool": "a bool",
    "integer": "an integer",
    "double": "a double",
    "string": "a string",
    "byte_array": "a list of bytes",
    "bool_array": "a list of bools",
    "integer_array": "a list of integers",
    "double_array": "a list of doubles",
    "string_array": "a list of strings",
}
ROUNDED = {"integer": "double", "integer_array": "double_array"}
"""Types of values that look like those of another type."""
_EVERYWHERE = ("use_sim_time", "start_type_description_service", "diagnostic_updater.period", "diagnostic_updater.use_fqn")
"""Params that rclcpp, rclpy and diagnostic_updater declare in any node."""
_OVERRIDES = "qos_overrides."
_CLIENTS = ("rclcpp", "rclpy", "component")
"""Of a container nothing is said: what it is given may be for the nodes that are loaded into it."""
_MOST_NAMES = 8


class Given(NamedTuple):
    """A value that a node is given for a param that it declares. ``type`` is that of the value, in the words of rclcpp.

    ``published``: how it is declared is known of a repository of others, of one distribution.
    """

    instance: Instance
    name: str
    type: str
    value: Any
    wanted: tuple[Declared, ...]
    origin: Origin
    published: bool = False


def given(view: GraphView) -> Iterator[Given]:
    """All values of params that the nodes of a launch declare for certain."""
    for instance in view.graph.instances:
        yield from view.fact(instance, _given)


def _given(instance: Instance, library: Library) -> tuple[Given, ...]:
    own = instance.node.own
    if not own or not instance.certain or instance.undeclared or instance.is_unknown:
        return ()
    found: list[Given] = []
    for name, readings in _declared(instance).items():
        type_, value = own.get(name, ("", None))
        wanted = tuple(each.declaration.declared for each in readings if each.declaration.declared is not None)
        sure = all(each.certain for each in readings) and all(each.declared and each.type and not each.dynamic for each in wanted)
        if type_ in TYPES and sure and not isinstance(value, Unknown):
            value = list(value) if isinstance(value, tuple) else value
            published = any("@" in fact.get("at", "") for each in readings for fact in each.declaration.evidence)
            found.append(Given(instance, name, TYPES[type_], value, wanted, place_of(instance, name), published))
    return tuple(found)


def place_of(instance: Instance, name: str) -> Origin:
    """Where a param of a node is set, as far as that is in a file; else where the node is."""
    return instance.node.own_origins.get(name) or node_origin(instance)


def _declared(instance: Instance) -> Mapping[str, list[Reading]]:
    """What a node reads, by the names of the params; what other nodes of the same process read is not among them."""
    found: dict[str, list[Reading]] = {}
    start = f"{instance.name}:"
    for each in instance.readings:
        if each.name.startswith(start):
            found.setdefault(each.name[len(start) :], []).append(each)
    return found


def is_of_old(each: Given, view: GraphView) -> bool:
    """Whether the repository is for a distribution that is older than those of which programs are known: there it may be another type."""
    return each.published and any(AGE[name] < AGE[DISTRIBUTIONS[0]] for name in view.launch.named)


def is_integer_for_double(each: Given) -> bool:
    """Whether only the point is missing."""
    return each.type in ROUNDED and all(wanted.type == ROUNDED[each.type] for wanted in each.wanted)


def is_refused(each: Given) -> bool:
    """Whether the type is one that the node refuses: none of those that it may declare the param with."""
    return all(wanted.type != each.type for wanted in each.wanted)


def beyond(each: Given) -> str:
    """Why a value of the right type is refused, in words; empty where it is not."""
    for wanted in each.wanted:
        if wanted.type != each.type:
            return ""
        if wanted.one_of:
            if each.value in wanted.one_of:
                return ""
        elif not _is_number(each.value) or not (_is_below(each.value, wanted.min) or _is_below(wanted.max, each.value)):
            return ""
    wanted = each.wanted[0]
    if wanted.one_of:
        return f"one of {', '.join(map(str, wanted.one_of[:_MOST_NAMES]))}"
    return (
        f"at least {wanted.min}"
        if wanted.max is None
        else f"at most {wanted.max}"
        if wanted.min is None
        else f"{wanted.min} to {wanted.max}"
    )


def fate(instance: Instance) -> str:
    """What becomes of a node that refuses a value."""
    return f"{instance.program} {'cannot be loaded' if instance.kind == 'component' else 'dies when it starts'}: it refuses the value"


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _is_below(one: Any, other: Any) -> bool:
    return _is_number(one) and _is_number(other) and one < other and abs(one - other) > 1e-9 * max(abs(one), abs(other))


def never_declared(rule: Rule, view: GraphView) -> Iterator[Finding]:
    """Params that are given to a node that is known to declare no such param, and that it ignores without a word."""
    for instance in view.graph.instances:
        if instance.may_have_more("params"):
            continue
        declared, others = not_declared(instance)
        slips: dict[Origin, list[tuple[str, str]]] = {}
        for name, origin in others.items():
            near = closest(name, declared)
            if near is not None:
                slips.setdefault(origin, []).append((name, near))
                continue
            yield _undeclared(rule, instance, origin, [(name, "")], sorted(_declared(instance)))
        for origin, several in slips.items():  # those of one dictionary, which is one place
            yield _undeclared(rule, instance, origin, several, sorted(_declared(instance)))


def not_declared(instance: Instance) -> tuple[list[str], Mapping[str, Origin]]:
    """The params that a node of ROS 2 declares and is not given, and those that it is given and does not declare, with their places.

    By what is known of it: of sources that were read some may have been missed.
    """
    node = instance.node
    sure = instance.certain and not instance.undeclared and instance.client in _CLIENTS
    sure = sure and not any(each.category == "params" for each in instance.doubts)
    if not node.own or not sure or any(each.declaration.transport for each in instance.endpoints):
        return [], {}
    declared = _declared(instance)
    others: dict[str, Origin] = {}
    for name in node.own:
        origin = node.own_origins.get(name)
        known = name in node.own_shared or name in declared or name in _EVERYWHERE or name.startswith(_OVERRIDES)
        if origin is not None and not known:
            others[name] = origin
    return [each for each in declared if each not in node.own], others


def _undeclared(rule: Rule, instance: Instance, origin: Origin, names: list[tuple[str, str]], declared: list[str]) -> Finding:
    """What is said of params given at one place, each with the one that was probably meant (empty: none is near)."""
    shown = ", ".join(declared[:_MOST_NAMES]) + (" …" if len(declared) > _MOST_NAMES else "")
    given_ = " ".join(name for name, _ in names)
    meant = " and ".join(near for _, near in names if near)
    return rule.at(
        origin,
        f"{instance.name} declares no param{'s' * (len(names) > 1)} {' and '.join(name for name, _ in names)}",
        severity=None if meant else Severity.INFO,
        label="given to it, and ignored",
        notes=(f"{instance.program} declares {shown}" if declared else f"{instance.program} declares no params",),
        help=f"did you mean {meant}?" if meant else "leave it out",
        topic=f"{instance.program} {given_}",
        cause=f"{instance.program} {origin.place.source.path} separators" if _in_other_words(names) else f"{instance.program} {given_}",
    )


def _in_other_words(names: list[tuple[str, str]]) -> bool:
    """Whether all that is wrong with the names is what stands between their words: ``costmap_plugins`` for ``costmap.plugins``."""
    return all(near and name.replace("_", ".") == near.replace("_", ".") for name, near in names)

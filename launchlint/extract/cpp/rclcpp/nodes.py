"""Nodes: how they are made, what they are called, and what gives them back."""

from __future__ import annotations

import re
from collections.abc import Callable as Does

from launchlint.extract.cpp.naming import ANY, NODE_NAME, NODE_NAMESPACE, UNKNOWN_SPACE, below, finished, template
from launchlint.extract.cpp.ros import handle as handles
from launchlint.extract.cpp.ros import params as names
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import UNKNOWN, Either, Handle, Items, Number, Text, Thing, Value, choices, either, node_of
from launchlint.extract.fact import Made, Qos

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.extract.cpp.calls import Call
    from launchlint.extract.cpp.machine import Machine

OPTIONS = "rclcpp::NodeOptions"
_MOST_NODES = 200
_UNDECLARED = ("allow_undeclared_parameters", "automatically_declare_parameters_from_overrides")
_FLAGS = (
    *_UNDECLARED,
    *"""arguments use_intra_process_comms start_parameter_services start_parameter_event_publisher use_global_arguments parameter_overrides
    append_parameter_override context clock_type clock_qos use_clock_thread enable_rosout rosout_qos parameter_event_qos
    parameter_event_publisher_options allocator enable_topic_statistics enable_logger_service""".split(),
)
_ONCE = re.compile(r"\{remap:([^{}]+)\}")
_SELF = frozenset(("shared_from_this", "weak_from_this", "get_node", "getNode", "GetNode"))
"""Members that give the node which an object is; ``get_node()`` where no function of the program is called so."""


# -- making ---------------------------------------------------------------------------------------------------------------


def maker(*, lifecycle: bool = False) -> Does[[Call], Value]:
    """``Node(name)``, ``Node(name, options)``, ``Node(name, namespace, options)``; ``Node(other, sub_namespace)``."""

    def make(asked: Call) -> Value:
        values = [each.value for each in asked.arguments]
        if values and node_of(values[0]) is not None:
            return values[0] if len(values) == 1 else sub_node(values[0], values[1] if len(values) > 1 else UNKNOWN)
        options = next((each for each in values if _is_options(each)), UNKNOWN)
        name = values[0] if values and not _is_options(values[0]) else UNKNOWN
        space = values[1] if len(values) > 1 and not _is_options(values[1]) else Text("")
        return made(asked, name, space, options, lifecycle=lifecycle)

    return make


def made(asked: Call, name: Value, space: Value, options: Value = UNKNOWN, *, lifecycle: bool = False) -> Handle:
    """Note that a node is made, and give it."""
    machine = asked.machine
    undeclared = any(_flag(options, each) for each in _UNDECLARED)
    called, namespace = _name(name), _namespace(space)
    called, moved = _by_arguments(asked, options, called)
    namespace = namespace if moved is None else "" if ANY in moved else moved
    condition = " and ".join(dict.fromkeys(machine.conditions))[:400]
    place = (asked.frame.path, asked.node.line, called)
    known = next((each for each in machine.nodes.values() if (each.path, each.line, each.name) == place), None)
    if known is not None:
        return Handle(_beside_first(known.key, moved), known.key)
    key = f"{len(machine.nodes) + 1}" if machine.nodes else ""
    if len(machine.nodes) >= _MOST_NODES:
        machine.doubt_all(f"only {_MOST_NODES} nodes are listed", asked.frame.path, asked.node.line)
        return Handle("", "")
    machine.nodes[key] = Made(key, called, namespace, lifecycle, undeclared, condition, asked.frame.path, asked.node.line)
    node = Handle(_beside_first(key, moved), key)
    if _held(options, "enable_logger_service") == Number(True):
        for word in ("Get", "Set"):
            note(asked, node, "services", Text(f"~/{word.lower()}_logger_levels"), type=f"rcl_interfaces/srv/{word}LoggerLevels")
    return node


def _beside_first(key: str, moved: str | None) -> str:
    """Where the relative names of a node lie that its options move into the namespace ``moved``, seen from the first one of the program."""
    return "" if not key or moved is None else UNKNOWN_SPACE if ANY in moved else moved


def _is_options(value: Value) -> bool:
    return any(isinstance(each, Thing) and each.type.name == OPTIONS for _, each in choices(value))


def _name(value: Value) -> str:
    """The name that a node gives itself; empty where it is not known."""
    text = template(value) if isinstance(value, Text) else ""
    return "" if ANY in text or len(text) > 200 or not finished(text) else finished(text)


def _namespace(value: Value) -> str:
    text = finished(template(value)) if isinstance(value, Text) else ANY
    return "" if text in ("/", ANY) else text


def _by_arguments(asked: Call, options: Value, name: str) -> tuple[str, str | None]:
    """The name and namespace where the options of a node hold arguments, ``--ros-args -r __node:=x``; None where these say no namespace.

    They come before those of the command line (rclcpp::NodeOptions), so that launch moves such a node only if the program hands it on.
    """
    given = _held(options, "arguments")
    if given is UNKNOWN:
        return name, None
    space: str | None = None
    items = given.items if isinstance(given, Items) else ()
    for each in items:
        left, sign, right = _argument(each)
        if left.endswith("__node"):
            name = "" if ANY in right else right
        elif left.endswith("__ns"):
            space = right
        elif sign or right == ANY:
            asked.machine.doubt_all("a node is made with arguments of its own", asked.frame.path, asked.node.line)
    if not items:
        asked.machine.doubt_all("a node is made with arguments of its own", asked.frame.path, asked.node.line)
    return name, space


def _argument(value: Value) -> tuple[str, str, str]:
    """What stands before ``:=`` in an argument, whether that stands there, and what is behind it, by all its spellings."""
    found = set()
    for _, each in choices(value):
        word, sign, behind = each.template.rpartition(":=") if isinstance(each, Text) else ("", "", ANY)
        found.add((finished(word), sign, finished(behind)))
    lefts, signs = {left for left, _, _ in found}, {sign for _, sign, _ in found}
    if len(lefts) != 1 or len(signs) != 1:
        return "", "", ANY
    return (*found.pop()[:2], ANY) if len(found) > 1 else found.pop()


def _flag(options: Value, name: str) -> bool:
    """Whether an option is given, other than as false."""
    value = _held(options, name)
    return value not in (Number(False), UNKNOWN) or (value is UNKNOWN and _is_set(options, name))


def _is_set(options: Value, name: str) -> bool:
    return any(isinstance(each, Thing) and name in each.fields for _, each in choices(options))


def _held(options: Value, name: str) -> Value:
    for _, each in choices(options):
        if isinstance(each, Thing) and name in each.fields:
            return each.fields[name].value
    return UNKNOWN


def options(asked: Call) -> Value:
    """``NodeOptions()``, or the copy of other ones."""
    first = asked.value(0)
    if asked.arguments and isinstance(first, Thing) and first.type.name == OPTIONS:
        return first
    asked.machine.serial += 1
    return Thing(Type(OPTIONS), None, asked.machine.serial)


def _set(this: Thing, asked: Call) -> Value:
    """A member of NodeOptions that sets something gives the options back; without arguments it tells what is set."""
    if not asked.arguments:
        return handles.held(this, asked.name)
    this.fields.setdefault(asked.name, asked.machine.cell(UNKNOWN))
    asked.machine.write(this.fields[asked.name], asked.value(0))
    return this


def sub_node(parent: Value, name: Value) -> Value:
    """``create_sub_node(name)``: relative names are made below it."""
    found: list[tuple[str, Value]] = []
    for outer, each in choices(parent):
        node = node_of(each)
        for inner, space in choices(name):
            if node is not None:
                found.append((outer or inner, Handle(below(node.namespace, template(space)), node.node)))
    return either(found)


# -- names ----------------------------------------------------------------------------------------------------------------


def note(asked: Call, node: Value, category: str, name: Value, **more: Any) -> Value:
    """Note an interface of a node; its name as the node says it."""
    machine = asked.machine
    said: list[tuple[str, Value]] = []
    for outer, each in choices(node):
        own = node_of(each) or Handle("", "")
        spelled = names.named(own, _as_given(name))
        said += [(outer or inner, one) for inner, one in choices(spelled)]
        if outer:
            machine.conditions.append(outer)
        machine.fact(category, spelled, asked.node, asked.frame, node=own.node or "", **more)
        if outer:
            machine.conditions.pop()
    return either(said)


def _as_given(name: Value) -> Value:
    """A name without its being resolved first: what is resolved twice is the same."""
    found: list[tuple[str, Value]] = []
    for condition, each in choices(name):
        match = _ONCE.fullmatch(each.template) if isinstance(each, Text) else None
        found.append((condition, Text(match[1]) if match else each))
    return either(found)


def qos_with(qos: Qos | None, options_: Value) -> Qos | None:
    """A profile with what the options of a publisher or subscription say: that params may override it."""
    for _, each in choices(options_):
        if isinstance(each, Thing) and "qos_overriding_options" in each.fields:
            return (qos or Qos())._replace(overrides=True)
    return qos


def _node_name(handle: Handle, asked: Call) -> Value:
    """``get_name()``: without the namespace."""
    known = asked.machine.nodes.get(handle.node or "")
    return Text("{node}") if not handle.node or known is None else Text(known.name or ANY)


def _full_name(handle: Handle, asked: Call) -> Value:
    return Text(NODE_NAME) if not handle.node else Text(ANY)


def _node_namespace(handle: Handle, asked: Call) -> Value:
    return Text(NODE_NAMESPACE) if not handle.node else Text(ANY)


def _sub_namespace(handle: Handle, asked: Call) -> Value:
    return Text(handle.namespace)


def _sub_node(handle: Handle, asked: Call) -> Value:
    return sub_node(handle, asked.value(0))


def _itself(handle: Handle, asked: Call) -> Value:
    return handle


def _resolved(handle: Handle, asked: Call) -> Value:
    """``get_topics_interface()->resolve_topic_name(name)``."""
    return handles.resolved(names.named(handle, asked.value(0)))


def _managed(handle: Handle, asked: Call) -> Value:
    """``node->configure()``, ``node->activate()``, ``node->trigger_transition(…)``: the program does it, nobody else has to."""
    known = asked.machine.nodes.get(handle.node or "")
    if known is not None:
        asked.machine.nodes[known.key] = known._replace(managed=True)
    return UNKNOWN


OF_HANDLE: dict[str, Does[[Handle, Call], Value]] = {
    **dict.fromkeys(("configure", "activate", "trigger_transition"), _managed),
    "get_name": _node_name,
    "get_fully_qualified_name": _full_name,
    "get_namespace": _node_namespace,
    "get_effective_namespace": _node_namespace,
    "get_sub_namespace": _sub_namespace,
    "create_sub_node": _sub_node,
    "resolve_topic_name": _resolved,
    "resolve_service_name": _resolved,
    "resolve_topic_or_service_name": _resolved,
    **dict.fromkeys(
        (
            f"get_node_{each}_interface"
            for each in (
                "base", "clock", "graph", "logging", "parameters", "services", "time_source", "timers", "topics", "type_descriptions",
                "waitables",
            )
        ),
        _itself,
    ),
    **dict.fromkeys(("shared_from_this", "weak_from_this", "get", "lock", "getNode", "get_node_interfaces"), _itself),
}  # fmt: skip


def gives_itself(this: Thing, asked: Call) -> bool:
    """Whether a member gives the object that it is called of."""
    return asked.name in _SELF and not asked.arguments and node_of(this) is not None


MAKERS: dict[str, Does[[Call], Value]] = {
    "rclcpp::Node": maker(),
    "rclcpp_lifecycle::LifecycleNode": maker(lifecycle=True),
    OPTIONS: options,
}
METHODS: dict[tuple[str, str], Does[[Thing, Call], Value]] = {(OPTIONS, name): _set for name in _FLAGS}


def unknown(value: Value) -> bool:
    """Whether nothing is known of which node a value is."""
    return not any(node_of(each) is not None for _, each in choices(value)) or isinstance(value, Either)


def first_node(machine: Machine) -> Handle:
    """The node that a name is taken to be of where it is not known whose it is."""
    if "" not in machine.nodes:
        machine.nodes[""] = Made()
    return Handle("", "")

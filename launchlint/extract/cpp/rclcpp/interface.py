"""What a node offers for talking: publishers, subscriptions, services, clients, actions and timers."""

from __future__ import annotations

from collections.abc import Callable as Does

from launchlint.extract.cpp.rclcpp import nodes, params
from launchlint.extract.cpp.rclcpp.nodes import note, qos_with
from launchlint.extract.cpp.rclcpp.qos import qos_of
from launchlint.extract.cpp.ros.callbacks import callback_of, explicit, message_type
from launchlint.extract.cpp.ros.handle import resolved
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import UNKNOWN, Handle, Text, Thing, Value, choices, node_of, plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call

_SILENT = """
    get_logger get_clock now create_callback_group count_publishers count_subscribers count_clients count_services
    get_topic_names_and_types get_node_names get_service_names_and_types wait_for_graph_change get_graph_event
    get_publishers_info_by_topic get_subscriptions_info_by_topic get_node_options for_each_callback_group get_current_state
    get_available_states get_available_transitions get_transition_graph deactivate cleanup shutdown
    register_on_configure register_on_activate register_on_deactivate register_on_cleanup register_on_shutdown register_on_error
    add_managed_entity get_service_names_and_types_by_node get_node_topics_and_types reset use_count expired get_notify_guard_condition
    get_rcl_node_handle get_shared_rcl_node_handle get_context get_default_callback_group
""".split()
"""Members of a node that make no name."""
_SERVICES_OF_PARAMS = (
    ("get_parameters", "GetParameters"),
    ("get_parameter_types", "GetParameterTypes"),
    ("set_parameters", "SetParameters"),
    ("set_parameters_atomically", "SetParametersAtomically"),
    ("list_parameters", "ListParameters"),
    ("describe_parameters", "DescribeParameters"),
)


def endpoint(asked: Call, name: Value) -> Thing:
    """What making a publisher or subscription gives: it knows its topic."""
    asked.machine.serial += 1
    thing = Thing(Type("rclcpp::Publisher"), None, asked.machine.serial)
    thing.fields["<topic>"] = asked.machine.cell(resolved(name))
    return thing


def _publish(node: Value, asked: Call, at: int = 0) -> Value:
    """``create_publisher<T>(topic, qos, options)``."""
    qos = qos_with(qos_of(asked.value(at + 1)), asked.value(at + 2))
    name = note(asked, node, "publishers", asked.value(at), type=explicit(asked), qos=qos)
    for each in asked.arguments[at + 2 :]:
        asked.machine.later(each.value, "subscriber")
    return endpoint(asked, name)


def _subscribe(node: Value, asked: Call, at: int = 0) -> Value:
    """``create_subscription<T>(topic, qos, callback, options)``."""
    callback = callback_of(asked, at + 2)
    qos = qos_with(qos_of(asked.value(at + 1)), asked.value(at + 3))
    kind = explicit(asked) or message_type(asked.machine, callback, asked.frame)
    name = note(asked, node, "subscribers", asked.value(at), type=kind, qos=qos)
    asked.machine.later(callback, "message")
    return endpoint(asked, name)


def _generic_type(value: Value) -> str:
    """The type that a generic publisher or subscription is given as a text."""
    said = [each.template if isinstance(each, Text) else "" for _, each in choices(value)]
    return said[0] if len(said) == 1 and "{any}" not in said[0] and "/" in said[0] else "*"


def _publish_any(node: Value, asked: Call, at: int = 0) -> Value:
    """``create_generic_publisher(topic, type, qos, options)``."""
    qos = qos_with(qos_of(asked.value(at + 2)), asked.value(at + 3))
    return endpoint(asked, note(asked, node, "publishers", asked.value(at), type=_generic_type(asked.value(at + 1)), qos=qos))


def _subscribe_any(node: Value, asked: Call, at: int = 0) -> Value:
    """``create_generic_subscription(topic, type, qos, callback, options)``."""
    qos = qos_with(qos_of(asked.value(at + 2)), asked.value(at + 4))
    name = note(asked, node, "subscribers", asked.value(at), type=_generic_type(asked.value(at + 1)), qos=qos)
    asked.machine.later(callback_of(asked, at + 3), "message")
    return endpoint(asked, name)


def _serve(node: Value, asked: Call, at: int = 0) -> Value:
    """``create_service<T>(name, callback, qos, group)``."""
    name = note(asked, node, "services", asked.value(at), type=explicit(asked, service=True))
    asked.machine.later(callback_of(asked, at + 1), "message")
    return endpoint(asked, name)


def _call_service(node: Value, asked: Call, at: int = 0) -> Value:
    """``create_client<T>(name, qos, group)``."""
    return endpoint(asked, note(asked, node, "clients", asked.value(at), type=explicit(asked, service=True)))


def _timer(node: Value, asked: Call, at: int = 0) -> Value:
    """``create_wall_timer(period, callback, group)``: it fires by itself."""
    asked.machine.later(callback_of(asked, at), asked.machine.when)
    return UNKNOWN


_OF_NODE: dict[str, Does[[Value, Call, int], Value]] = {
    "create_publisher": _publish,
    "create_subscription": _subscribe,
    "create_generic_publisher": _publish_any,
    "create_generic_subscription": _subscribe_any,
    "create_service": _serve,
    "create_client": _call_service,
    "create_wall_timer": _timer,
    "create_timer": _timer,
}


def _of_handle(does: Does[[Value, Call, int], Value]) -> Does[[Handle, Call], Value]:
    return lambda handle, asked: does(handle, asked, 0)


def _of_space(does: Does[[Value, Call, int], Value]) -> Does[[Call], Value | None]:
    """``rclcpp::create_publisher<T>(node, topic, …)``; of subscriptions also with two interfaces in place of the node."""

    def function(asked: Call) -> Value:
        at = 1
        while at < len(asked.arguments) and any(node_of(each) is not None for _, each in choices(asked.value(at))):
            at += 1
        return does(node_at(asked, 0), asked, at)

    return function


def node_at(asked: Call, position: int) -> Value:
    """The node that an argument is; the first one of the program where that is not known."""
    value = asked.value(position)
    return value if any(node_of(each) is not None for _, each in choices(value)) else nodes.first_node(asked.machine)


def action(role: str) -> Does[[Call], Value | None]:
    """``rclcpp_action::create_server<T>(node, name, callbacks …)`` and ``create_client<T>(node, name)``."""

    def function(asked: Call) -> Value:
        at = 0
        while at < len(asked.arguments) and any(node_of(each) is not None for _, each in choices(asked.value(at))):
            at += 1
        at = max(at, 1) if not isinstance(asked.value(0), Text) else at  # a node of which nothing is known is one all the same
        name = note(asked, node_at(asked, 0), "actions", asked.value(at), type=explicit(asked), role=role)
        for each in asked.arguments[at + 1 :]:
            asked.machine.later(each.value, "message")
        return endpoint(asked, name)

    return function


def _wait_for_message(asked: Call) -> Value:
    """``rclcpp::wait_for_message(message, node, topic, timeout, qos)``."""
    cell = asked.cell(0)
    kind = explicit(asked) or (asked.machine.names.message(cell.type, asked.frame) if cell is not None and cell.type.name else "")
    note(asked, node_at(asked, 1), "subscribers", asked.value(2), type=kind)
    return UNKNOWN


def parameters_client(asked: Call) -> Value:
    """``AsyncParametersClient(node, remote)``: the services of the remote node's params; its own where none is named."""
    remote = asked.value(1)
    asked.machine.serial += 1
    thing = Thing(Type(asked.name), None, asked.machine.serial)
    if len(asked.arguments) < 2 or plain(remote) == "" or node_of(remote) is not None:
        return thing
    for name, kind in _SERVICES_OF_PARAMS:
        for condition, each in choices(remote):
            text = Text(f"{each.template}/{name}") if isinstance(each, Text) else UNKNOWN
            asked.machine.conditions += [condition] if condition else []
            note(asked, node_at(asked, 0), "clients", text, type=f"rcl_interfaces/srv/{kind}")
            if condition:
                asked.machine.conditions.pop()
    return thing


def of_object(this: Thing, asked: Call) -> Value | None:
    """The object itself; or what a node offers, where the base class of the object is not here and may be one."""
    if nodes.gives_itself(this, asked):
        return this
    if asked.name in _MAKE and node_of(this) is None and this.declared is not None and asked.machine.unseen.foreign_base(this.declared):
        return OF_HANDLE[asked.name](nodes.first_node(asked.machine), asked)
    return None


_MAKE = frozenset((*_OF_NODE, "declare_parameter", "declare_parameters", "get_parameter", "get_parameter_or"))
"""Members that only nodes have."""

OF_HANDLE: dict[str, Does[[Handle, Call], Value]] = {
    **{name: _of_handle(does) for name, does in _OF_NODE.items()},
    **nodes.OF_HANDLE,
    **params.OF_HANDLE,
    **dict.fromkeys(_SILENT, params.nothing),
}  # fmt: skip
FUNCTIONS: dict[str, Does[[Call], Value | None]] = {
    **{f"rclcpp::{name}": _of_space(does) for name, does in _OF_NODE.items() if name != "create_wall_timer"},
    "rclcpp_action::create_server": action("server"),
    "rclcpp_action::create_client": action("client"),
    "rclcpp::wait_for_message": _wait_for_message,
    **{
        f"rclcpp::node_interfaces::get_node_{each}_interface": (lambda asked: asked.value(0))
        for each in ("base", "parameters", "topics", "services", "clock", "graph", "logging", "timers", "time_source", "waitables")
    },
}
MAKERS: dict[str, Does[[Call], Value]] = {
    "rclcpp::AsyncParametersClient": parameters_client,
    "rclcpp::SyncParametersClient": parameters_client,
}


def _topic(this: Thing, asked: Call) -> Value:
    cell = this.fields.get("<topic>")
    return UNKNOWN if cell is None else cell.value


METHODS: dict[tuple[str, str], Does[[Thing, Call], Value]] = {
    **dict.fromkeys((("rclcpp::Publisher", name) for name in ("get_topic_name", "get_service_name")), _topic),
}

"""What a node of rclpy can do: its methods, by their names.

Source: rclpy.node, rclpy.lifecycle.node. A method that is not here makes no names; functions that it is given are called for an event.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from launchlint.extract.python.arguments import Call
from launchlint.extract.python.outside import NAMESPACE, NODE
from launchlint.extract.python.ros2 import params
from launchlint.extract.python.ros2.names import spelled
from launchlint.extract.python.ros2.nodes import Node
from launchlint.extract.python.ros2.qos import qos_of
from launchlint.python.text import ANY, distribute
from launchlint.python.values import UNKNOWN, Handle, Text, Value

NodeMethod = Callable[[str, Node | None, Call], Value]
"""What calling a method of a node does: the key of the node, the node where it is known, the call."""


def quiet() -> Handle:
    """An object that makes no names and calls nothing: a logger, a clock."""
    return Handle("quiet", {})


def _made(kind: str, name: Value, attribute: str) -> Handle:
    resolved = distribute(_resolved, name)
    return Handle(kind, {("attribute", each): resolved for each in (attribute, "topic" if attribute == "topic_name" else attribute)})


def _resolved(name: Value) -> Value:
    """A name as the graph has it: what the program derives from it follows remappings of it."""
    text = spelled(name, "publishers")
    return UNKNOWN if ANY in text or "|" in text else Text(f"{{remap:{text}}}")


def _publisher(key: str, node: Node | None, made: Call) -> Value:
    name = made.get(1, "topic")
    qos = qos_of(made.get(2, "qos_profile"), made.keywords.get("qos_overriding_options"))
    made.fact("publishers", name, type=made.get(0, "msg_type", ""), qos=qos, node=key)
    return _made("publisher", name, "topic_name")


def _subscription(key: str, node: Node | None, made: Call) -> Value:
    name = made.get(1, "topic")
    qos = qos_of(made.get(3, "qos_profile"), made.keywords.get("qos_overriding_options"))
    made.fact("subscribers", name, type=made.get(0, "msg_type", ""), qos=qos, node=key)
    made.run.escape([made.get(2, "callback", None)], "message")
    return _made("subscription", name, "topic_name")


def _service(key: str, node: Node | None, made: Call) -> Value:
    name = made.get(1, "srv_name")
    made.fact("services", name, type=made.get(0, "srv_type", ""), node=key)
    made.run.escape([made.get(2, "callback", None)], "message")
    return _made("service", name, "srv_name")


def _client(key: str, node: Node | None, made: Call) -> Value:
    name = made.get(1, "srv_name")
    made.fact("clients", name, type=made.get(0, "srv_type", ""), node=key)
    return _made("client", name, "srv_name")


def _timer(key: str, node: Node | None, made: Call) -> Value:
    made.run.escape([made.get(1, "callback", None)], "start")
    return quiet()


def _called(key: str, node: Node | None, made: Call) -> Value:
    made.run.escape([*made.positional, *made.keywords.values()], "message")
    return UNKNOWN


def _resolve(key: str, node: Node | None, made: Call) -> Value:
    return distribute(_resolved, made.positional[0] if made.positional else UNKNOWN)


def _managed(key: str, node: Node | None, made: Call) -> Value:
    """``node.trigger_configure()``, ``node.trigger_activate()``: the program does it, nobody else has to."""
    if node is not None:
        node.made = node.made._replace(managed=True)
    return UNKNOWN


def _nothing(key: str, node: Node | None, made: Call) -> Value:
    return None


def _own_name(key: str, node: Node | None, made: Call) -> Value:
    return Text("{node}")


def _own_namespace(key: str, node: Node | None, made: Call) -> Value:
    return Text(NAMESPACE)


def _own_full_name(key: str, node: Node | None, made: Call) -> Value:
    return Text(NODE)


def _quiet(key: str, node: Node | None, made: Call) -> Value:
    return quiet()


MAKING: Mapping[str, NodeMethod] = {
    "create_publisher": _publisher,
    "create_lifecycle_publisher": _publisher,
    "create_subscription": _subscription,
    "create_service": _service,
    "create_client": _client,
    "declare_parameter": params.declare,
    "declare_parameters": params.declare_all,
}
"""What makes names."""

METHODS: Mapping[str, NodeMethod] = {
    **MAKING,
    "get_parameter": params.get,
    "get_parameter_or": params.get_or,
    "get_parameters": params.get_all,
    "get_parameters_by_prefix": params.by_prefix,
    "create_timer": _timer,
    **dict.fromkeys(
        (
            "create_guard_condition",
            "add_on_set_parameters_callback",
            "add_pre_set_parameters_callback",
            "add_post_set_parameters_callback",
            "set_parameters_callback",
        ),
        _called,
    ),
    "get_name": _own_name,
    "get_namespace": _own_namespace,
    "get_fully_qualified_name": _own_full_name,
    "resolve_topic_name": _resolve,
    "resolve_service_name": _resolve,
    "get_logger": _quiet,
    "get_clock": _quiet,
    "create_rate": _quiet,
    "destroy_node": _nothing,
    "trigger_configure": _managed,
    "trigger_activate": _managed,
}

ATTRIBUTES = frozenset(
    (
        *METHODS,
        *"""__init__ __new__ publishers subscriptions clients services timers guards waitables executor context default_callback_group
        handle undeclare_parameter has_parameter get_parameter_types get_parameter_type set_parameters set_parameters_atomically
        list_parameters
        remove_pre_set_parameters_callback remove_on_set_parameters_callback remove_post_set_parameters_callback describe_parameter
        describe_parameters set_descriptor add_waitable remove_waitable destroy_publisher destroy_subscription destroy_client
        destroy_service destroy_timer destroy_guard_condition destroy_rate get_publisher_names_and_types_by_node
        get_subscriber_names_and_types_by_node get_service_names_and_types_by_node get_client_names_and_types_by_node
        get_topic_names_and_types get_service_names_and_types get_node_names get_fully_qualified_node_names
        get_node_names_and_namespaces get_node_names_and_namespaces_with_enclaves count_publishers count_subscribers count_clients
        count_services get_publishers_info_by_topic get_subscriptions_info_by_topic wait_for_node trigger_configure trigger_cleanup
        trigger_shutdown trigger_activate trigger_deactivate add_managed_entity destroy_lifecycle_publisher on_configure on_cleanup
        on_shutdown on_activate on_deactivate on_error""".split(),
    )
)
"""What a node has, so that a class behind it is not asked for it."""

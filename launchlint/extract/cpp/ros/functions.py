"""Functions of the namespaces ros and image_transport."""

from __future__ import annotations

from collections.abc import Callable as Does

from launchlint.extract.cpp.naming import ANY, NODE_NAME, NODE_NAMESPACE, finished, in_namespace, template
from launchlint.extract.cpp.ros import driver_base, params
from launchlint.extract.cpp.ros import handle as handles
from launchlint.extract.cpp.ros.callbacks import callback_of, explicit, message_type
from launchlint.extract.cpp.spelled_type import UNTYPED, Type
from launchlint.extract.cpp.values import UNKNOWN, Handle, Text, Thing, Value, choices, either

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call

_DEFAULT = Handle("")
_OWN = Handle("~")


def handle_among(asked: Call) -> Handle:
    """The node handle among the arguments, or a default one."""
    for each in asked.arguments:
        for _, value in choices(each.value):
            if isinstance(value, Handle):
                return value
    return _DEFAULT


def _param(asked: Call) -> Value:
    return handles.param(_DEFAULT, asked)


def _get(asked: Call) -> Value:
    if len(asked.arguments) == 1:
        return params.read(asked, params.named(_DEFAULT, asked.value(0)), UNKNOWN, UNTYPED)
    return handles.get_param(_DEFAULT, asked)


def _has(asked: Call) -> Value:
    return handles.has_param(_DEFAULT, asked)


def _search(asked: Call) -> Value:
    """``search(name, found)`` begins at the node's own name; ``search(namespace, name, found)`` where it says."""
    if len(asked.arguments) == 3:
        below = asked.value(0)
        start = finished(below.template).rstrip("/") if isinstance(below, Text) else ""
        return handles.search_param(Handle(start), asked._replace(arguments=asked.arguments[1:]))
    return handles.search_param(_OWN, asked)


def _node_name(asked: Call) -> Value:
    return Text(NODE_NAME)


def _node_namespace(asked: Call) -> Value:
    return Text(NODE_NAMESPACE)


def _resolved(asked: Call) -> Value:
    if len(asked.arguments) > 1 and isinstance(asked.value(1), Text):
        found = [
            (condition, Text(in_namespace(template(space), template(name))))
            for condition, space in choices(asked.value(0))
            for _, name in choices(asked.value(1))
        ]
        return handles.resolved(either([*found]))
    return handles.resolved(asked.value(0))


def _append(asked: Call) -> Value:
    return Text(in_namespace(template(asked.value(0)), template(asked.value(1)))) if len(asked.arguments) > 1 else UNKNOWN


def _wait_for_message(asked: Call) -> Value:
    asked.machine.fact("subscribers", params.named(handle_among(asked), asked.value(0)), asked.node, asked.frame, type=explicit(asked))
    return UNKNOWN


def _client(asked: Call) -> Value:
    if not asked.arguments:
        return UNKNOWN
    kind = explicit(asked, service=True)
    cell = asked.cell(1)
    if not kind and cell is not None and cell.type.name:
        kind = asked.machine.names.message(cell.type, asked.frame, service=True)
    asked.machine.fact("clients", params.named(_DEFAULT, asked.value(0)), asked.node, asked.frame, type=kind)
    return UNKNOWN


def _exists(asked: Call) -> Value:
    if asked.arguments:
        asked.machine.fact("clients", params.named(_DEFAULT, asked.value(0)), asked.node, asked.frame)
    return UNKNOWN


def _camera_info_topic(asked: Call) -> Value:
    return either([(condition, Text(sibling(template(each)))) for condition, each in choices(asked.value(0))])


def sibling(name: str) -> str:
    """The topic of the camera info beside an image (image_transport::getCameraInfoTopic)."""
    done = finished(name)
    if done.startswith("{remap:") and done.endswith("}") and done.count("{") == 1:
        done = done[len("{remap:") : -1]
    if "|" in done and not done.startswith("~{") and not done.startswith("{"):
        return ANY + "/camera_info"
    return f"{{parent:{done}}}/camera_info" if "|" not in done and ANY not in done else f"{ANY}/camera_info"


def _advertise_options(asked: Call) -> Value:
    thing = Thing(Type("ros::AdvertiseOptions"), None, 0)
    fill_advertise(thing, asked)
    return thing


def fill_advertise(thing: Thing, asked: Call) -> None:
    """``ros::AdvertiseOptions::create<T>(topic, queue, …)``."""
    cell = asked.machine.cell
    thing.fields["topic"] = cell(asked.value(0))
    thing.fields["queue_size"] = cell(asked.value(1))
    thing.fields["datatype"] = cell(Text(explicit(asked)))
    for each in asked.arguments[2:]:
        asked.machine.later(each.value, "subscriber")


def _subscribe_options(asked: Call) -> Value:
    thing = Thing(Type("ros::SubscribeOptions"), None, 0)
    fill_subscribe(thing, asked)
    return thing


def fill_subscribe(thing: Thing, asked: Call) -> None:
    """``ros::SubscribeOptions::create<T>(topic, queue, callback, …)``."""
    cell = asked.machine.cell
    callback = callback_of(asked, 2)
    thing.fields["topic"] = cell(asked.value(0))
    thing.fields["queue_size"] = cell(asked.value(1))
    thing.fields["datatype"] = cell(Text(explicit(asked) or message_type(asked.machine, callback, asked.frame)))
    thing.fields["<callback>"] = cell(callback)


def _service_options(asked: Call) -> Value:
    thing = Thing(Type("ros::AdvertiseServiceOptions"), None, 0)
    cell = asked.machine.cell
    callback = callback_of(asked, 1)
    thing.fields["service"] = cell(asked.value(0))
    thing.fields["datatype"] = cell(Text(explicit(asked, service=True) or message_type(asked.machine, callback, asked.frame, service=True)))
    thing.fields["<callback>"] = cell(callback)
    return thing


def _datatype(asked: Call) -> Value:
    return Text(explicit(asked))


def _advertised(asked: Call) -> Value | None:
    """``nodelet_topic_tools::NodeletLazy::advertise<T>(handle, topic, queue, latch)`` and its like."""
    return lazily(asked)


def lazily(asked: Call) -> Value | None:
    """An advertise() that takes the node handle as its first argument."""
    first = choices(asked.value(0))[0][1]
    if not isinstance(first, Handle):
        return None
    return handles.advertise(first, asked._replace(arguments=asked.arguments[1:]))


def nothing(asked: Call) -> Value:
    """A function that makes no name."""
    return UNKNOWN


FUNCTIONS: dict[str, Does[[Call], Value]] = {
    "ros::param::param": _param,
    "ros::param::get": _get,
    "ros::param::getCached": _get,
    "ros::param::has": _has,
    "ros::param::search": _search,
    "ros::this_node::getName": _node_name,
    "ros::this_node::getNamespace": _node_namespace,
    "ros::names::remap": _resolved,
    "ros::names::resolve": _resolved,
    "ros::names::append": _append,
    "ros::topic::waitForMessage": _wait_for_message,
    "ros::service::call": _client,
    "ros::service::createClient": _client,
    "ros::service::waitForService": _exists,
    "image_transport::getCameraInfoTopic": _camera_info_topic,
    "ros::AdvertiseOptions::create": _advertise_options,
    "ros::SubscribeOptions::create": _subscribe_options,
    "ros::AdvertiseServiceOptions::create": _service_options,
    "driver_base::main": driver_base.main,
    "ros::message_traits::datatype": _datatype,
    "ros::message_traits::DataType::value": _datatype,
    **dict.fromkeys(
        (
            "ros::init",
            "ros::spin",
            "ros::spinOnce",
            "ros::shutdown",
            "ros::param::set",
            "ros::param::del",
            "ros::ok",
            "ros::service::exists",
        ),
        nothing,
    ),
}

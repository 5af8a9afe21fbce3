"""Members of ros::NodeHandle."""

from __future__ import annotations

from collections.abc import Callable as Does

from launchlint.extract.cpp.naming import ANY, finished, full_name
from launchlint.extract.cpp.ros import params
from launchlint.extract.cpp.ros.callbacks import callback_of, explicit, message_type
from launchlint.extract.cpp.spelled_type import UNTYPED
from launchlint.extract.cpp.values import UNKNOWN, Handle, Number, Text, Thing, Value, choices, either

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call


def queue_of(value: Value) -> int | None:
    """The length of a queue."""
    if isinstance(value, Number) and not isinstance(value.value, bool) and 0 <= value.value < 1e9:
        return int(value.value)
    return None


def options_of(value: Value, name: str) -> Thing | None:
    """An options object, as ros::AdvertiseOptions."""
    return value if isinstance(value, Thing) and value.type.name == name else None


def held(thing: Thing, name: str) -> Value:
    """The value of a member of a library's object."""
    cell = thing.fields.get(name)
    return UNKNOWN if cell is None else cell.value


def text_held(thing: Thing, name: str) -> str:
    """The text of a member of a library's object; empty where it is not known."""
    value = held(thing, name)
    return value.template if isinstance(value, Text) and "{" not in value.template else ""


def advertise(handle: Handle, asked: Call) -> Value:
    """``advertise<T>(topic, queue, latch)``, ``advertise<T>(topic, queue, connect, …)``, ``advertise(options)``."""
    machine = asked.machine
    options = options_of(asked.value(0), "ros::AdvertiseOptions")
    if options is not None:
        machine.fact(
            "publishers",
            params.named(handle, held(options, "topic")),
            asked.node,
            asked.frame,
            type=text_held(options, "datatype"),
            queue=queue_of(held(options, "queue_size")),
            latched=held(options, "latch") == Number(True),
        )
        return UNKNOWN
    latched = any(each.value == Number(True) for each in asked.arguments[2:])
    machine.fact(
        "publishers",
        params.named(handle, asked.value(0)),
        asked.node,
        asked.frame,
        type=explicit(asked),
        queue=queue_of(asked.value(1)),
        latched=latched,
    )
    for each in asked.arguments[2:]:
        machine.later(each.value, "subscriber")
    return publisher(asked, handle, asked.value(0))


def publisher(asked: Call, handle: Handle, topic: Value) -> Thing:
    """The object that advertising or subscribing gives: it knows its topic."""
    from launchlint.extract.cpp.spelled_type import Type

    asked.machine.serial += 1
    thing = Thing(Type("ros::Publisher"), None, asked.machine.serial)
    thing.fields["<topic>"] = asked.machine.cell(resolved(params.named(handle, topic)))
    return thing


def resolved(name: Value) -> Value:
    """A name, resolved and remapped: ``{remap:…}``."""
    found: list[tuple[str, Value]] = []
    for condition, each in choices(name):
        text = finished(each.template) if isinstance(each, Text) else ANY
        found.append((condition, Text(f"{{remap:{text}}}" if "|" not in text and ANY not in text and text else ANY)))
    return either(found)


def subscribe(handle: Handle, asked: Call) -> Value:
    """``subscribe(topic, queue, callback, …)`` in all its forms."""
    machine = asked.machine
    options = options_of(asked.value(0), "ros::SubscribeOptions")
    if options is not None:
        name, kind, queue = held(options, "topic"), text_held(options, "datatype"), held(options, "queue_size")
        callback = held(options, "<callback>")
    else:
        callback = callback_of(asked, 2)
        kind = explicit(asked) or message_type(machine, callback, asked.frame)
        name, queue = asked.value(0), asked.value(1)
    machine.fact("subscribers", params.named(handle, name), asked.node, asked.frame, type=kind, queue=queue_of(queue))
    machine.later(callback, "message")
    return publisher(asked, handle, name)


def advertise_service(handle: Handle, asked: Call) -> Value:
    """``advertiseService(name, callback, …)``."""
    machine = asked.machine
    options = options_of(asked.value(0), "ros::AdvertiseServiceOptions")
    if options is not None:
        name, kind, callback = held(options, "service"), text_held(options, "datatype"), held(options, "<callback>")
    else:
        callback = callback_of(asked, 1)
        name = asked.value(0)
        kind = (
            message_type(machine, callback, asked.frame, service=True) or explicit(asked, service=True) or explicit(asked, 1, service=True)
        )
    machine.fact("services", params.named(handle, name), asked.node, asked.frame, type=kind)
    machine.later(callback, "message")
    return publisher(asked, handle, name)


def service_client(handle: Handle, asked: Call) -> Value:
    """``serviceClient<T>(name)``."""
    asked.machine.fact("clients", params.named(handle, asked.value(0)), asked.node, asked.frame, type=explicit(asked, service=True))
    return publisher(asked, handle, asked.value(0))


def param(handle: Handle, asked: Call) -> Value:
    """``param(name, variable, default)`` and ``param(name, default)``."""
    name = params.named(handle, asked.value(0))
    explicit_type = asked.types[0] if asked.types else UNTYPED
    cell = asked.cell(1)
    type_ = explicit_type if explicit_type.name or cell is None else cell.type
    if len(asked.arguments) >= 3:
        return params.into(asked, name, cell, params.given_default(asked, 2, type_), False, explicit_type)
    return params.read(asked, name, params.given_default(asked, 1, type_), type_)


def get_param(handle: Handle, asked: Call) -> Value:
    """``getParam(name, variable)``."""
    return params.into(asked, params.named(handle, asked.value(0)), asked.cell(1), UNKNOWN, True)


def set_param(handle: Handle, asked: Call) -> Value:
    """``setParam(name, value)``: what is read of it from here on is what was set, and no launch file's."""
    if not asked.machine.conditions:
        asked.machine.set_here.update(each.template for _, each in choices(params.named(handle, asked.value(0))) if isinstance(each, Text))
    return UNKNOWN


def has_param(handle: Handle, asked: Call) -> Value:
    """``hasParam(name)``."""
    asked.machine.fact("params", params.named(handle, asked.value(0)), asked.node, asked.frame)
    return UNKNOWN


def search_param(handle: Handle, asked: Call) -> Value:
    """``searchParam(name, found)``: looked for in the namespace of the handle, then upward; what is found is called by the nearest name."""
    machine = asked.machine
    name = params.named(handle, asked.value(0))
    machine.fact("params", name, asked.node, asked.frame)
    machine.conditions.append("where nothing nearer is set")
    for outer in _around(handle.namespace):
        further = params.named(Handle(outer), asked.value(0))
        if further != name:  # which one that is global is
            machine.fact("params", further, asked.node, asked.frame)
    machine.conditions.pop()
    cell = asked.cell(1)
    if cell is not None:
        machine.write(cell, name)
    return UNKNOWN


def _around(namespace: str) -> list[str]:
    """The namespaces around that of a handle, the nearest first (``~`` lies in the node's, as its name says).

    Those around a param whose default value is a name with several parts are not known: they are one unknown namespace.
    """
    found: list[str] = []
    while namespace not in ("", "/"):
        outer, slash, last = namespace.rpartition("/")
        if last.count("}") > last.count("{"):  # it is cut amid a default value
            found.append(ANY)
            namespace = namespace[: namespace.find("{")].rstrip("/")
            continue
        namespace = outer if slash and outer else "/" if slash else ""
        found.append(namespace)
    return found if found[-1:] == ["/"] else [*found, "/"]


def resolve_name(handle: Handle, asked: Call) -> Value:
    """``resolveName(name)``: remapped, unless it is told not to."""
    name = params.named(handle, asked.value(0))
    if len(asked.arguments) > 1 and asked.value(1) == Number(False):
        return either([(condition, Text(full_name(each.template))) for condition, each in choices(name) if isinstance(each, Text)])
    return resolved(name)


def namespace(handle: Handle, asked: Call) -> Value:
    """``getNamespace()``."""
    return Text(full_name(handle.namespace))


def timer(handle: Handle, asked: Call) -> Value:
    """``createTimer(period, callback, …)``: it fires by itself."""
    asked.machine.later(callback_of(asked, 1), asked.machine.when)
    return UNKNOWN


def nothing(handle: Handle, asked: Call) -> Value:
    """A member that makes no name."""
    return UNKNOWN


def same(handle: Handle, asked: Call) -> Value:
    """A member that gives the node handle itself."""
    return handle


METHODS: dict[str, Does[[Handle, Call], Value]] = {
    "advertise": advertise,
    "subscribe": subscribe,
    "advertiseService": advertise_service,
    "serviceClient": service_client,
    "param": param,
    "getParam": get_param,
    "getParamCached": get_param,
    "setParam": set_param,
    "hasParam": has_param,
    "searchParam": search_param,
    "resolveName": resolve_name,
    "getNamespace": namespace,
    "getUnresolvedNamespace": namespace,
    "createTimer": timer,
    "createWallTimer": timer,
    "createSteadyTimer": timer,
    "get": same,
    **dict.fromkeys(
        ("deleteParam", "setCallbackQueue", "getCallbackQueue", "ok", "shutdown", "getParamNames", "reset", "getRemappings"),
        nothing,
    ),
}

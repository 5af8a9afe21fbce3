"""The calls of rospy itself, and of message_filters.

Names are resolved as rospy.names does: ``~x`` is private, ``/x`` global, the rest relative to the node's namespace.
"""

from __future__ import annotations

from launchlint.extract.python.arguments import Call, plain, queue
from launchlint.extract.python.names import ros_joined, ros_name
from launchlint.extract.python.outside import NAMESPACE, NODE, Param
from launchlint.python.text import ANY, distribute, joined, text
from launchlint.python.values import (
    MISSING,
    UNKNOWN,
    Argv,
    Choice,
    Handle,
    Seq,
    Text,
    Value,
    alternatives,
    conjunction,
)


def _handle(kind: str, name: Value) -> Handle:
    resolved = distribute(_resolved, name)
    return Handle(kind, {("attribute", "name"): resolved, ("attribute", "resolved_name"): resolved, "name": name})


def _resolved(name: Value) -> Value:
    """A resolved name as a string: what follows from it is derived from the remapped name."""
    spelled = ros_name(name)
    return UNKNOWN if ANY in spelled else Text(f"{{remap:{spelled}}}") if "|" not in spelled else UNKNOWN


def publisher(made: Call) -> Value:
    """``rospy.Publisher``."""
    name = made.get(0, "name")
    latch = made.get(4, "latch", False)
    made.fact("publishers", name, type=made.get(1, "data_class", ""), latched=latch is True, queue=queue(made.get(6, "queue_size", None)))
    made.run.escape([made.get(2, "subscriber_listener", None)], "message")
    return _handle("publisher", name)


def subscriber(made: Call) -> Value:
    """``rospy.Subscriber``, ``message_filters.Subscriber``."""
    name = made.get(0, "name")
    made.fact("subscribers", name, type=made.get(1, "data_class", ""), queue=queue(made.get(4, "queue_size", None)))
    callback = made.get(2, "callback", None)
    given = made.get(3, "callback_args", None)
    if callback is not None and given is not None:
        made.run.arrange(callback, "message", [UNKNOWN, given])
    else:
        made.run.escape([callback], "message")
    return _handle("subscriber", name)


def _wait_for_message(made: Call) -> Value:
    made.fact("subscribers", made.get(0, "topic"), type=made.get(1, "topic_type", ""))
    return UNKNOWN


def _service(made: Call) -> Value:
    name = made.get(0, "name")
    made.fact("services", name, type=made.get(1, "service_class", ""))
    made.run.escape([made.get(2, "handler", None)], "message")
    return _handle("service", name)


def _service_proxy(made: Call) -> Value:
    name = made.get(0, "name")
    made.fact("clients", name, type=made.get(1, "service_class", ""))
    return _handle("client", name)


def _wait_for_service(made: Call) -> Value:
    made.fact("clients", made.get(0, "service"))
    return None


def _get_param(made: Call) -> Value:
    name = made.get(0, "param_name")
    default = made.get(1, "default")
    for _, each in alternatives(name):
        if isinstance(each, Handle) and each.kind == "found param":  # it is noted where it was searched for
            return Param(each.state["name"], default)
    known = plain(default) if default is not MISSING else MISSING
    # The default promises no type: rospy gives back whatever the param is.
    made.fact("params", name, default=None if known is MISSING else known)
    if isinstance(name, Choice):
        return distribute(lambda each: Param(ros_name(each), default), name)
    return Param(ros_name(name), default)


def _has_param(made: Call) -> Value:
    made.fact("params", made.get(0, "param_name"))
    return UNKNOWN


def _search_param(made: Call) -> Value:
    name = made.get(0, "param_name")
    if isinstance(name, str) and not name.startswith(("/", "~")):
        made.fact("params", f"~{name}")
        for each in (name, f"/{name}"):
            made.run.conditions.append("where nothing nearer is set")
            made.fact("params", each)
            made.run.conditions.pop()
        return Handle("found param", {"name": f"~{name}"})
    made.fact("params", name)
    return UNKNOWN


def _get_param_names(made: Call) -> Value:
    made.doubt("it asks for the names of all params", ("params",))
    return UNKNOWN


def _name(made: Call) -> Value:
    return Text(NODE)


def _namespace(made: Call) -> Value:
    return Text(NAMESPACE)


def _resolve(made: Call) -> Value:
    return distribute(_resolved, made.get(0, "name", UNKNOWN))


def _shutdown(made: Call) -> Value:
    return False


def _arguments(made: Call) -> Value:
    given = made.get(0, "argv", Argv(0))
    return given if isinstance(given, Argv) else Argv(0)


def _join(made: Call) -> Value:
    return ros_joined(made.get(0, "ns", UNKNOWN), made.get(1, "name", UNKNOWN))


def _timer(made: Call) -> Value:
    made.run.escape([made.get(1, "callback", None)], "start")
    return Handle("plain", {})


def _later(made: Call) -> Value:
    made.run.escape([*made.positional, *made.keywords.values()], "message")
    return UNKNOWN


def _nothing(made: Call) -> Value:
    return None


def _started(made: Call) -> Value:
    made.run.starts.append(conjunction(made.run.conditions))
    return None


def _register_callback(receiver: Handle, made: Call) -> Value:
    made.run.escape(made.positional, "message")
    return UNKNOWN


def _synchronizer(made: Call) -> Value:
    return Handle("synchronizer", {})


def _unregister(receiver: Handle, made: Call) -> Value:
    return None


def _private_join(made: Call) -> Value:
    return joined([text("~"), made.get(0, "name", UNKNOWN)])


def _published(made: Call) -> Value:
    return Seq([], False)


def _master(made: Call) -> Value:
    return Handle("master", {})


def _asked_of_master(receiver: Handle, made: Call) -> Value:
    made.fact("params", made.get(0, "key"))
    return UNKNOWN


def _registered_at_master(receiver: Handle, made: Call) -> Value:
    made.doubt("it registers names at the master by itself")
    return UNKNOWN


HANDLERS = {
    "rospy.Publisher": publisher,
    "rospy.Subscriber": subscriber,
    "rospy.Service": _service,
    "rospy.ServiceProxy": _service_proxy,
    "rospy.wait_for_message": _wait_for_message,
    "rospy.wait_for_service": _wait_for_service,
    "rospy.get_param": _get_param,
    "rospy.get_param_cached": _get_param,
    "rospy.has_param": _has_param,
    "rospy.search_param": _search_param,
    "rospy.get_param_names": _get_param_names,
    "rospy.get_name": _name,
    "rospy.get_caller_id": _name,
    "rospy.get_namespace": _namespace,
    "rospy.resolve_name": _resolve,
    "rospy.remap_name": _resolve,
    "rospy.is_shutdown": _shutdown,
    "rospy.is_shutdown_requested": _shutdown,
    "rospy.myargv": _arguments,
    "rosgraph.myargv": _arguments,
    "rosgraph.names.ns_join": _join,
    **dict.fromkeys(("rosgraph.Master", "rosgraph.MasterAPI", "rosgraph.masterapi.Master", "rospy.get_master"), _master),
    "rospy.Timer": _timer,
    "rospy.on_shutdown": _later,
    "rospy.init_node": _started,
    "rospy.spin": _nothing,
    "rospy.sleep": _nothing,
    "rospy.get_published_topics": _published,
    "message_filters.Subscriber": subscriber,
    "message_filters.TimeSynchronizer": _synchronizer,
    "message_filters.ApproximateTimeSynchronizer": _synchronizer,
    "message_filters.Cache": _synchronizer,
    "numpy_msg": _nothing,
    "rospy.numpy_msg": lambda made: made.get(0, "msg_type", UNKNOWN),
}

METHODS = {
    ("synchronizer", "registerCallback"): _register_callback,
    ("subscriber", "registerCallback"): _register_callback,
    ("publisher", "unregister"): _unregister,
    **{("master", method): _asked_of_master for method in ("getParam", "hasParam", "searchParam", "subscribeParam")},
    **{("master", method): _registered_at_master for method in ("registerPublisher", "registerSubscriber", "registerService")},
}

"""Classes of ROS packages that make names when they are made, and their members."""

from __future__ import annotations

from collections.abc import Callable as Does
from collections.abc import Sequence

from launchlint.extract.cpp.naming import UNKNOWN_SPACE, below, template
from launchlint.extract.cpp.ros import driver_base, functions, loading, params
from launchlint.extract.cpp.ros import handle as handles
from launchlint.extract.cpp.ros.callbacks import action_type, callback_of, explicit, message_type
from launchlint.extract.cpp.ros.reconfigure import reconfigured
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import UNKNOWN, Either, Handle, Number, Text, Thing, Value, choices, either, plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call

_DEFAULT, _PRIVATE = Handle(""), Handle("~")
_TF = "tf2_msgs/TFMessage"
_IMAGE, _INFO = "sensor_msgs/Image", "sensor_msgs/CameraInfo"


def _thing(asked: Call, name: str, **fields: Value) -> Thing:
    asked.machine.serial += 1
    thing = Thing(Type(name, asked.types), None, asked.machine.serial)
    for key, value in fields.items():
        thing.fields[key] = asked.machine.cell(value)
    return thing


def _handle(asked: Call) -> Value:
    """``NodeHandle()``, ``NodeHandle(ns)``, ``NodeHandle(other)``, ``NodeHandle(other, ns)``."""
    first = asked.value(0)
    if not asked.arguments:
        return _DEFAULT
    if any(isinstance(each, Handle) for _, each in choices(first)):
        if len(asked.arguments) == 1:
            return first
        spaces: Sequence[tuple[str, Value]] = choices(first)
        names = asked.value(1)
    else:
        spaces, names = (("", _DEFAULT),), first
    given = choices(names)
    if any(each.cell is not None and each.cell.changing and each.value == Text("") for each in asked.arguments):
        given = (("", UNKNOWN),)  # it is set somewhere
    elif any(each is UNKNOWN for _, each in given):  # an empty text is what it was before it was set
        given = tuple((condition, each) for condition, each in given if each != Text(""))
    found: list[tuple[str, Value]] = []
    for outer, space in spaces:
        for inner, name in given:
            if isinstance(space, Handle):
                text = UNKNOWN_SPACE if name is UNKNOWN else template(name)
                if text.startswith("~") and asked.machine.is_loaded:
                    text = below(_private(asked).namespace, text[1:].lstrip("/"))
                found.append((outer or inner, Handle(below(space.namespace, text))))
    return either(found)


def _private(asked: Call) -> Handle:
    """``NodeHandle("~")``: private names of the process. That of a nodelet is its manager, which other names tell; which, is not known."""
    return Handle(UNKNOWN_SPACE) if asked.machine.is_loaded else _PRIVATE


def _handle_at(asked: Call, position: int) -> Value:
    """The node handle that an argument is: one somewhere where it cannot be told, as of an array; a default one where it is not given."""
    if position >= len(asked.arguments):
        return _DEFAULT
    given = asked.value(position)
    return Handle(UNKNOWN_SPACE) if given is UNKNOWN else given if _holds_handle(given) else _DEFAULT


def _holds_handle(value: Value) -> bool:
    return any(isinstance(one, Handle) for _, one in choices(value))


def _transport(asked: Call) -> Value:
    return _thing(asked, "image_transport::ImageTransport", handle=_handle_at(asked, 0))


def _listener(asked: Call) -> Value:
    for name in ("/tf", "/tf_static"):
        asked.machine.fact("subscribers", Text(name), asked.node, asked.frame, type=_TF, queue=100)
    if asked.name == "tf::TransformListener":
        asked.machine.fact("params", Text("~tf_prefix"), asked.node, asked.frame, value_type="str")
    return _thing(asked, asked.name)


def _broadcaster(asked: Call) -> Value:
    asked.machine.fact("publishers", Text("/tf"), asked.node, asked.frame, type=_TF, queue=100)
    return _thing(asked, asked.name)


def _static_broadcaster(asked: Call) -> Value:
    asked.machine.fact("publishers", Text("/tf_static"), asked.node, asked.frame, type=_TF, queue=100, latched=True)
    return _thing(asked, asked.name)


def _updater(asked: Call) -> Value:
    machine = asked.machine
    machine.fact("publishers", Text("/diagnostics"), asked.node, asked.frame, type="diagnostic_msgs/DiagnosticArray", queue=1)
    private = asked.value(1) if isinstance(asked.value(1), Handle) else _PRIVATE
    name = params.named(private if isinstance(private, Handle) else _PRIVATE, Text("diagnostic_period"))
    machine.fact("params", name, asked.node, asked.frame, default=1.0, value_type="double")
    return _thing(asked, asked.name)


def _at_handle(asked: Call) -> tuple[Value, Sequence[Value]]:
    """The node handle that comes first, or a default one, and the other arguments."""
    values = [each.value for each in asked.arguments]
    if values and _holds_handle(values[0]):
        return values[0], values[1:]
    if len(values) > 1 and values[0] is UNKNOWN and isinstance(values[1], Text):
        return Handle(UNKNOWN_SPACE), values[1:]  # a name comes second only behind a handle
    return _DEFAULT, values


def _in(handle: Value, name: Value) -> Value:
    found: list[tuple[str, Value]] = []
    for condition, each in choices(handle):
        space = each if isinstance(each, Handle) else Handle(UNKNOWN_SPACE)
        found += [(condition or inner, value) for inner, value in choices(params.named(space, name))]
    return either(found)


def _action(role: str) -> Does[[Call], Value]:
    def make(asked: Call) -> Value:
        handle, rest = _at_handle(asked)
        name = rest[0] if rest else UNKNOWN
        asked.machine.fact("actions", _in(handle, name), asked.node, asked.frame, type=action_type(asked), role=role)
        for each in asked.arguments:
            asked.machine.later(callback_of(asked, 0) if each.value is asked.value(0) else each.value, "message")
        return _thing(asked, asked.name)

    return make


def _reconfigure(asked: Call) -> Value:
    given = (each.value for each in asked.arguments if any(isinstance(one, Handle) for _, one in choices(each.value)))
    handle = next(given, _private(asked))
    machine, node, frame = asked.machine, asked.node, asked.frame
    more = {"latched": True}
    machine.fact(
        "publishers",
        _in(handle, Text("parameter_descriptions")),
        node,
        frame,
        type="dynamic_reconfigure/ConfigDescription",
        queue=1,
        **more,
    )
    machine.fact("publishers", _in(handle, Text("parameter_updates")), node, frame, type="dynamic_reconfigure/Config", queue=1, **more)
    machine.fact("services", _in(handle, Text("set_parameters")), node, frame, type="dynamic_reconfigure/Reconfigure")
    reconfigured(asked, handle)
    return _thing(asked, asked.name)


def _filter_subscriber(asked: Call) -> Value:
    thing = _thing(asked, "message_filters::Subscriber")
    if asked.arguments:
        _filter_subscribe(thing, asked)
    return thing


def _filter_subscribe(this: Thing, asked: Call) -> Value:
    """``subscribe(handle, topic, queue, hints)``."""
    if len(asked.arguments) < 2:
        return UNKNOWN
    handle, rest = _at_handle(asked)
    if len(rest) == len(asked.arguments) and not isinstance(asked.value(0), (Text, Either)):
        handle, rest = Handle(UNKNOWN_SPACE), rest[1:]
    kinds = asked._replace(types=this.type.arguments)
    queue = handles.queue_of(rest[1]) if len(rest) > 1 else None
    asked.machine.fact("subscribers", _in(handle, rest[0]), asked.node, asked.frame, type=explicit(kinds), queue=queue)
    return UNKNOWN


def _transport_of(this: Value) -> Value:
    if isinstance(this, Thing):
        cell = this.fields.get("handle")
        if cell is not None:
            return cell.value
    return Handle(UNKNOWN_SPACE) if not isinstance(this, Handle) else this


def _image_subscribed(asked: Call, name: Value, queue: Value) -> None:
    """A subscription to images; image_transport::TransportHints name the param with its transport, which is ``~image_transport`` else."""
    machine, node, frame = asked.machine, asked.node, asked.frame
    machine.fact("subscribers", name, node, frame, type=_IMAGE, queue=handles.queue_of(queue), transport="image")
    values = [each.value for each in asked.arguments]
    hints = next((each for each in values if isinstance(each, Thing) and each.type.last == "TransportHints"), None)
    if hints is None:
        machine.fact("params", Text("~image_transport"), node, frame, default="raw", value_type="str")
        return
    param = plain(handles.held(hints, "<param>"))
    if param is not None and param != "~image_transport":
        machine.conditions.append(f"{param} is not raw")
        for _, each in choices(name):
            machine.fact("subscribers", Text(f"{template(each)}/{{param:{param}}}"), node, frame)
        machine.conditions.pop()


def _hints(asked: Call) -> Value:
    """``TransportHints(transport, ros hints, handle, param)``."""
    if asked.arguments and isinstance(asked.value(0), Thing) and asked.value(0) is not None and len(asked.arguments) == 1:
        return asked.value(0)
    handle = asked.value(2) if len(asked.arguments) > 2 else _PRIVATE
    name = asked.value(3) if len(asked.arguments) > 3 else Text("image_transport")
    default = asked.value(0) if asked.arguments else Text("raw")
    param = _in(handle, name)
    asked.machine.fact("params", param, asked.node, asked.frame, default=params.default_of(default, "str"), value_type="str")
    return _thing(asked, "image_transport::TransportHints", **{"<param>": param})


def _image_advertise(this: Thing, asked: Call) -> Value:
    latched = any(each.value == Number(True) for each in asked.arguments[2:])
    name = _in(_transport_of(this), asked.value(0))
    queue = handles.queue_of(asked.value(1))
    asked.machine.fact("publishers", name, asked.node, asked.frame, type=_IMAGE, queue=queue, latched=latched, transport="image")
    for each in asked.arguments[2:]:
        asked.machine.later(each.value, "subscriber")
    return _thing(asked, "image_transport::Publisher", **{"<topic>": handles.resolved(name)})


def _siblings(name: Value) -> Value:
    return either([(condition, Text(functions.sibling(template(each)))) for condition, each in choices(name)])


def _camera_advertise(this: Thing, asked: Call) -> Value:
    publisher = _image_advertise(this, asked)
    latched = any(each.value == Number(True) for each in asked.arguments[2:])
    name = _siblings(_in(_transport_of(this), asked.value(0)))
    queue = handles.queue_of(asked.value(1))
    asked.machine.fact("publishers", name, asked.node, asked.frame, type=_INFO, queue=queue, latched=latched)
    return publisher


def _image_subscribe(this: Thing, asked: Call) -> Value:
    name = _in(_transport_of(this), asked.value(0))
    _image_subscribed(asked, name, asked.value(1))
    asked.machine.later(callback_of(asked, 2), "message")
    return _thing(asked, "image_transport::Subscriber", **{"<topic>": handles.resolved(name)})


def _camera_subscribe(this: Thing, asked: Call) -> Value:
    subscriber = _image_subscribe(this, asked)
    name = _siblings(_in(_transport_of(this), asked.value(0)))
    asked.machine.fact("subscribers", name, asked.node, asked.frame, type=_INFO, queue=handles.queue_of(asked.value(1)))
    return subscriber


def _image_filter(asked: Call) -> Value:
    thing = _thing(asked, "image_transport::SubscriberFilter")
    if len(asked.arguments) > 1:
        _image_filter_subscribe(thing, asked)
    return thing


def _image_filter_subscribe(this: Thing, asked: Call) -> Value:
    """``subscribe(transport, topic, queue, hints)``."""
    if len(asked.arguments) < 2:
        return UNKNOWN
    name = _in(_transport_of(asked.value(0)), asked.value(1))
    _image_subscribed(asked, name, asked.value(2))
    return UNKNOWN


def _info_manager(asked: Call) -> Value:
    """camera_info_manager::CameraInfoManager(handle, name, url): a service beside the images."""
    name = _in(_handle_at(asked, 0), Text("set_camera_info"))
    asked.machine.fact("services", name, asked.node, asked.frame, type="sensor_msgs/SetCameraInfo")
    return _thing(asked, asked.name)


def _realtime_publisher(asked: Call) -> Value:
    thing = _thing(asked, "realtime_tools::RealtimePublisher")
    if len(asked.arguments) > 1:
        _realtime_init(thing, asked)
    return thing


def _realtime_init(this: Thing, asked: Call) -> Value:
    """``RealtimePublisher<T>(handle, topic, queue, latched)``."""
    handle, rest = _at_handle(asked)
    kinds = asked._replace(types=this.type.arguments)
    asked.machine.fact(
        "publishers",
        _in(handle, rest[0] if rest else UNKNOWN),
        asked.node,
        asked.frame,
        type=explicit(kinds),
        queue=handles.queue_of(rest[1]) if len(rest) > 1 else None,
        latched=Number(True) in rest[2:],
    )
    return UNKNOWN


def _markers(asked: Call) -> Value:
    """interactive_markers::InteractiveMarkerServer(namespace, …)."""
    machine, node, frame = asked.machine, asked.node, asked.frame
    for category, end, kind, queue in (
        ("publishers", "update", "InteractiveMarkerUpdate", 100),
        ("publishers", "update_full", "InteractiveMarkerInit", 100),
        ("subscribers", "feedback", "InteractiveMarkerFeedback", 100),
    ):
        name = either([(condition, Text(f"{template(each)}/{end}")) for condition, each in choices(asked.value(0))])
        latched = {"latched": True} if end == "update_full" else {}
        machine.fact(category, name, node, frame, type=f"visualization_msgs/{kind}", queue=queue, **latched)
    return _thing(asked, asked.name)


def _self_test(asked: Call) -> Value:
    handle = next((each.value for each in asked.arguments[1:] if isinstance(each.value, Handle)), _PRIVATE)
    asked.machine.fact("services", _in(handle, Text("self_test")), asked.node, asked.frame, type="diagnostic_msgs/SelfTest")
    return _thing(asked, asked.name)


def _controller_manager(asked: Call) -> Value:
    machine, node, frame = asked.machine, asked.node, asked.frame
    handle = _handle_at(asked, 1)
    for name, kind in (
        ("list_controllers", "ListControllers"),
        ("list_controller_types", "ListControllerTypes"),
        ("load_controller", "LoadController"),
        ("unload_controller", "UnloadController"),
        ("switch_controller", "SwitchController"),
        ("reload_controller_libraries", "ReloadControllerLibraries"),
    ):
        machine.fact("services", _in(handle, Text(f"controller_manager/{name}")), node, frame, type=f"controller_manager_msgs/{kind}")
    machine.doubt_all("controller_manager::ControllerManager loads controllers, which have interfaces of their own", frame.path, node.line)
    return _thing(asked, asked.name)


def _description(this: Thing, asked: Call) -> Value:
    """``initParam(name)`` of a robot model."""
    asked.machine.fact(
        "params", asked.value(0) if asked.arguments else Text("robot_description"), asked.node, asked.frame, value_type="str"
    )
    return UNKNOWN


def _filter_chain(this: Thing, asked: Call) -> Value:
    """``filters::FilterChain::configure(param, handle)``."""
    handle = next((each.value for each in asked.arguments if isinstance(each.value, Handle)), _DEFAULT)
    asked.machine.fact("params", _in(handle, asked.value(0)), asked.node, asked.frame, value_type="list")
    asked.machine.doubt_all("filters::FilterChain loads the filters that its param names", asked.frame.path, asked.node.line)
    return UNKNOWN


def _options_init(this: Thing, asked: Call) -> Value:
    """``options.init<T>(topic, queue, …)`` of advertise and subscribe options."""
    if this.type.name == "ros::AdvertiseOptions":
        functions.fill_advertise(this, asked)
    else:
        functions.fill_subscribe(this, asked)
    return UNKNOWN


def _service_init(this: Thing, asked: Call) -> Value:
    callback = callback_of(asked, 1)
    kind = explicit(asked, service=True) or message_type(asked.machine, callback, asked.frame, service=True)
    this.fields["service"] = asked.machine.cell(asked.value(0))
    this.fields["datatype"] = asked.machine.cell(Text(kind))
    this.fields["<callback>"] = asked.machine.cell(callback)
    return UNKNOWN


def _topic(this: Thing, asked: Call) -> Value:
    cell = this.fields.get("<topic>")
    return cell.value if cell is not None else UNKNOWN


def _lazy_advertise(this: Thing, asked: Call) -> Value:
    return functions.lazily(asked) or UNKNOWN


def _lazy_camera(this: Thing, asked: Call) -> Value:
    first = asked.value(0)
    return _camera_advertise(_thing(asked, "", handle=first), asked._replace(arguments=asked.arguments[1:]))


def _lazy_image(this: Thing, asked: Call) -> Value:
    first = asked.value(0)
    return _image_advertise(_thing(asked, "", handle=first), asked._replace(arguments=asked.arguments[1:]))


def _plain(asked: Call) -> Value:
    return _thing(asked, asked.name)


def _text_stream(asked: Call) -> Value:
    return _thing(asked, asked.name, **{"<text>": asked.value(0) if isinstance(asked.value(0), Text) else Text("")})


STREAMS: dict[str, Does[[Call], Value]] = dict.fromkeys(
    ("stringstream", "std::stringstream", "std::ostringstream", "ostringstream"), _text_stream
)
"""Streams of the standard library, that names are written to."""

MAKERS: dict[str, Does[[Call], Value]] = {
    "ros::NodeHandle": _handle,
    "tf::TransformListener": _listener,
    "tf2_ros::TransformListener": _listener,
    "tf::TransformBroadcaster": _broadcaster,
    "tf2_ros::TransformBroadcaster": _broadcaster,
    "tf2_ros::StaticTransformBroadcaster": _static_broadcaster,
    "diagnostic_updater::Updater": _updater,
    "actionlib::SimpleActionServer": _action("server"),
    "actionlib::ActionServer": _action("server"),
    "actionlib::SimpleActionClient": _action("client"),
    "actionlib::ActionClient": _action("client"),
    "dynamic_reconfigure::Server": _reconfigure,
    "message_filters::Subscriber": _filter_subscriber,
    "image_transport::ImageTransport": _transport,
    "image_transport::SubscriberFilter": _image_filter,
    "image_transport::TransportHints": _hints,
    "camera_info_manager::CameraInfoManager": _info_manager,
    "realtime_tools::RealtimePublisher": _realtime_publisher,
    "interactive_markers::InteractiveMarkerServer": _markers,
    "self_test::TestRunner": _self_test,
    "controller_manager::ControllerManager": _controller_manager,
    "driver_base::DriverNode": driver_base.node,
    **loading.MAKERS,
    **STREAMS,
    **dict.fromkeys(
        (
            "boost::format",
            "ros::AdvertiseOptions",
            "ros::SubscribeOptions",
            "ros::AdvertiseServiceOptions",
            "urdf::Model",
            "filters::FilterChain",
        ),
        _plain,
    ),
}
"""What making an object of a class does."""

METHODS: dict[tuple[str, str], Does[[Thing, Call], Value]] = {
    **loading.METHODS,
    ("message_filters::Subscriber", "subscribe"): _filter_subscribe,
    ("image_transport::ImageTransport", "advertise"): _image_advertise,
    ("image_transport::ImageTransport", "advertiseCamera"): _camera_advertise,
    ("image_transport::ImageTransport", "subscribe"): _image_subscribe,
    ("image_transport::ImageTransport", "subscribeCamera"): _camera_subscribe,
    ("image_transport::SubscriberFilter", "subscribe"): _image_filter_subscribe,
    ("realtime_tools::RealtimePublisher", "init"): _realtime_init,
    ("urdf::Model", "initParam"): _description,
    ("filters::FilterChain", "configure"): _filter_chain,
    ("ros::AdvertiseOptions", "init"): _options_init,
    ("ros::SubscribeOptions", "init"): _options_init,
    ("ros::SubscribeOptions", "initByFullCallbackType"): _options_init,
    ("ros::AdvertiseServiceOptions", "init"): _service_init,
    ("ros::Publisher", "getTopic"): _topic,
    ("ros::Publisher", "getService"): _topic,
    ("image_transport::Publisher", "getTopic"): _topic,
    ("image_transport::Subscriber", "getTopic"): _topic,
    ("nodelet_topic_tools::NodeletLazy", "advertise"): _lazy_advertise,
    ("jsk_topic_tools::ConnectionBasedNodelet", "advertise"): _lazy_advertise,
    ("jsk_topic_tools::DiagnosticNodelet", "advertise"): _lazy_advertise,
    ("jsk_topic_tools::ConnectionBasedNodelet", "advertiseImage"): _lazy_image,
    ("jsk_topic_tools::ConnectionBasedNodelet", "advertiseCamera"): _lazy_camera,
    ("jsk_topic_tools::DiagnosticNodelet", "advertiseImage"): _lazy_image,
}
"""What a member of an object does."""

HARMLESS = frozenset(
    """std::vector std::map std::pair std::tuple ros::AsyncSpinner ros::Rate tf2_ros::Buffer tf2_ros::MessageFilter
    tf::MessageFilter""".split()
)
"""Classes that may be given a node handle and make no name with it."""

"""Classes of packages of ROS 2 that make names when they are made, and their members."""

from __future__ import annotations

from collections.abc import Callable as Does
from collections.abc import Sequence

from launchlint.extract.cpp.naming import template
from launchlint.extract.cpp.rclcpp import interface, nodes, params
from launchlint.extract.cpp.rclcpp.interface import node_at
from launchlint.extract.cpp.rclcpp.nodes import note
from launchlint.extract.cpp.rclcpp.qos import profile, qos_of
from launchlint.extract.cpp.ros.callbacks import callback_of, explicit
from launchlint.extract.cpp.ros.functions import sibling
from launchlint.extract.cpp.ros.handle import held, resolved
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import UNKNOWN, Either, Null, Number, Text, Thing, Value, choices, either, node_of
from launchlint.extract.fact import Qos

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call

_TF = "tf2_msgs/msg/TFMessage"
_IMAGE, _INFO = "sensor_msgs/msg/Image", "sensor_msgs/msg/CameraInfo"
_DEFAULT = Qos("reliable", "volatile", "keep_last", 10)
_OF_PLUGINS = "the plugins of image_transport declare params of their own"


def thing(asked: Call, name: str, **fields: Value) -> Thing:
    """An object of a library, with what is kept of it."""
    asked.machine.serial += 1
    made = Thing(Type(name, asked.types), None, asked.machine.serial)
    for key, value in fields.items():
        made.fields[key] = asked.machine.cell(value)
    return made


def _is_node(value: Value) -> bool:
    return any(node_of(each) is not None for _, each in choices(value))


def node_among(asked: Call) -> Value:
    """The node that is given, wherever; the first one of the program where none is known to be."""
    return next((each.value for each in asked.arguments if _is_node(each.value)), nodes.first_node(asked.machine))


# -- frames ---------------------------------------------------------------------------------------------------------------


def _buffer(asked: Call) -> Value:
    """``tf2_ros::Buffer(clock, time, node, qos)``: given a node it serves what it knows of the frames."""
    if any(_is_node(each.value) for each in asked.arguments[2:]):
        note(asked, node_among(asked), "services", Text("tf2_frames"), type="tf2_msgs/srv/FrameGraph")
    return thing(asked, asked.name)


def _listener(asked: Call) -> Value:
    """``tf2_ros::TransformListener(buffer, node, …)``: with or without a node of the program."""
    node = next((each.value for each in asked.arguments if _is_node(each.value)), nodes.first_node(asked.machine))
    for name, qos in (("/tf", _DEFAULT._replace(depth=100)), ("/tf_static", Qos("reliable", "transient_local", "keep_last", 100))):
        given = [qos_of(each.value) for each in asked.arguments]
        plain_qos = not any(each is not None for each in given)
        note(asked, node, "subscribers", Text(name), type=_TF, qos=qos if plain_qos else None)
    return thing(asked, asked.name)


def _broadcaster(name: str, qos: Qos) -> Does[[Call], Value]:
    def make(asked: Call) -> Value:
        given = qos_of(asked.value(1)) if len(asked.arguments) > 1 and not _is_node(asked.value(1)) else qos
        note(asked, node_at(asked, 0), "publishers", Text(name), type=_TF, qos=given)
        return thing(asked, asked.name)

    return make


# -- images ---------------------------------------------------------------------------------------------------------------


def _beside(name: Value) -> Value:
    """The camera info beside an image."""
    return either([(condition, Text(sibling(template(each)))) for condition, each in choices(name)])


def _publish_image(asked: Call, node: Value, topic: Value, qos: Value) -> Value:
    name = note(asked, node, "publishers", topic, type=_IMAGE, transport="image", qos=_qos_or_default(qos))
    asked.machine.doubt("params", _OF_PLUGINS, asked.node, asked.frame)
    return name


def _subscribe_image(asked: Call, node: Value, topic: Value, qos: Value) -> Value:
    return note(asked, node, "subscribers", topic, type=_IMAGE, transport="image", qos=_qos_or_default(qos))


def _qos_or_default(value: Value) -> Qos | None:
    return _DEFAULT if isinstance(value, Null) else qos_of(value)


def _given(asked: Call, position: int) -> Value:
    """An argument, or the default profile where it is left out."""
    return asked.value(position) if position < len(asked.arguments) else profile(_DEFAULT)


def _create_image_publisher(asked: Call) -> Value:
    """``image_transport::create_publisher(node, topic, qos, options)``."""
    name = _publish_image(asked, node_at(asked, 0), asked.value(1), _given(asked, 2))
    return thing(asked, "image_transport::Publisher", **{"<topic>": resolved(name)})


def _create_camera_publisher(asked: Call) -> Value:
    publisher = _create_image_publisher(asked)
    _info(asked, "publishers", node_at(asked, 0), asked.value(1), _given(asked, 2))
    return publisher


def _create_image_subscription(asked: Call) -> Value:
    """``image_transport::create_subscription(node, topic, callback, transport, qos, options)``."""
    name = _subscribe_image(asked, node_at(asked, 0), asked.value(1), _given(asked, 4))
    asked.machine.later(callback_of(asked, 2), "message")
    return thing(asked, "image_transport::Subscriber", **{"<topic>": resolved(name)})


def _create_camera_subscription(asked: Call) -> Value:
    subscriber = _create_image_subscription(asked)
    _info(asked, "subscribers", node_at(asked, 0), asked.value(1), _given(asked, 4))
    return subscriber


def _info(asked: Call, category: str, node: Value, topic: Value, qos: Value) -> None:
    note(asked, node, category, _beside(topic), type=_INFO, qos=_qos_or_default(qos))


def _transport(asked: Call) -> Value:
    return thing(asked, "image_transport::ImageTransport", node=node_at(asked, 0))


def _advertise(this: Thing, asked: Call) -> Value:
    """``ImageTransport::advertise(topic, queue, latch)`` or ``(topic, qos, latch)``."""
    name = _publish_image(asked, held(this, "node"), asked.value(0), asked.value(1))
    return thing(asked, "image_transport::Publisher", **{"<topic>": resolved(name)})


def _advertise_camera(this: Thing, asked: Call) -> Value:
    publisher = _advertise(this, asked)
    _info(asked, "publishers", held(this, "node"), asked.value(0), asked.value(1))
    return publisher


def _subscribe(this: Thing, asked: Call) -> Value:
    """``ImageTransport::subscribe(topic, queue, callback, hints)``."""
    name = _subscribe_image(asked, held(this, "node"), asked.value(0), asked.value(1))
    asked.machine.later(callback_of(asked, 2), "message")
    return thing(asked, "image_transport::Subscriber", **{"<topic>": resolved(name)})


def _subscribe_camera(this: Thing, asked: Call) -> Value:
    subscriber = _subscribe(this, asked)
    _info(asked, "subscribers", held(this, "node"), asked.value(0), asked.value(1))
    return subscriber


def _hints(asked: Call) -> Value:
    """``TransportHints(node, transport, param)``: the param says which transport it is."""
    default = asked.value(1) if len(asked.arguments) > 1 else Text("raw")
    name = asked.value(2) if len(asked.arguments) > 2 else Text("image_transport")
    value = params.declared(asked, node_at(asked, 0), name, default, UNKNOWN)
    return thing(asked, "image_transport::TransportHints", **{"<transport>": value})


def _transport_of_hints(this: Thing, asked: Call) -> Value:
    return held(this, "<transport>")


def _image_filter(asked: Call) -> Value:
    made = thing(asked, "image_transport::SubscriberFilter")
    if len(asked.arguments) > 1:
        _image_filter_subscribe(made, asked)
    return made


def _image_filter_subscribe(this: Thing, asked: Call) -> Value:
    """``SubscriberFilter::subscribe(node, topic, transport, qos)``."""
    _subscribe_image(asked, node_at(asked, 0), asked.value(1), _given(asked, 3))
    return UNKNOWN


def _interfaces(asked: Call) -> Value:
    """``RequiredInterfaces(node)``: stands for the node."""
    return asked.value(0)


def _nothing_yet(does: Does[[Call], Value], name: str) -> Does[[Call], Value]:
    """An object that is made with all it needs, or with nothing."""
    return lambda asked: does(asked) if asked.arguments else thing(asked, name)


def _info_manager(asked: Call) -> Value:
    """``CameraInfoManager(node, name, url, namespace)``: a service beside the images."""
    space = asked.value(3) if len(asked.arguments) > 3 and isinstance(asked.value(3), (Text, Either)) else Text("~")
    name = either([(condition, Text(f"{template(each)}/set_camera_info")) for condition, each in choices(space)])
    note(asked, node_at(asked, 0), "services", name, type="sensor_msgs/srv/SetCameraInfo")
    return thing(asked, asked.name)


# -- filters of messages --------------------------------------------------------------------------------------------------


def _filter(asked: Call) -> Value:
    made = thing(asked, "message_filters::Subscriber")
    if len(asked.arguments) > 1:
        _filter_subscribe(made, asked)
    return made


def _filter_subscribe(this: Thing, asked: Call) -> Value:
    """``Subscriber<T>::subscribe(node, topic, qos, options)``; without arguments again what it was before."""
    if not asked.arguments:
        return UNKNOWN
    kinds = asked._replace(types=this.type.arguments[:1])
    qos = nodes.qos_with(_qos_or_default(_given(asked, 2)), asked.value(3))
    note(asked, node_at(asked, 0), "subscribers", asked.value(1), type=explicit(kinds), qos=qos)
    return UNKNOWN


# -- other packages -------------------------------------------------------------------------------------------------------


def _updater(asked: Call) -> Value:
    """``diagnostic_updater::Updater(node, period)``."""
    node = node_at(asked, 0)
    default = asked.value(1) if isinstance(asked.value(1), Number) else Number(1.0)
    qos = _DEFAULT._replace(depth=1)
    note(asked, node, "publishers", Text("/diagnostics"), type="diagnostic_msgs/msg/DiagnosticArray", qos=qos)
    params.declared(asked._replace(types=(Type("double"),)), node, Text("diagnostic_updater.period"), default, UNKNOWN)
    params.declared(asked._replace(types=(Type("bool"),)), node, Text("diagnostic_updater.use_fqn"), Number(False), UNKNOWN)
    return thing(asked, asked.name)


def _markers(asked: Call) -> Value:
    """``InteractiveMarkerServer(namespace, node, …)``."""
    node = node_among(asked)
    for category, end, kind in (
        ("publishers", "update", "msg/InteractiveMarkerUpdate"),
        ("subscribers", "feedback", "msg/InteractiveMarkerFeedback"),
        ("services", "get_interactive_markers", "srv/GetInteractiveMarkers"),
    ):
        name = either([(condition, Text(f"{template(each)}/{end}")) for condition, each in choices(asked.value(0))])
        note(asked, node, category, name, type=f"visualization_msgs/{kind}")
    return thing(asked, asked.name)


def _self_test(asked: Call) -> Value:
    note(asked, node_among(asked), "services", Text("~/self_test"), type="diagnostic_msgs/srv/SelfTest")
    return thing(asked, asked.name)


def _bond(asked: Call) -> Value:
    """``bond::Bond(topic, id, node, …)``."""
    for category in ("publishers", "subscribers"):
        note(asked, node_among(asked), category, asked.value(0), type="bond/msg/Status")
    return thing(asked, asked.name)


# -- nav2_util ------------------------------------------------------------------------------------------------------------


def _nav2_node(asked: Call) -> Value:
    """``nav2_util::LifecycleNode(name, namespace, options)``."""
    value = nodes.maker(lifecycle=True)(asked)
    params.declared(asked._replace(types=(Type("double"),)), value, Text("bond_heartbeat_period"), Number(0.1), UNKNOWN)
    return value


def _create_bond(handle: Value, asked: Call) -> Value:
    """``createBond()`` of a node of nav2_util: the bond to its lifecycle manager, which it keeps until ``destroyBond()``."""
    for category in ("publishers", "subscribers"):
        note(asked, handle, category, Text("bond"), type="bond/msg/Status")
    return UNKNOWN


def _simple_server(asked: Call) -> Value:
    """``SimpleActionServer<T>(node, name, execute, …)``."""
    interface.action("server")(asked)
    return thing(asked, asked.name)


def _service_client(asked: Call) -> Value:
    """``ServiceClient<T>(name, node)``."""
    note(asked, node_among(asked), "clients", asked.value(0), type=explicit(asked, service=True))
    return thing(asked, asked.name)


def _add_parameter(handle: Value, asked: Call) -> Value:
    """``add_parameter(name, default, description, …)`` of a node of nav2_util."""
    return params.declared(asked._replace(types=()), handle, asked.value(0), asked.value(1), UNKNOWN)


def _declare_unless_declared(asked: Call) -> Value:
    """``declare_parameter_if_not_declared(node, name, default or type, descriptor)``."""
    rest: Sequence[Value] = [each.value for each in asked.arguments[1:]]
    name, default, descriptor = (*rest, UNKNOWN, UNKNOWN, UNKNOWN)[:3]
    return params.declared(asked._replace(arguments=asked.arguments[1:], types=()), node_at(asked, 0), name, default, descriptor)


def _declare_or_get(asked: Call) -> Value:
    """``declare_or_get_parameter(node, name, default)``."""
    rest = asked._replace(arguments=asked.arguments[1:])
    return params.declared(rest, node_at(asked, 0), rest.value(0), rest.value(1), UNKNOWN, len(rest.arguments) > 1)


MAKERS: dict[str, Does[[Call], Value]] = {
    "tf2_ros::Buffer": _buffer,
    "tf2_ros::TransformListener": _listener,
    "tf2_ros::TransformBroadcaster": _broadcaster("/tf", _DEFAULT._replace(depth=100)),
    "tf2_ros::StaticTransformBroadcaster": _broadcaster("/tf_static", Qos("reliable", "transient_local", "keep_last", 1)),
    "image_transport::ImageTransport": _transport,
    "image_transport::TransportHints": _hints,
    "image_transport::SubscriberFilter": _image_filter,
    "image_transport::Publisher": _nothing_yet(_create_image_publisher, "image_transport::Publisher"),
    "image_transport::CameraPublisher": _nothing_yet(_create_camera_publisher, "image_transport::Publisher"),
    "image_transport::Subscriber": _nothing_yet(_create_image_subscription, "image_transport::Subscriber"),
    "image_transport::CameraSubscriber": _nothing_yet(_create_camera_subscription, "image_transport::Subscriber"),
    **dict.fromkeys(
        (
            f"{name}::RequiredInterfaces"
            for name in (
                "image_transport",
                "tf2_ros::TransformBroadcaster",
                "tf2_ros::StaticTransformBroadcaster",
                "tf2_ros::TransformListener",
                "message_filters",
            )
        ),
        _interfaces,
    ),
    "camera_info_manager::CameraInfoManager": _info_manager,
    "message_filters::Subscriber": _filter,
    "diagnostic_updater::Updater": _updater,
    "interactive_markers::InteractiveMarkerServer": _markers,
    "self_test::TestRunner": _self_test,
}
STANDINS: dict[str, Does[[Call], Value]] = {
    "bond::Bond": _bond,
    **{f"{space}::LifecycleNode": _nav2_node for space in ("nav2_util", "nav2", "nav2_ros_common")},
    **{f"{space}::SimpleActionServer": _simple_server for space in ("nav2_util", "nav2", "nav2_ros_common")},
    "nav2_util::ServiceClient": _service_client,
}
FUNCTIONS: dict[str, Does[[Call], Value | None]] = {
    "image_transport::create_publisher": _create_image_publisher,
    "image_transport::create_subscription": _create_image_subscription,
    "image_transport::create_camera_publisher": _create_camera_publisher,
    "image_transport::create_camera_subscription": _create_camera_subscription,
    "image_transport::getCameraInfoTopic": lambda asked: _beside(asked.value(0)),
    **{f"{space}::declare_parameter_if_not_declared": _declare_unless_declared for space in ("nav2_util", "nav2")},
    **{f"{space}::declare_or_get_parameter": _declare_or_get for space in ("nav2_util", "nav2")},
}
METHODS: dict[tuple[str, str], Does[[Thing, Call], Value]] = {
    ("message_filters::Subscriber", "subscribe"): _filter_subscribe,
    ("image_transport::ImageTransport", "advertise"): _advertise,
    ("image_transport::ImageTransport", "advertiseCamera"): _advertise_camera,
    ("image_transport::ImageTransport", "subscribe"): _subscribe,
    ("image_transport::ImageTransport", "subscribeCamera"): _subscribe_camera,
    ("image_transport::SubscriberFilter", "subscribe"): _image_filter_subscribe,
    ("image_transport::TransportHints", "getTransport"): _transport_of_hints,
    ("image_transport::Publisher", "getTopic"): lambda this, asked: held(this, "<topic>"),
    ("image_transport::Subscriber", "getTopic"): lambda this, asked: held(this, "<topic>"),
}
OF_HANDLE = {"add_parameter": _add_parameter, "createBond": _create_bond}
HARMLESS = frozenset(
    """std::vector std::map std::pair std::tuple std::set std::shared_ptr std::weak_ptr rclcpp::Rate rclcpp::WallRate tf2_ros::MessageFilter
    rclcpp::executors::SingleThreadedExecutor rclcpp::executors::MultiThreadedExecutor rclcpp::TimeSource rclcpp::GraphListener
    tf2_ros::CreateTimerROS rclcpp::ParameterEventHandler rclcpp::ParameterEventsFilter rclcpp::node_interfaces::NodeInterfaces
    rclcpp::WaitSet rclcpp::ParameterCallbackHandle rclcpp::Clock rclcpp::Logger""".split()
)
"""Classes that may be given a node and make no name with it."""

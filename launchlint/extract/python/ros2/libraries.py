"""What is called with a node, of rclpy and of the packages around it, and the names that it makes there."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from launchlint.extract.fact import Qos
from launchlint.extract.python import command_line, libraries
from launchlint.extract.python.arguments import Call
from launchlint.extract.python.dialect import Handler, Method
from launchlint.extract.python.outside import MessageClass
from launchlint.extract.python.ros2 import described, nodes, params, qos
from launchlint.extract.python.ros2.api import quiet
from launchlint.python import standard
from launchlint.python.text import joined
from launchlint.python.values import MISSING, UNKNOWN, Argv, Handle, Value

_TF = "tf2_msgs/msg/TFMessage"
_KEPT = Qos("reliable", "volatile", "keep_last")
_LATCHED = Qos("reliable", "transient_local", "keep_last")


def _later(made: Call, *values: Value) -> None:
    made.run.escape(values, "message")


def _qos(made: Call, value: Value, otherwise: Qos) -> Qos | None:
    return otherwise if value is None or value is MISSING else qos.qos_of(value)


def _create_node(made: Call) -> Value:
    node = Handle("node", {})
    nodes.construct(made.run, node, made, lifecycle=False)  # type: ignore[arg-type]
    return node


def _action_server(made: Call) -> Value:
    for key in nodes.keys(made, made.get(0, "node")):
        made.fact("actions", made.get(2, "action_name"), type=made.get(1, "action_type", ""), role="server", node=key)
    _later(made, *made.positional[3:], *(value for name, value in made.keywords.items() if name != "node"))
    return Handle("action", {})


def _action_client(made: Call) -> Value:
    for key in nodes.keys(made, made.get(0, "node")):
        made.fact("actions", made.get(2, "action_name"), type=made.get(1, "action_type", ""), role="client", node=key)
    return Handle("client", {})


def _wait_for_message(made: Call) -> Value:
    for key in nodes.keys(made, made.get(1, "node")):
        said = qos.qos_of(made.keywords.get("qos_profile", 1))
        made.fact("subscribers", made.get(2, "topic"), type=made.get(0, "msg_type", ""), qos=said, node=key)
    return UNKNOWN


def _parameter_client(made: Call) -> Value:
    remote = made.get(1, "remote_node_name")
    for key in nodes.keys(made, made.get(0, "node")):
        for word in (
            "GetParameters",
            "ListParameters",
            "SetParameters",
            "GetParameterTypes",
            "DescribeParameters",
            "SetParametersAtomically",
        ):
            name = "".join(f"_{char.lower()}" if char.isupper() else char for char in word).lstrip("_")
            made.fact("clients", joined([remote, f"/{name}"]), type=f"rcl_interfaces/srv/{word}", node=key)
    return Handle("client", {})


def _tf_listener(made: Call) -> Value:
    # tf2_ros.transform_listener: both topics, absolute
    for key in nodes.keys(made, made.get(1, "node")):
        for topic, given, usual in (("tf", "qos", _KEPT), ("tf_static", "static_qos", _LATCHED)):
            name = made.keywords.get(f"{topic}_topic", f"/{topic}")
            said = _qos(made, made.keywords.get(given), usual._replace(depth=100))
            made.fact("subscribers", name, type=_TF, qos=said, node=key)
    return quiet()


def _tf_broadcaster(made: Call) -> Value:
    for key in nodes.keys(made, made.get(0, "node")):
        made.fact("publishers", "/tf", type=_TF, qos=_qos(made, made.get(1, "qos"), _KEPT._replace(depth=100)), node=key)
    return quiet()


def _static_broadcaster(made: Call) -> Value:
    for key in nodes.keys(made, made.get(0, "node")):
        made.fact("publishers", "/tf_static", type=_TF, qos=_qos(made, made.get(1, "qos"), _LATCHED._replace(depth=1)), node=key)
    return quiet()


def _buffer(made: Call) -> Value:
    # tf2_ros.buffer: it serves the frames where it is given a node
    node = made.get(1, "node", None)
    for key in nodes.keys(made, node) if node is not None else ():
        made.fact("services", "tf2_frames", type="tf2_msgs/srv/FrameGraph", node=key)
    return Handle("client", {})


def _buffer_client(made: Call) -> Value:
    for key in nodes.keys(made, made.get(0, "node")):
        made.fact("actions", made.get(1, "ns"), type="tf2_msgs/action/LookupTransform", role="client", node=key)
    return quiet()


def _filtered(made: Call) -> Value:
    # message_filters.Subscriber: node, type, topic, and then as create_subscription, with a depth of 10
    for key in nodes.keys(made, made.get(0, "node")):
        said = qos.qos_of(made.keywords.get("qos_profile", 10), made.keywords.get("qos_overriding_options"))
        made.fact("subscribers", made.get(2, "topic"), type=made.get(1, "msg_type", ""), qos=said, node=key)
    return Handle("filter", {})


def _filter(made: Call) -> Value:
    return Handle("filter", {})


def _register(receiver: Handle, made: Call) -> Value:
    _later(made, *made.positional)
    return UNKNOWN


def _updater(made: Call) -> Value:
    # diagnostic_updater.Updater.__init__
    for key in nodes.keys(made, made.get(0, "node")):
        said = Qos("reliable", "volatile", "keep_last", 1)
        made.fact("publishers", "/diagnostics", type="diagnostic_msgs/msg/DiagnosticArray", qos=said, node=key)
        for name, default, type_ in (("period", 1.0, "double"), ("use_fqn", False, "bool")):
            made.fact("params", f"diagnostic_updater.{name}", default=default, value_type=type_, declared=True, node=key)
    return Handle("updater", {})


def _markers(made: Call) -> Value:
    # interactive_markers.interactive_marker_server.InteractiveMarkerServer.__init__
    start = made.get(1, "namespace")
    for key in nodes.keys(made, made.get(0, "node")):
        made.fact(
            "publishers",
            joined([start, "/update"]),
            type="visualization_msgs/msg/InteractiveMarkerUpdate",
            qos=_qos(made, made.keywords.get("update_pub_qos"), _KEPT._replace(depth=100)),
            node=key,
        )
        made.fact(
            "subscribers",
            joined([start, "/feedback"]),
            type="visualization_msgs/msg/InteractiveMarkerFeedback",
            qos=_qos(made, made.keywords.get("feedback_sub_qos"), _KEPT._replace(depth=1)),
            node=key,
        )
        type_ = "visualization_msgs/srv/GetInteractiveMarkers"
        made.fact("services", joined([start, "/get_interactive_markers"]), type=type_, node=key)
    return Handle("markers", {})


def _moveit(made: Call) -> Value:
    # moveit.planning.MoveItPy makes a node of its own, in C++
    nodes.construct(made.run, Handle("node", {}), made, lifecycle=False)  # type: ignore[arg-type]
    made.doubt("it uses MoveIt, which makes names for itself")
    return quiet()


def _basic_navigator(made: Call) -> Value:
    node = Handle("node", {})
    navigator(made, node)
    return node


def navigator(made: Call, node: Value) -> None:
    """``BasicNavigator(node_name='basic_navigator', namespace='')``, of which each release has more actions and services than the last."""
    nodes.construct(made.run, node, made, lifecycle=False, name="basic_navigator")  # type: ignore[arg-type]
    known = made.run.nodes.of(node)  # type: ignore[attr-defined]
    key = "" if known is None else known.made.key
    pose = "geometry_msgs/msg/PoseWithCovarianceStamped"
    made.fact("publishers", "initialpose", type=pose, qos=_KEPT._replace(depth=10), node=key)
    made.fact("subscribers", "amcl_pose", type=pose, qos=_LATCHED._replace(depth=1), node=key)
    for name, type_ in (("navigate_to_pose", "NavigateToPose"), ("follow_waypoints", "FollowWaypoints")):
        made.fact("actions", name, type=f"nav2_msgs/action/{type_}", role="client", node=key)
    made.doubt("it is a navigator of nav2_simple_commander, which has other ones in each release", ("clients", "actions"))


def _interface(kind: str) -> Callable[[Call], Value]:
    def handle(made: Call) -> Value:
        name = made.get(0, "identifier")
        parts = name.split("/") if isinstance(name, str) else []
        known = (len(parts) == 2 and kind) or (len(parts) == 3 and parts[1] in ("msg", "srv", "action"))
        return MessageClass(f"{parts[0]}/{parts[1] if len(parts) == 3 else kind}/{parts[-1]}") if known else UNKNOWN

    return handle


def _executor(made: Call) -> Value:
    return Handle("executor", {})


def _quiet(made: Call) -> Value:
    return quiet()


def _nothing(made: Call) -> Value:
    return None


def _arguments(made: Call) -> Value:
    given = made.get(0, "args", None)
    return given if isinstance(given, Argv) else Argv(0)


def _asked(receiver: Handle, made: Call) -> Value:
    """A call whose answer comes later."""
    _later(made, *made.positional, *made.keywords.values())
    return Handle("future", {})


def _starts(receiver: Handle, made: Call) -> Value:
    made.run.escape([*made.positional, *made.keywords.values()], "start")
    return Handle("future", {})


def _ignored(receiver: Handle, made: Call) -> Value:
    return UNKNOWN


_ACTION_SERVER = ("rclpy.action.ActionServer", "rclpy.action.server.ActionServer")
_ACTION_CLIENT = ("rclpy.action.ActionClient", "rclpy.action.client.ActionClient")
_EXECUTORS = ("SingleThreadedExecutor", "MultiThreadedExecutor", "Executor")
_DESCRIBING = ("ParameterDescriptor", "FloatingPointRange", "IntegerRange")

MAKING: Mapping[str, Handler] = {
    "rclpy.create_node": _create_node,
    **dict.fromkeys(_ACTION_SERVER, _action_server),
    **dict.fromkeys(_ACTION_CLIENT, _action_client),
    "rclpy.wait_for_message.wait_for_message": _wait_for_message,
    "rclpy.parameter_client.AsyncParameterClient": _parameter_client,
    "tf2_ros.TransformListener": _tf_listener,
    "tf2_ros.TransformBroadcaster": _tf_broadcaster,
    "tf2_ros.StaticTransformBroadcaster": _static_broadcaster,
    "tf2_ros.Buffer": _buffer,
    "tf2_ros.BufferClient": _buffer_client,
    "message_filters.Subscriber": _filtered,
    "diagnostic_updater.Updater": _updater,
    "interactive_markers.InteractiveMarkerServer": _markers,
    "moveit.planning.MoveItPy": _moveit,
    "nav2_simple_commander.robot_navigator.BasicNavigator": _basic_navigator,
}
"""What makes names when it is called."""

HANDLERS: Mapping[str, Handler] = {
    **standard.HANDLERS,
    **command_line.HANDLERS,
    **MAKING,
    "message_filters.TimeSynchronizer": _filter,
    "message_filters.ApproximateTimeSynchronizer": _filter,
    "message_filters.Cache": _filter,
    "rclpy.qos.QoSProfile": qos.profile,
    "rclpy.qos.QoSPresetProfiles.get_from_short_key": qos.by_short_key,
    "rclpy.duration.Duration": qos.duration,
    "rclpy.parameter.Parameter": params.parameter,
    **{f"rcl_interfaces.msg.{each}": params.message for each in _DESCRIBING},
    **{f"rclpy.executors.{each}": _executor for each in _EXECUTORS},
    "rclpy.get_global_executor": _executor,
    "rclpy.init": _nothing,
    "rclpy.shutdown": _nothing,
    "rclpy.try_shutdown": _nothing,
    "rclpy.spin": _nothing,
    "rclpy.spin_once": _nothing,
    "rclpy.spin_until_future_complete": _nothing,
    "rclpy.logging.get_logger": _quiet,
    "rclpy.utilities.remove_ros_args": _arguments,
    "rosidl_runtime_py.utilities.get_message": _interface("msg"),
    "rosidl_runtime_py.utilities.get_service": _interface("srv"),
    "rosidl_runtime_py.utilities.get_action": _interface("action"),
    "rosidl_runtime_py.utilities.get_interface": _interface("msg"),
    "rqt_gui.main.Main": libraries.HANDLERS["rqt_gui.main.Main"],
}

METHODS: Mapping[tuple[str, str], Method] = {
    **command_line.METHODS,
    ("rqt", "main"): libraries.METHODS["rqt", "main"],
    ("parameter", "get_parameter_value"): params.as_message,
    ("filter", "registerCallback"): _register,
    **{("client", name): _asked for name in ("call_async", "send_goal_async", "wait_for_transform_async", "lookup_transform_async")},
    ("future", "add_done_callback"): _asked,
    ("executor", "create_task"): _starts,
    ("listener", "get_params"): described.params_of,
    **{("updater", name): _starts for name in ("add", "broadcast")},
}

"""The names that ROS libraries for Python make: tf, tf2, actionlib, dynamic_reconfigure, diagnostics, smach, interactive markers."""

from __future__ import annotations

import re

from launchlint.extract.python.arguments import Call
from launchlint.python.text import distribute, joined, template, text
from launchlint.python.values import MISSING, UNKNOWN, External, Handle, Instance, Value, alternatives

_CONFIGURATION = re.compile(r"(\w+)\.cfg\.(\w+?)(?:Config)?")

_TF = "tf2_msgs/TFMessage"


def _tf_listener(made: Call) -> Value:
    # tf2_ros.transform_listener: both topics, absolute
    made.fact("subscribers", "/tf", type=_TF)
    made.fact("subscribers", "/tf_static", type=_TF)
    return Handle("plain", {})


def _tf_broadcaster(made: Call) -> Value:
    made.fact("publishers", "/tf", type=_TF, queue=100)
    return Handle("plain", {})


def _static_broadcaster(made: Call) -> Value:
    made.fact("publishers", "/tf_static", type=_TF, latched=True, queue=100)
    return Handle("plain", {})


def _buffer(made: Call) -> Value:
    # tf2_ros.buffer: debug=True serves the frames
    if made.get(1, "debug", True) is not False:
        made.fact("services", "~tf2_frames", type="tf2_msgs/FrameGraph")
    return Handle("plain", {})


def _buffer_client(made: Call) -> Value:
    made.fact("actions", made.get(0, "ns"), type="tf2_msgs/LookupTransformAction", role="client")
    return Handle("plain", {})


def _buffer_server(made: Call) -> Value:
    made.fact("actions", made.get(1, "ns"), type="tf2_msgs/LookupTransformAction", role="server")
    return Handle("plain", {})


def _action_server(made: Call) -> Value:
    made.fact("actions", made.get(0, "name"), type=made.get(1, "ActionSpec", ""), role="server")
    made.run.escape([*made.positional[2:], *made.keywords.values()], "message")
    return Handle("action", {})


def _action_client(made: Call) -> Value:
    made.fact("actions", made.get(0, "ns"), type=made.get(1, "ActionSpec", ""), role="client")
    return Handle("action", {})


def _reconfigure_server(made: Call) -> Value:
    # dynamic_reconfigure.server.Server.__init__
    def start(given: Value) -> Value:
        spelled = template(given)
        if spelled in ("", "~", "None"):
            return "~"
        spelled = spelled if spelled.startswith(("/", "~")) else "~" + spelled
        return text((spelled + "/").replace("//", "/"))

    namespace = distribute(start, made.get(2, "namespace", ""))
    made.fact(
        "publishers",
        joined([namespace, "parameter_descriptions"]),
        type="dynamic_reconfigure/ConfigDescription",
        latched=True,
        queue=10,
    )
    made.fact("publishers", joined([namespace, "parameter_updates"]), type="dynamic_reconfigure/Config", latched=True, queue=10)
    made.fact("services", joined([namespace, "set_parameters"]), type="dynamic_reconfigure/Reconfigure")
    made.run.escape([made.get(1, "callback", None)], "message")
    for _, each in alternatives(made.get(0, "type", UNKNOWN)):
        match = _CONFIGURATION.fullmatch(each.name) if isinstance(each, External) else None
        made.run.configuration(match[1] if match else "", match[2] if match else "", namespace, made)
    return Handle("plain", {})


def _reconfigure_client(made: Call) -> Value:
    # dynamic_reconfigure.client.Client.__init__
    name = made.get(0, "name")
    made.fact("clients", joined([name, "/set_parameters"]), type="dynamic_reconfigure/Reconfigure")
    made.fact("subscribers", joined([name, "/parameter_descriptions"]), type="dynamic_reconfigure/ConfigDescription")
    made.fact("subscribers", joined([name, "/parameter_updates"]), type="dynamic_reconfigure/Config")
    made.run.escape([*made.positional[1:], *made.keywords.values()], "message")
    return Handle("plain", {})


def _updater(made: Call) -> Value:
    made.fact("publishers", "/diagnostics", type="diagnostic_msgs/DiagnosticArray", queue=1)
    made.fact("params", "~diagnostic_period", default=1, value_type="double")
    return Handle("updater", {})


def _diagnosed(made: Call) -> Value:
    made.run.escape([*made.positional, *made.keywords.values()], "start")
    return UNKNOWN


def _action_state(made: Call) -> Value:
    made.fact("actions", made.get(0, "action_name"), type=made.get(1, "action_spec", ""), role="client")
    return Handle("plain", {})


def _service_state(made: Call) -> Value:
    made.fact("clients", made.get(0, "service_name"), type=made.get(1, "service_spec", ""))
    return Handle("plain", {})


def _monitor_state(made: Call) -> Value:
    made.fact("subscribers", made.get(0, "topic"), type=made.get(1, "msg_type", ""), when="message")
    return Handle("plain", {})


def _action_wrapper(made: Call) -> Value:
    made.fact("actions", made.get(0, "server_name"), type=made.get(1, "action_spec", ""), role="server")
    return Handle("plain", {})


def _introspection(made: Call) -> Value:
    # smach_ros.introspection: one set of topics for each container, below the path it has in the machine
    name = made.get(0, "server_name")
    for ending, category, type_, latched in (
        ("container_structure", "publishers", "SmachContainerStructure", False),
        ("container_status", "publishers", "SmachContainerStatus", True),
        ("container_init", "subscribers", "SmachContainerInitialStatusCmd", False),
    ):
        made.fact(category, joined([name, f"/smach/{ending}"]), type=f"smach_msgs/{type_}", **({"latched": latched} if latched else {}))
    return Handle("plain", {})


def _marker_server(made: Call) -> Value:
    # interactive_markers.interactive_marker_server.InteractiveMarkerServer.__init__
    name = made.get(0, "topic_ns")
    made.fact("publishers", joined([name, "/update"]), type="visualization_msgs/InteractiveMarkerUpdate", queue=100)
    made.fact("publishers", joined([name, "/update_full"]), type="visualization_msgs/InteractiveMarkerInit", latched=True, queue=100)
    made.fact("subscribers", joined([name, "/feedback"]), type="visualization_msgs/InteractiveMarkerFeedback", queue=1)
    return Handle("markers", {})


def _callbacks(receiver: Handle, made: Call) -> Value:
    made.run.escape([*made.positional, *made.keywords.values()], "message")
    return UNKNOWN


def _checks(receiver: Handle, made: Call) -> Value:
    made.run.escape([*made.positional, *made.keywords.values()], "start")
    for each in made.positional:
        if isinstance(each, Instance):
            method = made.run.attribute(each, "run", made.node, made.scope)
            made.run.escape([method], "start")
    return UNKNOWN


def _rqt(made: Call) -> Value:
    return Handle("rqt", {})


def _rqt_main(receiver: Handle, made: Call) -> Value:
    made.run.plugin(made.get(1, "standalone", UNKNOWN), made)
    return UNKNOWN


def _camera_info(made: Call) -> Value:
    # camera_info_manager.CameraInfoManager.__init__
    made.fact("services", joined([made.get(2, "namespace", ""), "set_camera_info"]), type="sensor_msgs/SetCameraInfo")
    return Handle("plain", {})


def _bond(made: Call) -> Value:
    # bondpy.bondpy.Bond.__init__
    made.fact("publishers", made.get(0, "topic"), type="bond/Status")
    made.fact("subscribers", made.get(0, "topic"), type="bond/Status")
    made.run.escape([*made.positional[2:], *made.keywords.values()], "message")
    return Handle("plain", {})


def generator(made: Call) -> Value:
    """The ParameterGenerator of a ``.cfg`` file."""
    return Handle("generator", {"params": []})


def _add_param(receiver: Handle, made: Call) -> Value:
    name = made.get(0, "name")
    made.run.configured(name, made.get(1, "paramtype", UNKNOWN), made.get(4, "default", MISSING), made)
    return UNKNOWN


def _add_group(receiver: Handle, made: Call) -> Value:
    return receiver


def _enumeration(receiver: Handle, made: Call) -> Value:
    return "enum"


def _constant(receiver: Handle, made: Call) -> Value:
    return made.get(2, "value", UNKNOWN)


_ROOMS = ("dynamic_reconfigure.parameter_generator_catkin", "dynamic_reconfigure.parameter_generator", "driver_base.parameter_generator")

HANDLERS = {
    "tf.TransformListener": _tf_listener,
    "tf.TransformBroadcaster": _tf_broadcaster,
    "tf2_ros.TransformListener": _tf_listener,
    "tf2_ros.TransformBroadcaster": _tf_broadcaster,
    "tf2_ros.StaticTransformBroadcaster": _static_broadcaster,
    "tf2_ros.Buffer": _buffer,
    "tf2_ros.BufferClient": _buffer_client,
    "tf2_ros.BufferServer": _buffer_server,
    "actionlib.SimpleActionServer": _action_server,
    "actionlib.ActionServer": _action_server,
    "actionlib.SimpleActionClient": _action_client,
    "actionlib.ActionClient": _action_client,
    "dynamic_reconfigure.server.Server": _reconfigure_server,
    "dynamic_reconfigure.client.Client": _reconfigure_client,
    "diagnostic_updater.Updater": _updater,
    "diagnostic_updater.HeaderlessTopicDiagnostic": _diagnosed,
    "diagnostic_updater.TopicDiagnostic": _diagnosed,
    "diagnostic_updater.DiagnosedPublisher": _diagnosed,
    "smach_ros.SimpleActionState": _action_state,
    "smach_ros.ServiceState": _service_state,
    "smach_ros.MonitorState": _monitor_state,
    "smach_ros.IntrospectionServer": _introspection,
    "smach_ros.ActionServerWrapper": _action_wrapper,
    "rqt_gui.main.Main": _rqt,
    "camera_info_manager.CameraInfoManager": _camera_info,
    "bondpy.Bond": _bond,
    "bondpy.bondpy.Bond": _bond,
    "interactive_markers.interactive_marker_server.InteractiveMarkerServer": _marker_server,
    "interactive_markers.InteractiveMarkerServer": _marker_server,
    **{f"{room}.ParameterGenerator": generator for room in _ROOMS},
}

METHODS = {
    ("action", "register_goal_callback"): _callbacks,
    ("action", "register_preempt_callback"): _callbacks,
    ("action", "send_goal"): _callbacks,
    ("rqt", "main"): _rqt_main,
    ("updater", "add"): _checks,
    ("markers", "insert"): _callbacks,
    ("markers", "setCallback"): _callbacks,
    ("generator", "add"): _add_param,
    ("generator", "add_group"): _add_group,
    ("generator", "enum"): _enumeration,
    ("generator", "const"): _constant,
}

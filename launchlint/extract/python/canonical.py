"""One name for each thing of ROS that Python modules give out, and the message classes among them."""

from __future__ import annotations

import re

from launchlint.extract.python.outside import MessageClass
from launchlint.python.values import External, Value

_ROSPY_ROOMS = re.compile(r"rospy\.(?:topics|client|core|names|service|timer|rostime|exceptions|impl\.[a-z_]+|msg|numpy_msg)\.")
_GENERATED = re.compile(r"(\w+)\.(?:msg|srv|action)\.(?:_\w+\.)?([A-Za-z]\w*)")


def canonical(name: str) -> str:
    """One name for what a module gives out under several."""
    name = _ROSPY_ROOMS.sub("rospy.", name)
    return _ALIASES.get(name, name)


_ALIASES = {
    "actionlib.simple_action_server.SimpleActionServer": "actionlib.SimpleActionServer",
    "actionlib.simple_action_client.SimpleActionClient": "actionlib.SimpleActionClient",
    "actionlib.action_server.ActionServer": "actionlib.ActionServer",
    "actionlib.action_client.ActionClient": "actionlib.ActionClient",
    "tf.listener.TransformListener": "tf.TransformListener",
    "tf.broadcaster.TransformBroadcaster": "tf.TransformBroadcaster",
    "tf2_ros.buffer.Buffer": "tf2_ros.Buffer",
    "tf2_ros.transform_listener.TransformListener": "tf2_ros.TransformListener",
    "tf2_ros.transform_broadcaster.TransformBroadcaster": "tf2_ros.TransformBroadcaster",
    "tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster": "tf2_ros.StaticTransformBroadcaster",
    "tf2_ros.buffer_client.BufferClient": "tf2_ros.BufferClient",
    "tf2_ros.buffer_server.BufferServer": "tf2_ros.BufferServer",
    "smach_ros.simple_action_state.SimpleActionState": "smach_ros.SimpleActionState",
    "smach_ros.service_state.ServiceState": "smach_ros.ServiceState",
    "smach_ros.monitor_state.MonitorState": "smach_ros.MonitorState",
    "smach_ros.introspection.IntrospectionServer": "smach_ros.IntrospectionServer",
    "smach_ros.action_server_wrapper.ActionServerWrapper": "smach_ros.ActionServerWrapper",
    "dynamic_reconfigure.Server": "dynamic_reconfigure.server.Server",
    "dynamic_reconfigure.Client": "dynamic_reconfigure.client.Client",
    "diagnostic_updater._diagnostic_updater.Updater": "diagnostic_updater.Updater",
    "roslib.names.ns_join": "rosgraph.names.ns_join",
    "rospy.ns_join": "rosgraph.names.ns_join",
}


def message_class(value: Value) -> str:
    """The type that a message, service or action class stands for; empty where it is not known."""
    if isinstance(value, MessageClass):
        return value.type
    if isinstance(value, External):
        name = canonical(value.name)
        if name == "rospy.AnyMsg":
            return "*"
        match = _GENERATED.fullmatch(name)
        if match is not None:
            return f"{match[1]}/{match[2]}"
    return ""

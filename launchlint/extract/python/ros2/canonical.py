"""One name for each thing that the modules of rclpy and the packages around it give out."""

from __future__ import annotations

_ALIASES = {
    "rclpy.Node": "rclpy.node.Node",
    "rclpy.lifecycle.LifecycleNode": "rclpy.lifecycle.Node",
    "rclpy.lifecycle.node.LifecycleNode": "rclpy.lifecycle.Node",
    "rclpy.lifecycle.node.Node": "rclpy.lifecycle.Node",
    "rclpy.lifecycle.node.LifecycleNodeMixin": "rclpy.lifecycle.LifecycleNodeMixin",
    "rclpy.Parameter": "rclpy.parameter.Parameter",
    "rclpy.node.Parameter": "rclpy.parameter.Parameter",
    "rclpy.action.server.ActionServer": "rclpy.action.ActionServer",
    "rclpy.action.client.ActionClient": "rclpy.action.ActionClient",
    "rclpy.node.get_logger": "rclpy.logging.get_logger",
    "rclpy.qos.Duration": "rclpy.duration.Duration",
    "rclpy.time.Duration": "rclpy.duration.Duration",
    "tf2_ros.buffer.Buffer": "tf2_ros.Buffer",
    "tf2_ros.buffer_client.BufferClient": "tf2_ros.BufferClient",
    "tf2_ros.transform_listener.TransformListener": "tf2_ros.TransformListener",
    "tf2_ros.transform_broadcaster.TransformBroadcaster": "tf2_ros.TransformBroadcaster",
    "tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster": "tf2_ros.StaticTransformBroadcaster",
    "diagnostic_updater._diagnostic_updater.Updater": "diagnostic_updater.Updater",
    "interactive_markers.interactive_marker_server.InteractiveMarkerServer": "interactive_markers.InteractiveMarkerServer",
    "nav2_simple_commander.BasicNavigator": "nav2_simple_commander.robot_navigator.BasicNavigator",
    "rosidl_runtime_py.get_message": "rosidl_runtime_py.utilities.get_message",
    "rosidl_runtime_py.get_service": "rosidl_runtime_py.utilities.get_service",
}
_CLASSES = {name: goal for name, goal in _ALIASES.items() if goal.startswith("rclpy.")}
_IN_QOS = tuple(f"rclpy.qos.QoS{word}Policy" for word in ("Reliability", "Durability", "History", "Liveliness"))


def canonical(name: str) -> str:
    """One name for what modules give out under several; of a class as for what is in it."""
    found = _ALIASES.get(name)
    if found is not None:
        return found
    if not name.startswith("rclpy."):
        return name
    if name.startswith(_IN_QOS):
        return name.replace("rclpy.qos.QoS", "rclpy.qos.", 1)
    for alias, goal in _CLASSES.items():
        if name.startswith(f"{alias}."):
            return goal + name[len(alias) :]
    return name

"""Calls of programs of ROS 2 into modules that are not followed, as the tables of one dialect."""

from __future__ import annotations

from launchlint.extract.python.dialect import Dialect
from launchlint.extract.python.models import Model
from launchlint.extract.python.ros2 import api, libraries
from launchlint.extract.python.ros2.canonical import canonical
from launchlint.extract.python.ros2.names import interface_type, spelled
from launchlint.extract.python.ros2.nodes import KNOWN_NODES, NODE_CLASSES


def _no_model(name: str) -> Model | None:
    return None


RCLPY = Dialect(
    handlers=libraries.HANDLERS,
    methods=libraries.METHODS,
    making=frozenset(name.rpartition(".")[2] for name in (*libraries.MAKING, *NODE_CLASSES, *KNOWN_NODES)) | frozenset(api.MAKING),
    modules=frozenset(("rclpy",)),
    never_followed=frozenset(
        """rclpy rosidl_runtime_py tf2_ros tf2_py message_filters diagnostic_updater interactive_markers cv_bridge rosbag2_py
        nav2_simple_commander""".split()
    ),
    talking=frozenset(("rclpy", "tf2_ros", "message_filters", "nav2_simple_commander", "moveit", "rqt_gui", "rqt_gui_py")),
    silent=frozenset(
        """rclpy rosidl_runtime_py rosidl_parser rosidl_generator_py rpyutils ament_index_python builtin_interfaces rcl_interfaces
        composition_interfaces example_interfaces rosbag2_py sensor_msgs_py tf2_geometry_msgs tf2_sensor_msgs tf_transformations
        launch launch_ros launch_xml launch_yaml ros2run ros2pkg rclpy_message_converter generate_parameter_library_py
        nav2_simple_commander py_binding_tools osrf_pycommon domain_coordinator""".split()
    ),
    calls_back=("rclpy.",),
    canonical=canonical,
    type_of=interface_type,
    spelled=spelled,
    model_of=_no_model,
)
"""Programs of ROS 2."""

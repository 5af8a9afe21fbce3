"""Which types are the same on the wire.

ROS compares the MD5 sum of the definitions, never the names: roscpp in Publication::validateHeader and
ServicePublication::validateHeader, rospy in rospy.impl.tcpros_pubsub and tcpros_service.
"""

from __future__ import annotations

ANY = "*"
_TAKES_ANY = ("ShapeShifter", "AnyMsg")
"""The types of roscpp and rospy whose MD5 sum is ``*``: they take every message (topic_tools::ShapeShifter, rospy.AnyMsg)."""

_ALIKE = (
    ("tf2_msgs/TFMessage", "tf/tfMessage", "tf2_web_republisher/TFArray"),
    ("geometry_msgs/Twist", "geometry_msgs/Accel"),
    ("geometry_msgs/Vector3", "geometry_msgs/Point"),
    ("geometry_msgs/Point32", "rtabmap_msgs/Point3f", "rtabmap_ros/Point3f"),
    ("gazebo_msgs/ModelStates", "gazebo_msgs/LinkStates"),
    ("diagnostic_msgs/KeyValue", "cartographer_ros_msgs/MetricLabel"),
    ("std_msgs/Int16", "sr_robot_msgs/FromMotorDataType"),
    ("mavros_msgs/Thrust", "hector_uav_msgs/ThrustCommand"),
    ("mavros_msgs/WheelOdomStamped", "cob_perception_msgs/Float64ArrayStamped"),
    ("hector_uav_msgs/PositionXYCommand", "hector_uav_msgs/VelocityXYCommand"),
    ("opencv_apps/FlowStamped", "opencv_apps/FlowArrayStamped"),
    ("opencv_apps/Point2DArray", "opencv_apps/Contour", "mav_planning_msgs/Polygon2D"),
    ("sick_scan/SickImu", "sick_scan/ImuExtended"),
    ("sick_scan_xd/SickImu", "sick_scan_xd/ImuExtended"),
    ("sick_scan/RadarObject", "ldmrs/SickLdmrsObject"),
    ("rosapi/DeleteParam", "rosapi_msgs/DeleteParam", "turtlesim/Kill"),
    ("topic_tools/MuxSelect", "topic_tools/DemuxSelect"),
    ("topic_tools/MuxList", "topic_tools/DemuxList"),
    ("topic_tools/MuxAdd", "topic_tools/MuxDelete", "topic_tools/DemuxAdd", "topic_tools/DemuxDelete", "jsk_topic_tools/ChangeTopic"),
    ("controller_manager_msgs/LoadController", "controller_manager_msgs/UnloadController"),
    ("industrial_msgs/StartMotion", "industrial_msgs/StopMotion"),
    ("nodelet/NodeletUnload", "orb_slam_2_ros/SaveMap"),
    ("std_srvs/Empty", "roscpp/Empty", "slam_toolbox/Clear", "slam_toolbox/LoopClosure", "slam_toolbox/MergeMaps"),
    ("std_srvs/Empty", "slam_toolbox/ToggleInteractive"),
    ("slam_toolbox/Pause", "slam_toolbox/ClearQueue"),
    ("roscpp_tutorials/TwoInts", "rospy_tutorials/AddTwoInts"),
)
"""Types of public packages whose definitions are equal although their names differ; of each group the first stands for all."""

_FIRST = {name: group[0] for group in _ALIKE for name in group}

STANDARD = frozenset(
    "actionlib_msgs control_msgs controller_manager_msgs diagnostic_msgs dynamic_reconfigure gazebo_msgs geometry_msgs "
    "map_msgs mavros_msgs move_base_msgs moveit_msgs nav_msgs nodelet octomap_msgs rosapi roscpp roscpp_tutorials "
    "rosgraph_msgs rospy_tutorials sensor_msgs shape_msgs slam_toolbox std_msgs std_srvs stereo_msgs tf tf2_msgs topic_tools "
    "trajectory_msgs turtlesim visualization_msgs".split()
)
"""Packages whose definitions were compared with each other."""


def stands_for(name: str) -> str:
    """The one type that stands for all with the definition of ``name``, as far as is known."""
    return _FIRST.get(name, name)


def is_known(name: str) -> bool:
    """Whether ``name`` is a type at all, not empty and not one for any."""
    return name not in ("", ANY) and name.rpartition("/")[2] not in _TAKES_ANY


def may_be_alike(left: str, right: str, left_md5: str = "", right_md5: str = "") -> bool:
    """Whether two types may talk to each other: their sums are equal, or not known and the names mean one definition.

    One name is one definition on one machine, even where two sources of what is known have seen it in two versions.
    """
    if not is_known(left) or not is_known(right) or stands_for(left) == stands_for(right):
        return True
    return bool(left_md5 and right_md5) and (left_md5 == right_md5 or ANY in (left_md5, right_md5))


def may_be_copies(left: str, right: str, kind: str) -> bool:
    """Whether two different names may well be one definition: a package's own copy of a type.

    Services are often nearly empty, so that two of them are easily alike unless both are well known.
    """
    packages = {left.partition("/")[0], right.partition("/")[0]}
    if packages <= STANDARD:
        return False
    return kind == "service" or left.partition("/")[2].casefold() == right.partition("/")[2].casefold()

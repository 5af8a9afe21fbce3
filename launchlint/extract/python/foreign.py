"""Which modules outside a program never make names: Python's own, those that are no ROS packages, and ROS packages known to be silent."""

from __future__ import annotations

import sys
from functools import lru_cache

_SILENT = frozenset(
    """
    rospy roslib rosgraph rospkg genpy genmsg gencpp catkin catkin_pkg message_filters cv_bridge image_geometry tf tf2_ros tf2_py
    tf2_geometry_msgs
    tf2_sensor_msgs tf2_kdl tf_conversions PyKDL eigen_conversions angles actionlib dynamic_reconfigure diagnostic_updater smach smach_ros
    rosunit rosbag xacro urdf_parser_py urdf srdfdom kdl_parser_py sensor_msgs resource_retriever ros_numpy rosparam rosmsg roswtf
    camera_calibration_parsers rosclean rosdep rosdistro bondpy numpy cv2 cv python_qt_binding qt_gui qt_dotgraph rqt_gui rqt_gui_py
    roscpp xmlrpc
    laser_geometry map_msgs topic_tools interactive_markers_msgs pcl pyassimp serial yaml scipy matplotlib rosmake rostest
    unique_id uuid_msgs geodesy pykdl_utils hrl_geom trac_ik_python smclib rosidl_runtime_py mavros_msgs
    """.split()
)
_STANDARD = sys.stdlib_module_names | {
    "Tkinter", "tkMessageBox", "Queue", "ConfigParser", "StringIO", "cStringIO", "cPickle", "thread", "urllib2", "httplib", "commands",
    "SocketServer", "BaseHTTPServer", "SimpleHTTPServer", "HTMLParser", "xmlrpclib", "SimpleXMLRPCServer", "__builtin__", "imp", "cgi",
    "urlparse", "anydbm", "md5", "sets", "exceptions", "asyncore", "asynchat", "telnetlib", "pipes", "distutils", "ttk", "tkFont",
}  # fmt: skip


@lru_cache(maxsize=4096)
def is_silent(top: str) -> bool:
    """Whether calls of a module whose top-level name is ``top`` make no names that are not recognised by themselves."""
    if top in _SILENT or top in _STANDARD or top.endswith(("_msgs", "_srvs", "_interfaces", "_actions", "_description")):
        return True
    from launchlint.workspace.public_packages import public_names

    return top not in public_names()

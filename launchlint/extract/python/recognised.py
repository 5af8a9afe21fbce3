"""Calls into modules that are not followed: which of them make or ask for names, or are known otherwise, and what they give back."""

from __future__ import annotations

import re
from collections.abc import Mapping

from launchlint.extract.python import command_line, libraries, models, rospy
from launchlint.extract.python.arguments import Call
from launchlint.extract.python.canonical import canonical, message_class
from launchlint.extract.python.dialect import Dialect, Handler, Method
from launchlint.extract.python.names import ros_name
from launchlint.extract.python.outside import MessageClass
from launchlint.python import standard
from launchlint.python.values import UNKNOWN, Class, Value

_MESSAGE = re.compile(r"([A-Za-z]\w*)/(?:msg/|srv/)?([A-Za-z]\w*)", re.ASCII)


def _message_by_name(made: Call) -> Value:
    name = made.get(0, "message_type")
    match = _MESSAGE.fullmatch(name) if isinstance(name, str) else None
    return UNKNOWN if match is None else MessageClass(f"{match[1]}/{match[2]}")


def _tests(made: Call) -> Value:
    given = [each for each in (*made.positional, *made.keywords.values()) if isinstance(each, Class)]
    made.run.escape(given or made.run.test_classes(), "start")
    return UNKNOWN


HANDLERS: Mapping[str, Handler] = {
    **standard.HANDLERS,
    "rostest.rosrun": _tests,
    "rostest.run": _tests,
    "rostest.unitrun": _tests,
    "rosunit.unitrun": _tests,
    "unittest.main": _tests,
    "roslib.message.get_message_class": _message_by_name,
    "roslib.message.get_service_class": _message_by_name,
    "rosservice.get_service_class_by_name": lambda made: UNKNOWN,
    **rospy.HANDLERS,
    **libraries.HANDLERS,
    **command_line.HANDLERS,
}

METHODS: Mapping[tuple[str, str], Method] = {
    **rospy.METHODS,
    **libraries.METHODS,
    **command_line.METHODS,
}

_QUIET = frozenset(
    "get_name get_namespace get_caller_id sleep spin is_shutdown myargv ns_join Timer on_shutdown init_node numpy_msg".split()
)
MAKING = frozenset(name.rpartition(".")[2] for name in (*rospy.HANDLERS, *libraries.HANDLERS, *models.NAMES)) - _QUIET
"""The last words of calls that make or ask for names."""

ROSPY = Dialect(
    handlers=HANDLERS,
    methods=METHODS,
    making=MAKING,
    modules=frozenset(("rospy",)),
    never_followed=frozenset(
        """rospy roslib rosgraph actionlib tf tf2_ros tf2_py message_filters dynamic_reconfigure smach smach_ros diagnostic_updater
        rosunit rostest
        genpy genmsg rospkg catkin interactive_markers cv_bridge rosparam rosbag""".split()
    ),
    talking=frozenset(("rospy", "actionlib", "tf2_ros", "message_filters")),
    silent=frozenset(),
    calls_back=("rospy.",),
    canonical=canonical,
    type_of=message_class,
    spelled=lambda value, category: ros_name(value),
    model_of=models.model_of,
)
"""Programs of ROS 1."""

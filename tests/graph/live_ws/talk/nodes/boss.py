#!/usr/bin/python3
"""An action client."""

import actionlib
import rospy
from actionlib.msg import TestAction

rospy.init_node("boss")
client = actionlib.SimpleActionClient("job", TestAction)
rospy.spin()

#!/usr/bin/python3
"""Two action servers."""

import actionlib
import rospy
from actionlib.msg import TestAction

rospy.init_node("worker")
servers = [actionlib.SimpleActionServer(name, TestAction, print, auto_start=False) for name in ("job", "~own")]
for server in servers:
    server.start()
rospy.spin()

#!/usr/bin/python3
"""The listener of the paper: it subscribes to /msg."""

import rospy
from std_msgs.msg import String

rospy.init_node("listener")
subscriber = rospy.Subscriber("/msg", String, print)
rospy.spin()

#!/usr/bin/python3
"""The talker of the paper: it publishes /msg."""

import rospy
from std_msgs.msg import String

rospy.init_node("talker")
publisher = rospy.Publisher("/msg", String, queue_size=1)
rospy.spin()

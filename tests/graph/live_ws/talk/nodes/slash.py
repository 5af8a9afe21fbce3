#!/usr/bin/python3
"""A private name with a slash too many, which rospy takes for a global one; and a name that ends with a slash."""

import rospy
from std_msgs.msg import String

rospy.init_node("slash")
publishers = [rospy.Publisher(name, String, queue_size=1) for name in ("~/state", "odd//one/")]
rospy.spin()

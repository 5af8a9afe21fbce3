#!/usr/bin/python3
"""A node that uses every kind of name, one of them before it has a name itself."""

import rospy
from std_msgs.msg import Int32, String
from std_srvs.srv import Empty, EmptyResponse

early = rospy.Publisher("early", String, queue_size=1)
rospy.init_node("names")
publishers = [
    rospy.Publisher("chatter", String, queue_size=1, latch=True),
    rospy.Publisher("deep/chatter", String, queue_size=1),
    rospy.Publisher("~state", Int32, queue_size=1),
    rospy.Publisher("~deep/state", Int32, queue_size=1),
    rospy.Publisher("/heartbeat", String, queue_size=1),
]
subscribers = [
    rospy.Subscriber("echo", String, print),
    rospy.Subscriber("~command", Int32, print),
    rospy.Subscriber("/emergency", String, print),
]
services = [rospy.Service(name, Empty, lambda _: EmptyResponse()) for name in ("reset", "~calibrate", "/all_stop")]
if rospy.get_param("~loud", False):
    publishers.append(rospy.Publisher("shout", String, queue_size=1))
subscribers.extend(rospy.Subscriber(word, String, print) for word in rospy.get_param("~topics", []))
rospy.spin()

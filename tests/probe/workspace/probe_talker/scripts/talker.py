#!/usr/bin/env python3
import rospy
from probe_talker.msg import Reading
from std_msgs.msg import String
from std_srvs.srv import Trigger, TriggerResponse

rospy.init_node("talker")
rospy.Publisher("reading", Reading, queue_size=1, latch=True)
rospy.Publisher("~state", String, queue_size=1)
rospy.Subscriber("/orders", String, lambda message: None)
rospy.Service("~reset", Trigger, lambda request: TriggerResponse(True, ""))
rospy.get_param("~rate", 10)
rospy.spin()

#!/usr/bin/env python3
import argparse
import rospy

parser = argparse.ArgumentParser()
parser.add_argument("topic")
arguments, _ = parser.parse_known_args(rospy.myargv()[1:])
rospy.init_node("wants_arguments")
rospy.Publisher(arguments.topic, rospy.AnyMsg, queue_size=1)
rospy.spin()

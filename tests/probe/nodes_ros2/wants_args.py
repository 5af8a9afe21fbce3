#!/usr/bin/env python3
"""Takes its topics from its arguments and a param."""
import sys

import rclpy
from rclpy.utilities import remove_ros_args
from std_msgs.msg import String

words = remove_ros_args(sys.argv)[1:]
if len(words) != 1:
    sys.exit("Usage: wants_args TOPIC")
rclpy.init()
node = rclpy.create_node("wants_args")
node.create_publisher(String, words[0], 10)
node.create_subscription(String, node.declare_parameter("topic", "quiet").value, lambda message: None, 10)
rclpy.spin(node)

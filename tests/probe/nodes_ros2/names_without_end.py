#!/usr/bin/env python3
"""Makes up names for ever."""
import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("names_without_end")
number = 0
while True:
    node.create_publisher(String, "topic_%d" % number, 10)
    number += 1
    rclpy.spin_once(node, timeout_sec=0.001)

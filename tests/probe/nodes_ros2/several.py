#!/usr/bin/env python3
"""Two nodes in one process."""
import rclpy
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import String
from std_srvs.srv import Empty

rclpy.init()
one, two = rclpy.create_node("one"), rclpy.create_node("two")
one.create_publisher(String, "words", 10)
two.create_subscription(String, "words", lambda message: None, 10)
two.create_service(Empty, "~/stop", lambda request, response: response)
two.declare_parameter("limit", 4)
executor = SingleThreadedExecutor()
for node in (one, two):
    executor.add_node(node)
executor.spin()

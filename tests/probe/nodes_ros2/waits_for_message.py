#!/usr/bin/env python3
"""Publishes only when it has heard something, and an action when it has heard something else."""
import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("waits_for_message")


def hear(message):
    node.create_publisher(String, "answer", 10)


node.create_subscription(String, "first", hear, 10)
rclpy.spin(node)

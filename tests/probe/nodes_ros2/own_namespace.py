#!/usr/bin/env python3
"""Puts itself into a namespace."""
import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("scout", namespace="/team")
node.create_publisher(String, "found", 10)
rclpy.spin(node)

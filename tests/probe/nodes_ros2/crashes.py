#!/usr/bin/env python3
"""Has a topic, and then an exception."""
import time

import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("crashes")
node.create_publisher(String, "last_words", 10)
time.sleep(1)
raise IndexError("list index out of range")

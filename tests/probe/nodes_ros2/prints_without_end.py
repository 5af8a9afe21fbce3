#!/usr/bin/env python3
"""Prints garbage, and what looks like the observer's own words, without end."""
import os
import time

import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("prints_without_end")
node.create_publisher(String, "garbage", 10)
time.sleep(2)
while True:
    os.write(1, b'{"answer": 1}\n\x1b]0;owned\x07\xff\xfe' + os.urandom(4096) * 16)

#!/usr/bin/env python3
"""Never spins, so it answers no question."""
import time

import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("mute")
node.create_publisher(String, "noise", 10)
while True:
    time.sleep(1)

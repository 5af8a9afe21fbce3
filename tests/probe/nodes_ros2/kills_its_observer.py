#!/usr/bin/env python3
"""Ends what watches it."""
import os
import signal

import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("kills_its_observer")
node.create_publisher(String, "gun", 10)
for _ in range(10):
    rclpy.spin_once(node, timeout_sec=0.1)
for process in filter(str.isdigit, os.listdir("/proc")):
    try:
        with open("/proc/%s/cmdline" % process, "rb") as file:
            words = file.read()
        with open("/proc/%s/environ" % process, "rb") as file:
            domain = ("ROS_DOMAIN_ID=%s" % os.environ["ROS_DOMAIN_ID"]).encode() in file.read().split(b"\0")
    except OSError:
        continue
    if b"observer.py" in words and domain:
        os.kill(int(process), signal.SIGKILL)
rclpy.spin(node)

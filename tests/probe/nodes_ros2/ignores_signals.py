#!/usr/bin/env python3
"""Neither ends when it is asked to, nor lets its children."""
import os
import signal
import time

import rclpy
from std_msgs.msg import String

for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
    signal.signal(number, signal.SIG_IGN)
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        while True:
            time.sleep(1)
    os._exit(0)
rclpy.init(signal_handler_options=rclpy.SignalHandlerOptions.NO)
node = rclpy.create_node("ignores_signals")
node.create_publisher(String, "stubborn", 10)
while True:
    rclpy.spin_once(node)

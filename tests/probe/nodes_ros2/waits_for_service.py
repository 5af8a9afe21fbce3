#!/usr/bin/env python3
"""Begins only when a service is there and has answered."""
import rclpy
from std_msgs.msg import String
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("waits_for_service")
client = node.create_client(Trigger, "map/load")
while not client.wait_for_service(timeout_sec=0.5):
    pass
rclpy.spin_until_future_complete(node, client.call_async(Trigger.Request()))
node.create_publisher(String, "loaded", 10)
rclpy.spin(node)

#!/usr/bin/env python3
"""Makes up a part of its names."""
import uuid

import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("random_names")
node.create_publisher(String, "session_" + uuid.uuid4().hex[:8] + "/status", 10)
node.create_publisher(String, "steady", 10)
rclpy.spin(node)

#!/usr/bin/env python3
"""Takes params that it does not declare."""
import rclpy

rclpy.init()
node = rclpy.create_node("takes_any", allow_undeclared_parameters=True, automatically_declare_parameters_from_overrides=True)
node.declare_parameter("known", 1.0)
rclpy.spin(node)

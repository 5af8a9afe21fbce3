#!/usr/bin/env python3
"""Is over before anybody can have seen it."""
import rclpy

rclpy.init()
rclpy.create_node("ends_at_once")
rclpy.shutdown()

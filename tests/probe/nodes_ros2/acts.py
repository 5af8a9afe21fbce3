#!/usr/bin/env python3
"""Serves one action and wants another."""
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer

rclpy.init()
node = rclpy.create_node("acts")
server = ActionServer(node, Fibonacci, "count", lambda goal: Fibonacci.Result())
client = ActionClient(node, Fibonacci, "~/plan")
rclpy.spin(node)

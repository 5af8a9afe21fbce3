#!/usr/bin/env python3
"""A node with a lifecycle that lacks something."""
import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn


class Refuses(LifecycleNode):
    def on_configure(self, state):
        return TransitionCallbackReturn.FAILURE


rclpy.init()
rclpy.spin(Refuses("refuses"))

#!/usr/bin/env python3
"""A node with a lifecycle: something new in every state."""
import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from std_msgs.msg import String


class Stateful(LifecycleNode):
    def __init__(self):
        super().__init__("stateful")
        self.declare_parameter("port", "/dev/null")

    def on_configure(self, state):
        self.declare_parameter("rate", 10)
        self.out = self.create_lifecycle_publisher(String, "readings", 10)
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state):
        self.heard = self.create_subscription(String, "commands", lambda message: None, 10)
        return super().on_activate(state)


rclpy.init()
rclpy.spin(Stateful())

#!/usr/bin/env python3
"""Names of all kinds, with QoS, and params with all that can be said of them."""
import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy, DurabilityPolicy
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Talks(Node):
    def __init__(self):
        super().__init__("talks")
        self.create_publisher(String, "chatter", 7)
        self.create_publisher(String, "~/state", QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
        self.create_publisher(String, "/status", 10)
        self.create_publisher(String, self.get_name() + "_debug", 10)
        self.create_subscription(
            String, "orders", lambda message: None, QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
        )
        self.create_service(Trigger, "~/reset", lambda request, response: response)
        self.create_client(Trigger, "dock/open")
        range_ = FloatingPointRange(from_value=0.0, to_value=10.0, step=0.5)
        self.declare_parameter("speed", 1.5, ParameterDescriptor(description="metres a second", floating_point_range=[range_]))
        self.declare_parameter("arm.joints", ["one", "two"], ParameterDescriptor(read_only=True))
        self.declare_parameter("count", 3, ParameterDescriptor(integer_range=[IntegerRange(from_value=1, to_value=9)]))
        self.declare_parameter("whatever", True, ParameterDescriptor(dynamic_typing=True))


rclpy.init()
rclpy.spin(Talks())

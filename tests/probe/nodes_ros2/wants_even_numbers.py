#!/usr/bin/env python3
"""Takes params that it does not declare, if their values please it."""
import rclpy
from rcl_interfaces.msg import SetParametersResult

rclpy.init()
node = rclpy.create_node("wants_even_numbers", allow_undeclared_parameters=True)


def judge(params):
    even = all(isinstance(param.value, int) and not isinstance(param.value, bool) and param.value % 2 == 0 for param in params)
    return SetParametersResult(successful=even, reason="" if even else "it is not even")


node.add_on_set_parameters_callback(judge)
rclpy.spin(node)

#!/usr/bin/env python3
"""Publishes a joint for each link of the robot's description."""

from wire import Node, spin

node = Node()
code, _, text = node.param("robot_description")
assert code == 1 and "<link" in text
node.publish("joint_states", "sensor_msgs/JointState")
spin()

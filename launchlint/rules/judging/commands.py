"""Packages of ROS 2 that bring a command of the tool ros2, and no program that a node could be made of."""

from __future__ import annotations

COMMANDS = {
    "ros2action": "action", "ros2bag": "bag", "ros2component": "component", "ros2controlcli": "control", "ros2doctor": "doctor",
    "ros2interface": "interface", "ros2launch": "launch", "ros2lifecycle": "lifecycle", "ros2multicast": "multicast", "ros2node": "node",
    "ros2param": "param", "ros2pkg": "pkg", "ros2run": "run", "ros2service": "service", "ros2topic": "topic", "ros2trace": "trace",
}  # fmt: skip
"""The command of each: their ``setup.py`` has entry points of ros2cli (``ros2cli.command``) alone, no script that goes to ``lib/PKG``
(ros2cli, rosbag2, ros2_control and ros2_tracing).
"""

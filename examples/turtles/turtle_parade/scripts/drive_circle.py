#!/usr/bin/env python3
"""Drive a turtle in a circle of radius 2. Publishes geometry_msgs/Twist on cmd_vel."""

from turtle_parade import drive

if __name__ == "__main__":
    drive("drive_circle", "cmd_vel", forward=2.0, turn=1.0)

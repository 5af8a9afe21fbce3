#!/usr/bin/env python3
"""Drive a turtle straight ahead. Publishes geometry_msgs/Twist on line_cmd_vel."""

from turtle_parade import drive

if __name__ == "__main__":
    drive("drive_line", "line_cmd_vel", forward=0.5)

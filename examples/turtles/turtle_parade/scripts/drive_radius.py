#!/usr/bin/env python3
"""Drive a turtle in a circle whose radius (m, more than 0) is the first argument. Publishes geometry_msgs/Twist on radius_cmd_vel."""

import sys

import rospy
from turtle_parade import drive

SPEED = 1.5  # m/s


def main():
    """Read the radius, then drive; return the exit status."""
    arguments = rospy.myargv(sys.argv)[1:]
    try:
        (radius,) = map(float, arguments)
    except ValueError:
        radius = 0.0
    if radius <= 0.0:
        print("usage: drive_radius.py RADIUS (a number above 0)", file=sys.stderr)
        return 2
    drive("drive_radius", "radius_cmd_vel", forward=SPEED, turn=SPEED / radius)
    return 0


if __name__ == "__main__":
    sys.exit(main())

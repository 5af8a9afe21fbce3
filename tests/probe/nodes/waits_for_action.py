#!/usr/bin/env python3
"""Sends a goal as soon as there is a server, and publishes when it has succeeded."""

import struct
import threading
from wire import Node, spin

ID = b"goal 7"
GOAL = bytes(16) + bytes(8) + struct.pack("<I", len(ID)) + ID + bytes(8)

node = Node()
there, done = threading.Event(), threading.Event()


def finished(message):
    if message[24:].startswith(struct.pack("<I", len(ID)) + ID + b"\3"):
        done.set()


node.subscribe("move/status", "actionlib_msgs/GoalStatusArray", lambda message: there.set())
node.subscribe("move/feedback", "odd_msgs/MoveActionFeedback")
node.subscribe("move/result", "odd_msgs/MoveActionResult", finished)
node.publish("move/cancel", "actionlib_msgs/GoalID")
node.publish("move/goal", "odd_msgs/MoveActionGoal", GOAL)
there.wait()
done.wait()
node.publish("arrived")
spin()

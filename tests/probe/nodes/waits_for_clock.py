#!/usr/bin/env python3
"""Publishes when the clock has run for a while."""

import struct
from wire import Node, spin

node = Node()
times = []


def tick(message):
    times.append(struct.unpack("<II", message))
    if len(times) == 3 and times[2] > times[0]:
        node.publish("timed")


node.subscribe("/clock", "rosgraph_msgs/Clock", tick)
spin()

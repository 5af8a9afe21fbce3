#!/usr/bin/env python3
"""Asks for a service until it is there, which is never; only then would it publish."""

import time
from wire import Node

node = Node()
while node.find_service("map/load")[0] != 1:
    time.sleep(0.2)
node.publish("never")

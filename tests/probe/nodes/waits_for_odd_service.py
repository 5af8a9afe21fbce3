#!/usr/bin/env python3
"""Calls a service of a type that is not installed until it succeeds."""

import time
from wire import Node

node = Node()
node.publish("state")
while node.find_service("odd/call")[0] != 1 or node.call("odd/call", "0" * 32) is None:
    time.sleep(0.2)
node.publish("never")

#!/usr/bin/env python3
"""Asks for a param until somebody sets it."""

import time
from wire import Node

node = Node()
node.publish("state")
while node.param("mission/id")[0] != 1:
    time.sleep(0.1)
node.publish("never")

#!/usr/bin/env python3
"""Asks for a service until it is there, calls it, and publishes only then."""

import time
from wire import Node, spin

node = Node()
while node.find_service("map/load")[0] != 1:
    time.sleep(0.2)
assert node.call("map/load", "d49b9423403730888a6ce1fd191c2caf") == bytes(9)
node.publish("loaded")
spin()

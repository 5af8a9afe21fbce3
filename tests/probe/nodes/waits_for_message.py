#!/usr/bin/env python3
"""Publishes only when a first message has come."""

from wire import Node, spin

node = Node()
assert node.wait_for_message("first") == bytes(4)
node.publish("answer")
spin()

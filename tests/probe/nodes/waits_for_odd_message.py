#!/usr/bin/env python3
"""Publishes only when a message has come whose type is not installed."""

from wire import Node, spin

node = Node()
node.wait_for_message("strange", "nobody_msgs/Knows")
node.publish("never")
spin()

#!/usr/bin/env python3
"""Has a topic for its state, and more topics as soon as its device is there, which is never."""

import sys
import time
from wire import Node

node = Node()
node.publish("state")
while True:
    sys.stderr.write("[WARN] [1700000000.0]: no answer from the lidar, retrying in 1 s\n")
    time.sleep(1)

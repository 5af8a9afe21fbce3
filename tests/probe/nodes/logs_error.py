#!/usr/bin/env python3
"""Says that something went wrong, and goes on with less."""

import sys
from wire import Node, spin

node = Node()
node.publish("state")
sys.stderr.write("\x1b[31m[ERROR] [1700000000.0]: calibration is not valid, cameras are off\x1b[0m\n")
spin()

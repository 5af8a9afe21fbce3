#!/usr/bin/env python3
"""Takes no arguments at all, not even those that roslaunch gives to every node."""

import sys
from wire import Node, spin

if len(sys.argv) > 1:
    sys.exit("Usage: refuses_arguments (without arguments)")
Node().publish("stubborn_name")
spin()

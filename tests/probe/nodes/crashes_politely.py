#!/usr/bin/env python3
"""Has an exception, prints it, and ends with status 0."""

import sys
import traceback
from wire import Node

try:
    Node().publish("before")
    [][1]
except IndexError:
    traceback.print_exc()
    sys.exit(0)

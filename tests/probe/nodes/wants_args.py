#!/usr/bin/env python3
"""Prints how it is to be called, and ends with status 0 as if all were well."""

import sys
from wire import Node, spin

words = [word for word in sys.argv[1:] if ":=" not in word]
if len(words) < 2:
    print("Usage: wants_args INPUT OUTPUT")
    sys.exit(0)
node = Node()
node.subscribe(words[0])
node.publish(words[1])
spin()

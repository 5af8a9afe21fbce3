#!/usr/bin/env python3
"""Its topics come three seconds after it has found the master."""

import time
from wire import Node, spin

node = Node()
node.param("~delay")
time.sleep(3)
node.publish("late")
spin()

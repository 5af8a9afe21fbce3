#!/usr/bin/env python3
"""Two digits of a name change from one half second to the next, and a word of another one; the date is part of a third."""

import random
import time
from wire import Node, spin

node = Node()
node.publish("cell_{}/state".format(int(time.monotonic() * 2) % 60))
node.publish("{}_pose".format("".join(random.choice("aeiou") for _ in range(12))))
node.publish("log_{}".format(time.strftime("%Y%m%d")))
spin()

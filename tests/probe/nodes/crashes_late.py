#!/usr/bin/env python3
"""Is ended by a signal when a message comes."""

import os
import signal
from wire import Node, spin

node = Node()
node.publish("doomed")
node.subscribe("first", call=lambda message: os.kill(os.getpid(), signal.SIGSEGV))
spin()

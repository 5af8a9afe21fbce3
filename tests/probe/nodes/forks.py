#!/usr/bin/env python3
"""A child that starts a child when it is told to end, and so on; each in a session of its own."""

import os
import signal
import time
from wire import Node

Node().publish("many")


def again(number, frame):
    if not os.fork():
        os.setsid()
        while True:
            time.sleep(1)


signal.signal(signal.SIGINT, again)
signal.signal(signal.SIGTERM, again)
while True:
    time.sleep(1)

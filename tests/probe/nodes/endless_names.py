#!/usr/bin/env python3
"""A new topic each time, from several threads at once."""

import itertools
import threading

from wire import Node

numbers = itertools.count()


def publish():
    node = Node()
    for number in numbers:
        node.publish("topic_{}".format(number))


for _ in range(8):
    threading.Thread(target=publish).start()

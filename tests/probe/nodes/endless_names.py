#!/usr/bin/env python3
"""A new topic each time."""

import itertools
from wire import Node

node = Node()
for number in itertools.count():
    node.publish("topic_{}".format(number))

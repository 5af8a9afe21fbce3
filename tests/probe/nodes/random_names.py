#!/usr/bin/env python3
"""Part of each name is made up on the spot."""

import os
import random
import uuid
from wire import Node, spin

node = Node()
node.publish("session_{}/status".format(random.randrange(10**6, 10**7)))
node.publish("/worker_{}".format(os.getpid() + 100000))
node.publish("id_{}/pose".format(uuid.uuid4().hex))
node.publish("steady")
node.subscribe("camera_2021/image")
spin()

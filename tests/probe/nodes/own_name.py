#!/usr/bin/env python3
"""Names made of its own name and namespace, as with getName() in roscpp."""

from wire import Node, spin

node = Node()
node.publish("{}_debug".format(node.name.rpartition("/")[2]))
node.publish("/robots{}/pose".format(node.name))
node.publish("~own")
spin()

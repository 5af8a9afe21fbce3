#!/usr/bin/env python3
"""Registers what is no name, and prints what a terminal would obey."""

from wire import Node, spin

node = Node()
for name in ("/../../etc/passwd", "/$(touch owned)", "/two words", "/new\nline", "/brace{any}", "/good", "/-rf"):
    node.publish(name)
node.publish("/odd_type", "no type at all; rm -rf")
node.find_service("/\u202egnorw")
node.param("~\u009bbell")
print("\x1b[2J\x1b[31mERROR: \x1b]0;owned\x07could not open port /dev/x\x1b[8m")
spin()

#!/usr/bin/env python3
"""Needs twenty seconds before it does anything at all, longer than a node is given unless its ``limit`` says so."""

import time

time.sleep(20)
from wire import Node, spin  # noqa: E402 (a slow import is what this is about)

Node().publish("at_last")
spin()

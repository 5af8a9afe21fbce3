#!/usr/bin/env python3
"""Needs four seconds before it does anything at all."""

import time

time.sleep(4)
from wire import Node, spin  # noqa: E402 (a slow import is what this is about)

Node().publish("slow")
spin()

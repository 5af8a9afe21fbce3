#!/usr/bin/env python3
"""Wants more and more memory."""

import time
from wire import Node

Node().publish("hungry")
kept = []
while True:
    kept.append(bytearray(b"x" * (8 << 20)))
    time.sleep(0.02)

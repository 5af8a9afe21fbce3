#!/usr/bin/env python3
"""Forks twice, begins a session of its own and lives on when what was started has ended."""

import os

if os.fork():
    os._exit(0)
os.setsid()
if os.fork():
    os._exit(0)
from wire import Node, spin  # noqa: E402 (threads do not survive a fork)

Node().publish("from_the_dark")
spin()

#!/usr/bin/env python3
"""Neither Ctrl-C nor SIGTERM ends it."""

import signal

signal.signal(signal.SIGINT, signal.SIG_IGN)
signal.signal(signal.SIGTERM, signal.SIG_IGN)
from wire import Node, spin  # noqa: E402

Node().publish("stubborn")
spin()

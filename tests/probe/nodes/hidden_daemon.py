#!/usr/bin/env python3
"""As daemon.py, but it also clears its environment, so that only its ancestry tells where it came from."""

import os
import sys

if len(sys.argv) > 1 and sys.argv[1] == "hidden":
    import time

    time.sleep(600)
from wire import Node, spin  # noqa: E402

Node().publish("visible")
if not os.fork():
    os.setsid()
    if not os.fork():
        os.execve(sys.executable, [sys.executable, __file__, "hidden"], {})
    os._exit(0)
spin()

#!/usr/bin/env python3
"""Writes until nothing more can be written."""

import tempfile
from wire import Node

Node().publish("filling")
with tempfile.NamedTemporaryFile() as file:
    while True:
        file.write(bytes(1 << 20))

#!/usr/bin/env python3
"""Prints as fast as it can."""

import sys

while True:
    sys.stdout.write("x" * 100000 + "\n")

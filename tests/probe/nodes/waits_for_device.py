#!/usr/bin/env python3
"""Tries to open a serial port that is not there, again and again."""

import os
import time

while not os.path.exists("/dev/ttyUSB_robot"):
    print("could not open port /dev/ttyUSB_robot: No such file or directory", flush=True)
    time.sleep(0.5)

#!/usr/bin/env python3
"""Publishes only after a first message, which nobody sends."""

from wire import Node, spin

Node().subscribe("first")
spin()

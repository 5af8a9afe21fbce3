#!/usr/bin/env python3
"""Ends by itself as soon as it has said what it publishes."""

from wire import Node

Node().publish("brief")

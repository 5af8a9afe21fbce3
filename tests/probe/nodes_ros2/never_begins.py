#!/usr/bin/env python3
"""Computes for ever; rclpy comes too late."""
while True:
    pass
import rclpy

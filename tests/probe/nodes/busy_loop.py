#!/usr/bin/env python3
"""Computes for ever, and does nothing else."""

while True:
    pass

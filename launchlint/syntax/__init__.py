"""Bytes to a positioned tree, and the tables that say what a dialect allows."""

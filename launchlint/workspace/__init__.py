"""Packages, launch files and configuration on disk; never launch semantics."""

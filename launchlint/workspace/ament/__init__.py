"""Packages as ament and colcon see them: what they are, where they are found, and what of them is installed where."""

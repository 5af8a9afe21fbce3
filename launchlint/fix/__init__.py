"""Edits of launch files that are proved to change nothing else."""

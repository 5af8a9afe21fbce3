"""Rules about includes."""

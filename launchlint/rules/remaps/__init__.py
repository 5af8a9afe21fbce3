"""Rules about remaps."""

"""Rules about args."""

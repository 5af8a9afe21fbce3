"""Rules about params."""

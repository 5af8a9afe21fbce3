"""One file per rule, one folder per category; ``registry.py`` lists them all."""

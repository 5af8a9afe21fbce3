"""launchlint: a static checker for robot launch files."""

__version__ = "0.1.0"

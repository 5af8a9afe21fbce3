"""The exceptions launchlint raises on purpose.

Everything a *launch file* can do wrong becomes a finding, never an exception.
What is left is what a person at the keyboard can put right: an unknown option,
an unreadable configuration, a path that does not exist. Each such error is one
message for that person, and the command ends with exit status 2.
"""

from __future__ import annotations


class LaunchlintError(Exception):
    """Base of all deliberate errors; ``str(error)`` is the whole message for the user."""


class UsageError(LaunchlintError):
    """The command line asks for something that cannot be done (unknown rule, missing path …)."""


class ConfigurationError(LaunchlintError):
    """A configuration, baseline or entries file is not what it should be; the message gives file, line and column."""


class LibraryError(LaunchlintError):
    """A library cannot be read or is not what it should be; each line of the message gives file, line and column."""


class OutputClosed(Exception):
    """Whoever read standard output has gone, as ``head`` does; nobody is left to tell."""

"""What an expression can ask of the world around it, and how it fails."""

from __future__ import annotations

from typing import Protocol

from launchlint.evaluate.ros1.values import UnknownValue

__all__ = ("EnvironmentUnset", "ExpressionError", "Resolver", "UndefinedArg", "UnknownValue")


class UndefinedArg(Exception):
    """A resolver's answer: there is no arg of this ``name``."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.name = name


class EnvironmentUnset(Exception):
    """A resolver's answer: there is no environment variable of this ``name``."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.name = name


class ExpressionError(Exception):
    """roslaunch itself would fail on the expression.

    ``message`` is plain words, with Python's own at its end; ``start`` and ``end`` are code points in the text that was evaluated. ``kind``
    is the name of the exception that roslaunch meets (``NameError``, …). ``undefined_arg`` and ``unset_env`` name what was asked for
    and is not there, where that is the reason.
    """

    def __init__(
        self, message: str, start: int, end: int, kind: str = "", undefined_arg: str | None = None, unset_env: str | None = None
    ) -> None:
        super().__init__(message)
        self.message = message
        self.start = start
        self.end = end
        self.kind = kind
        self.undefined_arg = undefined_arg
        self.unset_env = unset_env


class Resolver(Protocol):
    """What an expression can ask of the world around it.

    Each method may raise :class:`UnknownValue` when the answer cannot be known; any other exception passes through ``evaluate`` unchanged.
    """

    def arg(self, name: str) -> str:
        """Text of the arg ``name``; raises :class:`UndefinedArg`."""
        ...

    def has_arg(self, name: str) -> bool:
        """Whether there is an arg of this name with a value."""
        ...

    def env(self, name: str) -> str:
        """Text of the environment variable; raises :class:`EnvironmentUnset`."""
        ...

    def optenv(self, name: str, default: str) -> str:
        """Text of the environment variable, or ``default`` (the very object) where it is not set."""
        ...

    def find(self, package: str) -> str:
        """Directory of the package."""
        ...

    def anon(self, id: str) -> str:
        """The anonymous name for ``id``."""
        ...

    def dirname(self) -> str:
        """Absolute directory of the launch file."""
        ...

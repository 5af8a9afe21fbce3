"""What an expression can ask of the world around it, and how it fails."""

from __future__ import annotations

from launchlint.evaluate.expression.errors import ExpressionError, UnknownValue

__all__ = ("EnvironmentUnset", "ExpressionError", "UndefinedArg", "UnknownValue")


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


TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Protocol

    class Resolver(Protocol):
        """What an expression can ask of the world around it.

        Each method may raise :class:`UnknownValue` when the answer cannot be known; any other exception passes through ``evaluate``
        unchanged.
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

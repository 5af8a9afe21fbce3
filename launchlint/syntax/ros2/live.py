"""What a function of a launch file in Python can ask of a launch that runs: the context it is called with.

The front end for Python is given one by the evaluation, which knows nothing of Python.
"""

from __future__ import annotations

from typing import Protocol

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.model import Unknown
    from launchlint.problem import Problem
    from launchlint.syntax.ros2.description import Action, Condition, Text


class LiveContext(Protocol):
    """The context at the moment of a call. Values that cannot be known are :class:`~launchlint.model.Unknown`.

    ``perform`` and ``holds`` raise :class:`Stopped` where launch stops.
    """

    @property
    def launch(self) -> object:
        """One for all calls in one launch, and another one for another launch."""

    def spend(self, steps: int) -> None:
        """Count work. Raises what ends the evaluation, at its bound."""

    def perform(self, text: Text) -> str | Unknown:
        """The string that a text stands for now."""

    def holds(self, condition: Condition) -> bool | None:
        """Whether a condition holds now; None where that is not known."""

    def configuration(self, name: str) -> str | Unknown | None:
        """A launch configuration; None where it is not set."""

    def configurations(self) -> dict[str, str | Unknown] | None:
        """All of them; None where there may be others."""

    def configure(self, name: str, value: str | Unknown) -> None:
        """Set a launch configuration."""

    def variable(self, name: str) -> str | Unknown | None:
        """An environment variable; None where it is not set."""

    def environment(self) -> dict[str, str | Unknown | None]:
        """What the launch has changed in the environment; None is for what is not set any more."""

    def unsettle(self) -> None:
        """From here on it is not known whether launch gets any further."""

    def set_variable(self, name: str, value: str | Unknown | None) -> None:
        """Set an environment variable, or unset it."""

    def remember(self) -> None:
        """The function has changed what later ones in the same launch may read, other than the context."""


class Call(Protocol):
    """What is called when its action is executed, and gives further actions. Raises whatever the live context raises."""

    def __call__(self, live: LiveContext, /) -> tuple[Action, ...]:
        """Those actions."""


class Gives(Protocol):
    """The same for a text."""

    def __call__(self, live: LiveContext, /) -> str | Unknown:
        """The string that it stands for."""


class Stopped(Exception):
    """launch stops at what a function has asked for, unless the function catches that."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem)
        self.problem = problem

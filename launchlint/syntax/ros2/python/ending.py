"""What it means for a launch that a launch file in Python ends with an exception, wherever that may come from."""

from __future__ import annotations

from launchlint.problem import Problem
from launchlint.python.failures import Asked, Raised, said
from launchlint.source import Origin, Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Action, Text
from launchlint.syntax.ros2.python.problems import StopsWithError
from launchlint.syntax.ros2.python.texts import asking

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.python.noticing import Noticing

_CERTAIN = frozenset(
    """AssertionError FileNotFoundError IndexError IsADirectoryError KeyError NameError NotADirectoryError UnboundLocalError ValueError
    ZeroDivisionError""".split()
)
"""Exceptions of Python that nothing else can be meant by: others may come of an object that is known less well than it seems."""


def actions_of(raised: Raised, run: Noticing, everything: Place, *, called: bool, lacking: str = "") -> tuple[Action, ...]:
    """What stands for a program that ends so: what stops launch, for the reason that the program has, where that is certain.

    ``lacking`` is a launch configuration that it asked for before, and that nothing sets, or to nothing but an empty text.
    """
    place, related = _places(raised, run, everything)
    if raised.asked is not None:
        return (asks(raised.asked, place),)
    error, _, what = said(raised.value).partition(": ")
    if not raised.stated and error not in _CERTAIN:
        return ()
    problem: Problem = StopsWithError(
        origin=Origin(place), refused=True, related=related, error=error, what=what, stated=raised.stated, called=called, lacking=lacking,
        package=run.missing_package if raised.stated else "", variable=run.missing_variable if raised.stated else "",
    )  # fmt: skip
    return (described.Fails(problem, place),)


def asks(asked: Asked, place: Place) -> Action:
    """What stands for a program that asks for what may not be here: launch stops there, unless it is."""
    return described.Log(Text((asking(asked, place),), place), None, place)


def _places(raised: Raised, run: Noticing, everything: Place) -> tuple[Place, tuple[tuple[Place, str], ...]]:
    """Where the launch file itself stops, and where in another module the exception comes from."""
    places = [run.place(node, scope) for node, scope in raised.where]
    own = next((each for each in places if each.source is everything.source), everything)
    return own, ((places[0], "raised here"),) if places and places[0].source is not own.source else ()

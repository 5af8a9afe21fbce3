"""Components: where following one begins."""

from __future__ import annotations

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.rclcpp.nodes import OPTIONS
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import Argument, Thing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine


def start(machine: Machine, entry: str, path: str) -> None:
    """Make an object of the class of a component, as its factory does: with options."""
    machine.serial += 1
    classes.make_loaded(machine, entry, path, [Argument(Thing(Type(OPTIONS), None, machine.serial))])

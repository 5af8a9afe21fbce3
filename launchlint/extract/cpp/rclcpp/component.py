"""Components: where following one begins."""

from __future__ import annotations

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.rclcpp.nodes import OPTIONS
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import Thing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine


def start(machine: Machine, entry: str, path: str) -> None:
    """Make an object of the class of a component, as its factory does: with options."""
    from launchlint.extract.cpp.machine import Argument

    name = entry.removeprefix("::")
    frame = Frame(path, "", None, {})
    resolved = machine.names.resolve(Type(name), frame)
    declared = machine.names.declared(resolved)
    if declared is None:
        machine.doubt_all(f"the class {name[:200]} was not found in these sources", path, 1)
        return
    machine.serial += 1
    options = Thing(Type(OPTIONS), None, machine.serial)
    classes.make(machine, declared, resolved, [Argument(options)], Node("declaration", b"", 0, 0), frame)

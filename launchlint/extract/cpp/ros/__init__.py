"""The interface of ROS in C++: which calls make which names. One table each for objects that are made, functions, and members."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.extract.cpp.foreign import is_silent
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.naming import NODE_NAME
from launchlint.extract.cpp.ros import functions as _functions
from launchlint.extract.cpp.ros import handle as _handle
from launchlint.extract.cpp.ros import library as _library
from launchlint.extract.cpp.ros import models as _models
from launchlint.extract.cpp.spelled_type import POINTERS, Type
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import UNKNOWN, Callable, Cell, Closure, Handle, Number, Text, Thing, Value, choices
from launchlint.extract.fact import ELSEWHERE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call
    from launchlint.extract.cpp.machine import Argument, Machine

TELLING_METHODS = {
    "advertise": "publishers",
    "subscribe": "subscribers",
    "advertiseService": "services",
    "serviceClient": "clients",
    "getParam": "params",
    "param": "params",
}
"""Members of a node handle, and the category of what they make."""

BARE = frozenset(
    ("message_filters::Subscriber", "image_transport::SubscriberFilter", "urdf::Model", "ros::AdvertiseOptions", "ros::SubscribeOptions")
)
"""Classes whose members tell something even where their constructor was not seen."""

WITH_METHODS = frozenset(name for name, _ in _library.METHODS)
"""Classes of ROS with members that tell something."""

_NODELETS = {
    "getNodeHandle": "",
    "getPrivateNodeHandle": "~",
    "getMTNodeHandle": "",
    "getMTPrivateNodeHandle": "~",
    "getSTNodeHandle": "",
    "getSTPrivateNodeHandle": "~",
}


def is_made(machine: Machine, type_: Type) -> bool:
    """Whether a resolved type is a class of ROS that is known here."""
    if type_.name in machine.declarations.classes:
        # The sources of a ROS package itself are among those of the program.
        return type_.name in _library.MAKERS
    name = _library.known_name(machine, type_)
    return name in _library.MAKERS or name in _models.MODELS


def make(machine: Machine, type_: Type, given: Sequence[Argument], node: Node, frame: Frame) -> Value:
    """Make an object of a class that the program does not have itself."""
    from launchlint.extract.cpp.calls import Call

    name = _library.known_name(machine, type_)
    type_ = type_._replace(name=name)
    asked = Call(machine, name, type_.arguments, given, node, frame)
    if type_.member:
        name = f"{name}::{type_.member}"  # a type that belongs to the class: dynamic_reconfigure::Server<T>::CallbackType
    elif name in _library.MAKERS:
        return _library.MAKERS[name](asked)
    elif (model := _models.MODELS.get(name)) is not None:
        return _models.modelled(asked, model)
    elif (header := _elsewhere(machine, name, given, frame)) is not None:
        machine.doubt_all(f"{name} is of {header}, {ELSEWHERE}", frame.path, node.line)
    machine.serial += 1
    thing = Thing(type_, None, machine.serial)
    for each in given:
        for _, value in choices(each.value):
            if isinstance(value, (Callable, Closure)) and not type_.name.endswith("function"):
                machine.later(value, machine.when)
            elif isinstance(value, (Callable, Closure)):
                return value
            elif isinstance(value, Handle) and name not in _library.HARMLESS:
                machine.doubt_all(f"{name} is given a node handle, and is not in these sources", frame.path, node.line)
    return thing


def base(machine: Machine, type_: Type, given: Sequence[Argument], node: Node, frame: Frame) -> Value:
    """Make the part of an object that is of a base class which the program does not have itself."""
    from launchlint.extract.cpp.calls import Call

    name = _library.known_name(machine, type_)
    if name in _models.BASES:
        return _models.modelled(Call(machine, name, type_.arguments, given, node, frame), _models.BASES[name])
    space = frame.scope.partition("::")[0]
    silent = is_silent(name) or (space and "::" not in name and is_silent(f"{space}::{name}"))
    if not (type_.member or name in _library.MAKERS or name in _models.MODELS or silent or not name):
        machine.doubt_all(f"the base class {name} is not in these sources", frame.path, node.line)
        machine.serial += 1
        return Thing(type_, None, machine.serial)
    return make(machine, type_, given, node, frame)


def _elsewhere(machine: Machine, name: str, given: Sequence[Argument], frame: Frame) -> str | None:
    """The header that a class comes with which is not here and may talk; None where it is a message, or silent."""
    header = machine.foreign.header_of(name, (frame.scope.partition("::")[0], *machine.declarations.used))
    package, _, last = name.rpartition("::")
    if package in _models.MODELS or package in _library.MAKERS:
        return None  # a type or a function that belongs to a class that is known
    spaces = [package] if package else [frame.scope.partition("::")[0], *machine.declarations.used]
    if any(f"{space}/{last}" in machine.declarations.messages for space in spaces):
        # A message is made of nothing, or is the copy of another one.
        texts = any(isinstance(value, (Text, Number)) for each in given for _, value in choices(each.value))
        return header if texts or len(given) > 1 else None
    return header


def header_of_function(machine: Machine, name: str, given: Sequence[Argument], frame: Frame) -> str | None:
    """The header that a function comes with, where it is not here and may talk; a message that is made is none."""
    header = _elsewhere(machine, name, given, frame)
    space, _, last = name.rpartition("::")
    if header is None and given and f"{space}/{last}" not in machine.declarations.messages:
        return machine.foreign.header_of_function(name)
    return header


def function(asked: Call) -> Value | None:
    """A function of ROS; None where it is none that is known."""
    name = asked.name
    if name in _functions.FUNCTIONS:
        return _functions.FUNCTIONS[name](asked)
    if "::" in name:
        first, _, rest = name.partition("::")
        namespaces = asked.machine.declarations.namespaces
        if first in namespaces and f"{namespaces[first]}::{rest}" in _functions.FUNCTIONS:
            return _functions.FUNCTIONS[f"{namespaces[first]}::{rest}"](asked)
        resolved = asked.machine.names.resolve(Type(name.rpartition("::")[0]), asked.frame)
        full = f"{resolved.name}::{name.rpartition('::')[2]}"
        if full in _functions.FUNCTIONS:
            return _functions.FUNCTIONS[full](asked._replace(types=asked.types or resolved.arguments))
    for used in asked.machine.declarations.used:
        if f"{used}::{name}" in _functions.FUNCTIONS and used.startswith(("ros", "image_transport", "dynamic_reconfigure")):
            return _functions.FUNCTIONS[f"{used}::{name}"](asked)
    return None


def handle_method(handle: Handle, asked: Call) -> Value | None:
    """A member function of a node handle; None where it is none that is known."""
    method_ = _handle.METHODS.get(asked.name)
    return None if method_ is None else method_(handle, asked)


def own_method(this: Thing, asked: Call) -> Value | None:
    """A member function that an object has from a base class of ROS; None where that is not known."""
    if asked.name in _NODELETS and not asked.arguments:
        return Handle(_NODELETS[asked.name])
    if asked.name in ("getNodeHandle", "getMTNodeHandle", "getSTNodeHandle"):
        return Handle("")
    if asked.name == "getName" and not asked.arguments and _is_nodelet(this, asked):
        return Text(NODE_NAME)
    held = this.fields.get("<handle>")
    if held is not None and isinstance(held.value, Handle) and asked.name in _handle.METHODS:
        return handle_method(held.value, asked)
    if this.declared is not None:
        for declared in [this.declared, *asked.machine.names.bases(this.declared.name)]:
            for base in declared.bases:
                resolved = asked.machine.names.resolve(base, Frame("", declared.name, this, this.bindings))
                known = _library.METHODS.get((_library.known_name(asked.machine, resolved), asked.name))
                if known is not None:
                    return known(this, asked._replace(types=asked.types or resolved.arguments))
    return None


def _is_nodelet(this: Thing, asked: Call) -> bool:
    return this.declared is not None and any(
        "odelet" in base.name for declared in [this.declared, *asked.machine.names.bases(this.declared.name)] for base in declared.bases
    )


def method(this: Thing, asked: Call) -> Value | None:
    """A member function of an object of a class of ROS; None where it is none that is known."""
    known = _library.METHODS.get((this.type.name, asked.name))
    if known is not None:
        return known(this, asked)
    if this.declared is None and any(
        isinstance(value, (Callable, Closure)) for each in asked.arguments for _, value in choices(each.value)
    ):
        for each in asked.arguments:
            asked.machine.later(each.value, "start" if asked.name in ("setCallback", "create_thread", "post") else "message")
        return UNKNOWN
    return None


def may_be_handle(machine: Machine, cell: Cell | None, frame: Frame) -> bool:
    """Whether a variable of which nothing is known may be a node handle."""
    if cell is None or not cell.type.name:
        return False
    type_ = cell.type.arguments[0] if cell.type.name in POINTERS and cell.type.arguments else cell.type
    return machine.names.resolve(type_, frame).last == "NodeHandle"

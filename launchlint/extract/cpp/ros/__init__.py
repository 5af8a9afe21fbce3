"""The interface of ROS in C++: which calls make which names, as the tables of the client library say that the program is written for."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.extract.cpp.foreign import is_silent
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.ros.models import modelled
from launchlint.extract.cpp.spelled_type import POINTERS, Type
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import UNKNOWN, Argument, Callable, Cell, Closure, Handle, Number, Text, Thing, Value, choices, node_of
from launchlint.extract.fact import ELSEWHERE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call
    from launchlint.extract.cpp.machine import Machine


def known_name(machine: Machine, type_: Type) -> str:
    """The full name of a class of ROS that may be named without its namespace."""
    if machine.tables.known(type_.name):
        return type_.name
    for used in machine.declarations.used:
        full = f"{used}::{type_.name}"
        if machine.tables.known(full):
            return full
    return type_.name


def is_made(machine: Machine, type_: Type) -> bool:
    """Whether a resolved type is a class of ROS that is known here."""
    if type_.name in machine.declarations.classes:
        # The sources of a ROS package itself are among those of the program.
        return type_.name in machine.tables.makers
    return machine.tables.known(known_name(machine, type_))


def make(machine: Machine, type_: Type, given: Sequence[Argument], node: Node, frame: Frame) -> Value:
    """Make an object of a class that the program does not have itself."""
    from launchlint.extract.cpp.calls import Call

    name = known_name(machine, type_)
    type_ = type_._replace(name=name)
    asked = Call(machine, name, type_.arguments, given, node, frame)
    if type_.member:
        name = f"{name}::{type_.member}"  # a type that belongs to the class: dynamic_reconfigure::Server<T>::CallbackType
    elif (maker := machine.tables.makers.get(name) or machine.tables.standins.get(name)) is not None:
        return maker(asked)
    elif (model := machine.tables.models.get(name)) is not None:
        return modelled(asked, model)
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
            elif (held := node_of(value)) is not None and name not in machine.tables.harmless and not is_plain(name, held):
                reason = f"{name} is given a {held.word}, and is not in these sources"
                if held.node is not None and name.endswith("ParamListener"):
                    machine.doubt("params", reason, node, frame)  # generate_parameter_library makes it, and its description is not here
                else:
                    machine.doubt_all(reason, frame.path, node.line)
    return thing


def is_plain(name: str, held: Handle) -> bool:
    """Whether a class or function is of the standard library, which knows no nodes; a node is often what a thread is run for."""
    return held.node is not None and name.startswith(("std::", "boost::"))


def base(machine: Machine, type_: Type, given: Sequence[Argument], node: Node, frame: Frame) -> Value:
    """Make the part of an object that is of a base class which the program does not have itself."""
    from launchlint.extract.cpp.calls import Call

    name = known_name(machine, type_)
    if name in machine.tables.bases:
        return modelled(Call(machine, name, type_.arguments, given, node, frame), machine.tables.bases[name])
    space = frame.scope.partition("::")[0]
    silent = is_silent(name) or (space and "::" not in name and is_silent(f"{space}::{name}"))
    if not (type_.member or machine.tables.known(name) or silent or not name):
        machine.doubt_all(f"the base class {name} is not in these sources", frame.path, node.line)
        machine.serial += 1
        return Thing(type_, None, machine.serial)
    return make(machine, type_, given, node, frame)


def _elsewhere(machine: Machine, name: str, given: Sequence[Argument], frame: Frame) -> str | None:
    """The header that a class comes with which is not here and may talk; None where it is a message, or silent."""
    header = machine.foreign.header_of(name, (frame.scope.partition("::")[0], *machine.declarations.used))
    package, _, last = name.rpartition("::")
    if machine.tables.known(package):
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
    known = asked.machine.tables.functions
    if name in known:
        return known[name](asked)
    if "::" in name:
        first, _, rest = name.partition("::")
        namespaces = asked.machine.declarations.namespaces
        if first in namespaces and f"{namespaces[first]}::{rest}" in known:
            return known[f"{namespaces[first]}::{rest}"](asked)
        resolved = asked.machine.names.resolve(Type(name.rpartition("::")[0]), asked.frame)
        full = f"{resolved.name}::{name.rpartition('::')[2]}"
        if full in known:
            return known[full](asked._replace(types=asked.types or resolved.arguments))
    elif f"rclcpp::{name}" in known and name not in asked.machine.declarations.functions and _is_given_node(asked):
        return known[f"rclcpp::{name}"](asked)  # found without its namespace because of what it is given: spin(node)
    for used in asked.machine.declarations.used:
        if f"{used}::{name}" in known and used.startswith(asked.machine.tables.spaces):
            return known[f"{used}::{name}"](asked)
    return None


def _is_given_node(asked: Call) -> bool:
    return any(held.node is not None for each in asked.arguments if (held := node_of(each.value)) is not None)


def handle_method(handle: Handle, asked: Call) -> Value | None:
    """A member function of a node handle; None where it is none that is known."""
    method_ = asked.machine.tables.of_handle.get(asked.name)
    return None if method_ is None else method_(handle, asked)


_OF_POINTERS = frozenset(("get", "lock"))
"""What a pointer to a node has, and the node itself has not: a function of the program may be called so."""


def own_method(this: Thing, asked: Call) -> Value | None:
    """A member function that an object has from a base class of ROS; None where that is not known."""
    machine = asked.machine
    answer = machine.tables.of_object(this, asked)
    if answer is not None:
        return answer
    held = this.fields.get("<handle>")
    is_member = asked.name in machine.tables.of_handle and asked.name not in _OF_POINTERS
    if held is not None and isinstance(held.value, Handle) and is_member:
        return handle_method(held.value, asked)
    if this.declared is not None:
        for declared in [this.declared, *machine.names.bases(this.declared.name)]:
            for base in declared.bases:
                resolved = machine.names.resolve(base, Frame("", declared.name, this, this.bindings))
                known = machine.tables.methods.get((known_name(machine, resolved), asked.name))
                if known is not None:
                    return known(this, asked._replace(types=asked.types or resolved.arguments))
    return None


def method(this: Thing, asked: Call) -> Value | None:
    """A member function of an object of a class of ROS; None where it is none that is known."""
    known = asked.machine.tables.methods.get((this.type.name, asked.name))
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
    return machine.tables.is_handle(machine.names.resolve(type_, frame))

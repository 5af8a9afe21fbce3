"""Calls: of functions and members of the program, of the ROS interface, and of what names go through in the standard library."""

from __future__ import annotations

import re
from collections.abc import Sequence

from launchlint.extract.cpp import classes, overloads, ros, standard
from launchlint.extract.cpp.declarations import Class, Function, joined
from launchlint.extract.cpp.declarators import without_arguments
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.naming import UNKNOWN_SPACE
from launchlint.extract.cpp.places import made_up, read
from launchlint.extract.cpp.ros import loading
from launchlint.extract.cpp.spelled_type import Type, parse_type
from launchlint.extract.cpp.syntax import Node, parse_statements, shortened
from launchlint.extract.cpp.values import (
    NULL,
    UNKNOWN,
    Argument,
    Callable,
    Cell,
    Closure,
    Either,
    Handle,
    Items,
    Null,
    Number,
    Text,
    Thing,
    Unknown,
    Value,
    choices,
    either,
    node_of,
)
from launchlint.extract.fact import ELSEWHERE
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_LONGEST_MACRO = 4_000
_MOST_DISPATCHED = 4
_HARMLESS = re.compile(
    r"^(?!\w+::(?!cout))(?:ROS_|NODELET_|ASSERT|EXPECT|assert|DCHECK|CHECK|LOG|VLOG|printf|fprintf|std::cout|TIME|Q_)|(?:_DEBUG|_INFO|_WARN|_ERROR)\b"
)
_OF_PARAMS = re.compile(r"[Pp]arams?(?:eters?)?(?![a-z])|PARAM|rosparam|param_utils")
"""Functions that are called after params read them, and do nothing else with a node handle."""


class Call(NamedTuple):
    """A call as it is seen by what answers it: the function's name, the template arguments, the arguments, and where it stands."""

    machine: Machine
    name: str
    types: tuple[Type, ...]
    arguments: Sequence[Argument]
    node: Node
    frame: Frame

    def value(self, position: int) -> Value:
        """The value of an argument; UNKNOWN where there is none."""
        return self.arguments[position].value if position < len(self.arguments) else UNKNOWN

    def cell(self, position: int) -> Cell | None:
        """The variable an argument stands in."""
        return self.arguments[position].cell if position < len(self.arguments) else None


def functions(machine: Machine, name: str, frame: Frame) -> list[Function]:
    """The functions of the program that ``name`` means."""
    plain = without_arguments(name)
    if "::" not in plain and frame.this is not None:
        found = classes.own_methods(machine, frame.this, plain, frame.scope)
        if found:
            return found
    found = machine.names.functions(plain, frame.scope)
    if found:
        return found
    if "::" in plain:
        owner, _, last = plain.rpartition("::")
        resolved = machine.names.resolve(Type(owner), frame)
        # A class knows its bases by their own names, whatever namespace they are of.
        bases = [] if frame.this is None else [each.name for each in classes.chain(machine, frame.this) if each.name.endswith(f"::{owner}")]
        for each in (resolved.name, *bases):
            found = machine.declarations.functions.get(joined(each, last), [])
            if found:
                return found
    return []


def call(machine: Machine, node: Node, frame: Frame) -> Value:
    """The value of a call; what it does is followed."""
    function = node.fields.get("function")
    if function is None:
        return UNKNOWN
    if function.kind == "field_expression":
        return _method(machine, node, function, frame)
    types: tuple[Type, ...] = ()
    named = function
    if function.kind == "template_function":
        types, named = template_arguments(function), function.fields.get("name") or function
    elif function.kind == "qualified_identifier":
        last = _last(function)
        if last.kind == "template_function":
            types = template_arguments(last)
    if named.kind not in ("identifier", "qualified_identifier"):
        if function.kind == "primitive_type":
            given = classes.arguments(machine, node.fields.get("arguments"), frame)
            return given[0].value if given else UNKNOWN
        return machine.invoke(machine.evaluate(function, frame), classes.arguments(machine, node.fields.get("arguments"), frame))
    name = "".join(named.text.split()).removeprefix("::")
    if types and named.kind == "qualified_identifier":
        inner = _last(function).fields.get("name")
        prefix = name[: name.rfind("::", 0, name.find("<") if "<" in name else len(name)) + 2]
        name = prefix + (inner.text if inner else "")
    elif function.kind == "qualified_identifier" and "<" in name and not types:
        return _of_template(machine, node, function, name, frame)
    return _named(machine, node, name, types, frame)


def _last(node: Node) -> Node:
    while node.kind == "qualified_identifier":
        inner = node.fields.get("name")
        if inner is None:
            break
        node = inner
    return node


def template_arguments(node: Node) -> tuple[Type, ...]:
    """The arguments between angle brackets."""
    listed = node.fields.get("arguments")
    return tuple(parse_type(each.text) for each in listed.children) if listed else ()


def _of_template(machine: Machine, node: Node, function: Node, name: str, frame: Frame) -> Value:
    """``Base<T>::member(…)`` or ``Type<T>(…)``."""
    given = classes.arguments(machine, node.fields.get("arguments"), frame)
    owner = parse_type(function.text)
    if frame.this is not None and owner.member:
        found = [
            each
            for declared in classes.chain(machine, frame.this)
            if declared.name.rpartition("::")[2] == owner.last
            for each in machine.declarations.functions.get(joined(declared.name, owner.member), [])
        ]
        chosen = overloads.chosen(machine, found, given, frame.this)
        if chosen is not None:
            return machine.call(chosen, frame.this, given)
    if owner.member:
        resolved = machine.names.resolve(owner._replace(member=""), frame)
        found = machine.declarations.functions.get(joined(resolved.name, owner.member), [])
        chosen = overloads.chosen(machine, found, given, None)
        if chosen is not None:
            declared = machine.names.declared(resolved)
            known = dict(zip(declared.template, resolved.arguments, strict=False)) if declared else {}
            return machine.call(chosen, None, given, known)
        answer = ros.function(Call(machine, f"{resolved.name}::{owner.member}", resolved.arguments, given, node, frame))
        if answer is None:
            _from_elsewhere(machine, f"{resolved.name}::{owner.member}", given, node, frame)
            return unanswered(machine, name, given, node, frame)
        return answer
    return classes.construct(machine, owner, given, node, frame)


def _from_elsewhere(machine: Machine, name: str, given: Sequence[Argument], node: Node, frame: Frame) -> None:
    """A function of a header of a ROS package that is not here: it may make names of its own."""
    header = ros.header_of_function(machine, name, given, frame)
    if header is None:
        return
    reason = f"{name} is of {header}, {ELSEWHERE}"
    if _OF_PARAMS.search(name):
        machine.doubt("params", reason, node, frame)
    else:
        machine.doubt_all(reason, frame.path, node.line)


def _named(machine: Machine, node: Node, name: str, types: tuple[Type, ...], frame: Frame) -> Value:
    variable = frame.variable(name)
    given = classes.arguments(machine, node.fields.get("arguments"), frame)
    if variable is not None:
        return machine.invoke(variable.value, given)
    asked = Call(machine, name, types, given, node, frame)
    if "::" not in name and frame.this is not None:
        found = classes.own_methods(machine, frame.this, name, frame.scope)
        if found:
            return _called(machine, found, frame.this, given, types, node, frame)
        cell = classes.member(machine, frame.this, name)
        if cell is not None and isinstance(cell.value, (Callable, Closure)):
            return machine.invoke(cell.value, given)
        answer = ros.own_method(frame.this, asked)
        if answer is not None:
            return answer
    answer = standard.function(asked)
    if answer is not None:
        return answer
    answer = ros.function(asked)
    if answer is None and "::" in name and frame.this is not None:
        answer = _of_ros_base(asked, frame.this)
    if answer is not None:
        return answer
    found = functions(machine, name, frame)
    if found:
        owner = found[0].owner
        this = frame.this if owner and frame.this is not None and classes.is_a(machine, frame.this, owner) else None
        return _called(machine, found, this, given, types, node, frame)
    resolved = machine.names.resolve(Type(name, types), frame)
    if machine.names.declared(resolved) is not None or ros.is_made(machine, resolved):
        return classes.construct(machine, Type(name, types), given, node, frame)
    if name in machine.declarations.calls:
        return _macro(machine, name, node, frame)
    if frame.this is not None and machine.when and frame.this.serial < 0:
        overridden = classes.overriders(machine, frame.this, name)
        if overridden:
            return _overridden(machine, overridden, frame.this, given, types, node, frame)
    for each in types:
        declared = machine.names.declared(machine.names.resolve(each, frame))
        if declared is not None and overloads.talks(machine, declared):
            machine.doubt_all(f"{name} is not in these sources, and may make a {declared.name}", frame.path, node.line)
    if "::" in name:
        _from_elsewhere(machine, resolved.name, given, node, frame)
    return unanswered(machine, name, given, node, frame)


def _of_ros_base(asked: Call, this: Thing) -> Value | None:
    """``Base::member(…)`` of a base class of ROS; None where it is none."""
    owner, _, last = asked.name.rpartition("::")
    resolved = asked.machine.names.resolve(Type(owner), asked.frame)
    return ros.own_method(this, asked._replace(name=last)) if asked.machine.tables.known(resolved.name) else None


def _unread(machine: Machine, name: str, this: Thing | None, given: Sequence[Argument], node: Node, frame: Frame) -> None:
    """A function of the program whose body is not in these sources."""
    declared = machine.declarations.classes.get(name.rpartition("::")[0]) or (this.declared if this is not None else None)
    if classes.is_unread(machine, name, declared, given):
        machine.doubt_all(f"{name} is declared, and its source is not here", frame.path, node.line)


def _called(
    machine: Machine,
    found: Sequence[Function],
    this: Thing | None,
    given: Sequence[Argument],
    types: tuple[Type, ...],
    node: Node,
    frame: Frame,
) -> Value:
    if any(isinstance(each.value, Either) and any(isinstance(one, Handle) for _, one in each.value.choices) for each in given):
        return _each_handle(machine, found, this, given, types, node, frame)
    chosen = overloads.chosen(machine, found, given, this)
    if chosen is None:
        _unread(machine, found[0].name, this, given, node, frame)
        return UNKNOWN
    resolved = tuple(machine.names.resolve(each, frame) for each in types)
    known = dict(zip(chosen.template, resolved, strict=False))
    for parameter, argument in zip(chosen.parameters, given, strict=False):
        _deduce(machine, parameter.type, argument, chosen.template, known, frame)
    return machine.call(chosen, this, given, known)


def _deduce(machine: Machine, type_: Type, argument: Argument, template: tuple[str, ...], known: dict[str, Type], frame: Frame) -> None:
    """Template arguments that follow from the type of an argument."""
    if type_.name in template and type_.name not in known and not type_.arguments:
        if argument.cell is not None and argument.cell.type.name:
            known[type_.name] = machine.names.resolve(argument.cell.type, frame)
        elif isinstance(argument.value, Thing):
            known[type_.name] = argument.value.type
    elif type_.arguments and argument.cell is not None:
        given = argument.cell.type
        if given.last != type_.last:
            given = machine.names.resolve(given, frame)  # the container behind a pointer, or another name of it
        for inner, outer in zip(type_.arguments, given.arguments, strict=False):
            if inner.name in template and inner.name not in known:
                known[inner.name] = machine.names.resolve(outer, frame)


def _each_handle(
    machine: Machine,
    found: Sequence[Function],
    this: Thing | None,
    given: Sequence[Argument],
    types: tuple[Type, ...],
    node: Node,
    frame: Frame,
) -> Value:
    """A function that is given one of several node handles is followed with each of them."""
    position = next(at for at, each in enumerate(given) if isinstance(each.value, Either))
    value = given[position].value
    results: list[tuple[str, Value]] = []
    for condition, each in choices(value):
        one = [*given[:position], given[position]._replace(value=each, cell=None), *given[position + 1 :]]
        machine.conditions.append(condition)
        try:
            results.append((condition, _called(machine, found, this, one, types, node, frame)))
        finally:
            machine.conditions.pop()
    return either(results)


def _overridden(
    machine: Machine,
    found: Sequence[tuple[Class, list[Function]]],
    this: Thing,
    given: Sequence[Argument],
    types: tuple[Type, ...],
    node: Node,
    frame: Frame,
) -> Value:
    """A virtual function of an object whose class is not known is followed in each class that has it."""
    results: list[tuple[str, Value]] = []
    for declared, candidates in found:
        other = Thing(Type(declared.name), declared, this.serial, this.bindings)
        other.fields = this.fields

        if len(found) > 1 and not any(overloads.tells(machine, each) for each in candidates):
            # Objects that call each other in this way are more ways than can be followed: what makes no name itself is, a few times.
            machine.dispatched[candidates[0]] = machine.dispatched.get(candidates[0], 0) + 1
            if machine.dispatched[candidates[0]] > _MOST_DISPATCHED:
                results.append(("", UNKNOWN))
                continue

        def run(candidates: list[Function] = candidates, other: Thing = other) -> str:
            results.append(("", _called(machine, candidates, other, given, types, node, frame)))
            return ""

        machine.branch([(f"it is a {declared.name}" if len(found) > 1 else "", run)])
    return either(results)


def _method(machine: Machine, node: Node, function: Node, frame: Frame) -> Value:
    argument, named, operator = function.fields.get("argument"), function.fields.get("field"), function.fields.get("operator")
    if argument is None or named is None:
        return UNKNOWN
    types: tuple[Type, ...] = ()
    name = named.text
    if named.kind in ("template_method", "template_function", "dependent_name"):
        inner = named.children[0] if named.kind == "dependent_name" and named.children else named
        types = template_arguments(inner)
        name = (inner.fields.get("name") or inner).text
    value, cell = read(machine, argument, frame)
    given = classes.arguments(machine, node.fields.get("arguments"), frame)
    asked = Call(machine, name, types, given, node, frame)
    dot = operator is not None and operator.text == "."
    if (
        dot
        and cell is not None
        and name in ("reset", "swap")
        and (not isinstance(value, Thing) or classes.is_pointer_type(machine, cell.type, frame))
    ):
        machine.write(cell, given[0].value if given else NULL)
        return UNKNOWN
    if dot and name in ("get", "release", "lock", "value", "toStdString") and not given and not isinstance(value, Handle):
        if isinstance(value, Thing) and not classes.methods(machine, value, name):
            return value
        if isinstance(value, Text):
            return value
    if isinstance(value, (Unknown, Null)) and cell is not None and cell.type.name:
        value = made_up(machine, cell, frame) or _bare(machine, cell, frame) or value
    if isinstance(value, (Unknown, Null)):
        return _on_unknown(asked, cell)
    results: list[tuple[str, Value]] = []
    for condition, each in choices(value):
        if condition:
            machine.conditions.append(condition)
        try:
            results.append((condition, _on(asked, each, cell)))
        finally:
            if condition:
                machine.conditions.pop()
    return either(results)


def _bare(machine: Machine, cell: Cell, frame: Frame) -> Value | None:
    """A value for a variable of a ROS class that was never seen to be made."""
    resolved = machine.names.resolve(cell.type, frame)
    tables = machine.tables
    if resolved.name in tables.bare or (not resolved.member and any(owner == resolved.name for owner, _ in tables.methods)):
        return Thing(resolved, None, -1)
    return None


def _on(asked: Call, value: Value, cell: Cell | None) -> Value:
    """A member function of a value that is known."""
    machine, frame = asked.machine, asked.frame
    if isinstance(value, Handle):
        answer = ros.handle_method(value, asked)
        return unanswered(machine, asked.name, asked.arguments, asked.node, frame) if answer is None else answer
    if isinstance(value, (Text, Items)):
        return standard.method(value, asked, cell)
    if not isinstance(value, Thing):
        return unanswered(machine, asked.name, asked.arguments, asked.node, frame)
    asked = loading.told_its_name(value, asked)
    found = classes.methods(machine, value, asked.name)
    if found:
        return _called(machine, found, value, asked.arguments, asked.types, asked.node, frame)
    if value.declared is not None:
        if value.serial < 0:
            overridden = classes.overriders(machine, value, asked.name)
            if overridden:
                return _overridden(machine, overridden, value, asked.arguments, asked.types, asked.node, frame)
        held = classes.member(machine, value, asked.name)
        if held is not None and isinstance(held.value, (Callable, Closure)):
            return machine.invoke(held.value, asked.arguments)
        answer = ros.own_method(value, asked)
        if answer is not None:
            return answer
        for declared in classes.chain(machine, value):
            _unread(machine, joined(declared.name, asked.name), value, asked.arguments, asked.node, frame)
    answer = ros.method(value, asked)
    if answer is None:
        answer = standard.thing_method(value, asked)
    return unanswered(machine, f"{value.type.last}::{asked.name}", asked.arguments, asked.node, frame) if answer is None else answer


def _on_unknown(asked: Call, cell: Cell | None) -> Value:
    machine, frame = asked.machine, asked.frame
    machine.unseen.blind.setdefault(asked.name)
    category = machine.tables.categories.get(asked.name)
    if category and asked.arguments:
        if ros.may_be_handle(machine, cell, frame):
            answer = ros.handle_method(Handle(UNKNOWN_SPACE), asked)
            if answer is not None:
                return answer
        elif asked.types and category != "params" and (cell is None or not cell.type.name):
            machine.doubt(category, f"{asked.name} is called of what may be a node handle: {shortened(asked.node.text)}", asked.node, frame)
    return (
        standard.method(UNKNOWN, asked, cell)
        if asked.name in standard.CHANGING
        else unanswered(machine, asked.name, asked.arguments, asked.node, frame)
    )


def unanswered(machine: Machine, name: str, given: Sequence[Argument], node: Node, frame: Frame) -> Value:
    """A function that is not in these sources: functions it is given may be called; with a node handle it may do anything."""
    for each in given:
        if each.cell is not None and not _HARMLESS.search(name) and isinstance(each.value, (Number, Null, Text)):
            each.cell.changing = True  # by reference or pointer: what it holds from here on is not certain
            if isinstance(each.value, Text) and each.node is not None and each.node.kind == "pointer_expression":
                machine.write(each.cell, either([("", each.value), ("", UNKNOWN)]))
        for _, value in choices(each.value):
            if isinstance(value, (Callable, Closure)):
                machine.later(value, machine.when)
            elif (held := node_of(value)) is not None and not _HARMLESS.search(name) and not ros.is_plain(name, held):
                reason = f"{name} is given a {held.word}, and is not in these sources"
                if _OF_PARAMS.search(name):
                    machine.doubt("params", reason, node, frame)
                else:
                    machine.doubt_all(reason, frame.path, node.line)
    return UNKNOWN


def _macro(machine: Machine, name: str, node: Node, frame: Frame) -> Value:
    """A macro with arguments: its text with the arguments put in."""
    parameters, text = machine.declarations.calls[name]
    listed = node.fields.get("arguments")
    given = [each.text for each in listed.children] if listed else []
    if len(given) != len(parameters) or len(text) > _LONGEST_MACRO or machine.depth > 60:
        return UNKNOWN
    known = dict(zip(parameters, given, strict=True))
    text = re.sub(r"(?<!#)#(\w+)(?!#)", lambda match: f'"{known[match[1]]}"' if match[1] in known else match[0], text)
    text = re.sub(r"\b\w+\b", lambda match: known.get(match[0], match[0]), text).replace("##", "")
    body = parse_statements(text) if len(text) <= 4 * _LONGEST_MACRO else None
    if body is not None:
        for each in body.walk():
            each.line = node.line
        machine.execute(body, frame)
    return UNKNOWN

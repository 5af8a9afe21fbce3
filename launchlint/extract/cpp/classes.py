"""Objects: how they are made, what their members are, which function a call means."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.extract.cpp import overloads
from launchlint.extract.cpp.declarations import Class, Field, Function, joined
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.spelled_type import DOUBLES, INTEGERS, LISTS, MAPPINGS, TEXTS, UNTYPED, Type
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import (
    MOST_ITEMS,
    NULL,
    UNKNOWN,
    Argument,
    Cell,
    Either,
    Handle,
    Items,
    Number,
    Text,
    Thing,
    Value,
    choices,
    node_of,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_MOST_SUBCLASSES = 8
_OF_ROS = (
    "ros::",
    "tf::",
    "tf2_ros::",
    "image_transport::",
    "actionlib::",
    "message_filters::",
    "dynamic_reconfigure::",
    "diagnostic_updater::",
    "rclcpp::",
    "rclcpp_action::",
    "rclcpp_lifecycle::",
)
COPIED = frozenset(("rclcpp::QoS", "rcl_interfaces::msg::ParameterDescriptor"))
"""Objects of libraries that are changed bit by bit and handed on by value."""
_OF_NODELETS = {"nh_": "", "pnh_": "~"}
LAZY = frozenset(("ConnectionBasedNodelet", "DiagnosticNodelet"))
"""Base classes of nodelets, of other packages, that keep these node handles and subscribe while there are listeners."""


# -- making ---------------------------------------------------------------------------------------------------------------


def arguments(machine: Machine, node: Node | None, frame: Frame) -> list[Argument]:
    """The arguments of a call, evaluated."""
    found: list[Argument] = []
    for each in node.children if node else ():
        if each.kind in _PLACES:
            found.append(machine.argument(each, frame))
            continue
        if each.kind.startswith("preproc"):
            continue
        cell = _pointed_to(machine, each, frame) if each.kind == "pointer_expression" else None
        found.append(Argument(machine.evaluate(each, frame), cell, each))
    return found


def _pointed_to(machine: Machine, node: Node, frame: Frame) -> Cell | None:
    from launchlint.extract.cpp.places import cell_of

    return cell_of(machine, node, frame)


_PLACES = frozenset(("identifier", "field_expression", "qualified_identifier", "parenthesized_expression"))


def construct(machine: Machine, type_: Type, given: Sequence[Argument], node: Node, frame: Frame) -> Value:
    """Make an object of ``type_``: what its constructor does is followed."""
    from launchlint.extract.cpp import ros

    if is_pointer_type(machine, type_, frame):
        return given[0].value if given else NULL
    resolved = machine.names.resolve(type_, frame)
    name = resolved.name
    if name in TEXTS or resolved.last in ("string", "basic_string"):
        first = given[0].value if given else Text("")
        return first if isinstance(first, (Text, Either)) else UNKNOWN
    if name in DOUBLES or name in INTEGERS or name == "bool":
        return converted(machine, given[0].value, resolved, frame) if given else UNKNOWN
    if name in LISTS or name in MAPPINGS:
        contain(machine, type_ if type_.name == name else resolved, frame)
    if name in LISTS:
        if len(given) == 1 and isinstance(given[0].value, Items):
            return given[0].value
        return _filled_list(resolved, given) if given else Items(())
    declared = machine.names.declared(resolved)
    if declared is None or ros.is_made(machine, resolved):
        return ros.make(machine, resolved, given, node, frame)
    if len(given) == 1 and isinstance(given[0].value, Thing) and is_a(machine, given[0].value, declared.name):
        return given[0].value
    return make(machine, declared, resolved, given, node, frame)


def contain(machine: Machine, type_: Type, frame: Frame) -> None:
    """Note the classes of which a container may make objects by itself: of those that it holds, and does not point to."""
    for each in type_.arguments[:2]:
        declared = None if is_pointer_type(machine, each, frame) else machine.names.declared(machine.names.resolve(each, frame))
        if declared is not None:
            machine.unseen.contained.setdefault(declared)


def _filled_list(type_: Type, given: Sequence[Argument]) -> Value:
    """``std::vector<std::string>(length, text)``. What else lists are made of does not matter to names."""
    length = given[0].value
    if not isinstance(length, Number) or isinstance(length.value, bool) or not 0 <= length.value <= MOST_ITEMS or len(given) > 2:
        return UNKNOWN
    if not type_.arguments or type_.arguments[0].name not in TEXTS:
        return UNKNOWN
    return Items((given[1].value if len(given) == 2 else Text(""),) * int(length.value))


def make(machine: Machine, declared: Class, type_: Type, given: Sequence[Argument], node: Node, frame: Frame) -> Value:
    """Make an object of a class of the program."""
    machine.serial += 1
    thing = Thing(type_, declared, machine.serial, dict(zip(declared.template, type_.arguments, strict=False)))
    machine.unseen.made.setdefault(declared, thing)
    if not machine.step() or declared in machine.making:
        return thing
    machine.depth += 2
    machine.making.append(declared)
    try:
        begin(machine, thing, declared, given, node, frame)
    finally:
        machine.depth -= 2
        machine.making.pop()
    return thing


def make_loaded(machine: Machine, entry: str, path: str, given: Sequence[Argument]) -> Value:
    """Make an object of the class that a plugin description or a macro in ``path`` calls ``entry``, as its loader does.

    UNKNOWN where the sources do not have the class, which is a doubt about everything.
    """
    name = entry.removeprefix("::")
    frame = Frame(path, "", None, {})
    resolved = machine.names.resolve(Type(name), frame)
    declared = machine.names.declared(resolved)
    if declared is None:
        # A macro inside of a namespace registers a class by the end of its name.
        ending = [each for full, each in machine.declarations.classes.items() if full.endswith(f"::{name}")]
        if len(ending) != 1:
            machine.doubt_all(f"the class {name[:200]} was not found in these sources", path, 1)
            return UNKNOWN
        declared, resolved = ending[0], Type(ending[0].name)
    return make(machine, declared, resolved, given, Node("declaration", b"", 0, 0), frame)


def begin(machine: Machine, thing: Thing, declared: Class, given: Sequence[Argument], node: Node, frame: Frame) -> None:
    """Run the constructor of ``declared`` (the object's class, or a base of it) on an object."""
    constructors = [
        each for each in machine.declarations.functions.get(joined(declared.name, declared.name.rpartition("::")[2]), []) if each.body
    ]
    chosen_one = overloads.chosen(machine, constructors, given, None)
    if chosen_one is not None:
        machine.call(chosen_one, thing, given)
        return
    name = joined(declared.name, declared.name.rpartition("::")[2])
    if is_unread(machine, name, declared, given):
        machine.doubt_all(f"the constructor of {declared.name} is not in these sources", frame.path, node.line)
    inner = Frame(declared.path, declared.name, thing, dict(bindings_in(machine, thing, declared)))
    inherited = given if not machine.declarations.functions.get(name) else ()
    _members(machine, thing, declared, {}, inner, node, inherited)
    if not declared.bases:
        for (field, _), each in zip(declared.fields.items(), inherited, strict=False):
            machine.write(thing.fields[field], each.value)  # Point{1, 2}: its members, one by one


def is_unread(machine: Machine, name: str, declared: Class | None, given: Sequence[Argument]) -> bool:
    """Whether a function is declared, its body is not in these sources, and it may have to do with names of ROS.

    It may if its class has members of ROS, if its header includes headers of ROS, or if it is given a node handle.
    """
    found = machine.declarations.functions.get(name, [])
    if not found or any(each.body is not None for each in found) or not any(each.absent for each in found):
        return False
    return found[0].path in machine.declarations.of_ros or _talks(declared, given)


def _talks(declared: Class | None, given: Sequence[Argument]) -> bool:
    """Whether a class may have to do with names of ROS, by its members and what it is given."""
    if declared is None:
        return any(node_of(value) is not None for each in given for _, value in choices(each.value))
    return any(node_of(value) is not None for each in given for _, value in choices(each.value)) or any(
        inner.name.startswith(_OF_ROS) for field in declared.fields.values() for inner in (field.type, *field.type.arguments)
    )


def initialise(machine: Machine, function: Function, this: Thing | None, frame: Frame) -> None:
    """The bases and members of an object, as the initialiser list of its constructor says."""
    declared = machine.declarations.classes.get(function.owner)
    if this is None or declared is None:
        return
    listed: dict[str, Node] = {}
    for each in function.initialisers.children if function.initialisers else ():
        if each.kind == "field_initializer" and each.children:
            name = each.children[0].text.partition("<")[0].replace(" ", "").rpartition("::")[2]
            listed[name] = each
    own = listed.get(declared.name.rpartition("::")[2])
    if own is not None and not _is_of_base(own, declared):
        begin(machine, this, declared, arguments(machine, own.child("argument_list", "initializer_list"), frame), own, frame)
        return
    if function.body is not None:
        _members(machine, this, declared, listed, frame, function.body)


def _is_of_base(initialiser: Node, declared: Class) -> bool:
    """Whether an initialiser that is called like the class is that of a base class, which has the same name in another namespace."""
    spelled = initialiser.children[0].text.partition("<")[0].replace(" ", "")
    bases = [base.name for base in declared.bases if base.last == declared.name.rpartition("::")[2]]
    return spelled in bases and spelled != declared.name and "::" in spelled


def _of_alias(machine: Machine, listed: dict[str, Node], declared: Class, base: Type, frame: Frame) -> Node | None:
    """The initialiser of a base that is called by another name there: ``using Base = Filter<Scan>;``."""
    for name, each in listed.items():
        if name not in declared.fields and machine.names.resolve(Type(name), frame).last == base.last:
            return each
    return None


def _members(
    machine: Machine,
    this: Thing,
    declared: Class,
    listed: dict[str, Node],
    frame: Frame,
    node: Node,
    inherited: Sequence[Argument] = (),
) -> None:
    """Make the bases and members; ``inherited`` is what an object without a constructor of its own is given: those of its base take it."""
    for base in declared.bases:
        initialiser = listed.get(base.last) or _of_alias(machine, listed, declared, base, frame)
        given = arguments(machine, initialiser.child("argument_list", "initializer_list"), frame) if initialiser else inherited
        _base(machine, this, base, given, initialiser or node, frame)
    for name, field in declared.fields.items():
        initialiser = listed.get(name)
        type_ = field.type
        if initialiser is not None:
            given = arguments(machine, initialiser.child("argument_list", "initializer_list"), frame)
            if field.pointer:
                value: Value = given[0].value if given else NULL
            else:
                value = construct(machine, type_, given, initialiser, frame)
                if isinstance(value, type(UNKNOWN)) and len(given) == 1 and not type_.name:
                    value = given[0].value
            if field.pointer and given and given[0].cell is not None and not isinstance(given[0].value, (Thing, Handle)):
                this.fields[name] = given[0].cell
                continue
        elif field.initial is not None:
            value = initial_value(machine, field, frame)
        elif (outside := machine.declarations.variables.get(joined(declared.name, name))) is not None and outside.initial is not None:
            value = initial_value(machine, outside, Frame(outside.path, declared.name, None, {}))  # a static member
        elif field.pointer or field.array:
            value = UNKNOWN
            if field.array and not field.pointer:
                contain(machine, Type("", (type_,)), frame)
        else:
            value = default(machine, type_, node, frame)
        cell = this.fields.get(name)
        if cell is None:
            this.fields[name] = machine.cell(value, type_, field.constant)
            this.fields[name].changing = machine.declarations.is_assigned(name)
        else:
            machine.write(cell, value)


def initial_value(machine: Machine, field: Field, frame: Frame) -> Value:
    """What a member or variable is initialised with where it is declared."""
    initial = field.initial
    if initial is None:
        return UNKNOWN
    if initial.kind == "initializer_list" and len(initial.children) == 1 and field.type.name == "char":
        return machine.evaluate(initial.children[0], frame)  # a text in braces: char name[]{"text"}
    if initial.kind == "initializer_list" and not field.array and not is_list(machine, field.type, frame):
        return construct(machine, field.type, arguments(machine, initial, frame), initial, frame)
    if initial.kind == "argument_list":
        return construct(machine, field.type, arguments(machine, initial, frame), initial, frame)
    value = machine.evaluate(initial, frame)
    return value if field.pointer or field.array else converted(machine, value, field.type, frame, initial)


def _base(machine: Machine, this: Thing, base: Type, given: Sequence[Argument], node: Node, frame: Frame) -> None:
    from launchlint.extract.cpp import ros

    resolved = machine.names.resolve(base, frame)
    declared = machine.names.declared(resolved)
    if declared is not None and not ros.is_made(machine, resolved):
        if declared.name != (this.declared.name if this.declared else ""):
            begin(machine, this, declared, given, node, frame)
        return
    value = ros.base(machine, resolved, given, node, frame)
    if isinstance(value, Handle):
        this.fields["<handle>"] = machine.cell(value)
        if value.node is not None:
            machine.objects.append(this)
            machine.unseen.nodes.append(this)
    elif isinstance(value, Thing):
        this.fields.update(value.fields)


def default(machine: Machine, type_: Type, node: Node, frame: Frame) -> Value:
    """The value of a variable that is declared without one."""
    return construct(machine, type_, [], node, frame) if type_.name else UNKNOWN


def is_pointer_type(machine: Machine, type_: Type, frame: Frame) -> bool:
    """Whether it is a smart pointer, or another name of one."""
    meant = machine.names.behind_aliases(type_, frame.scope)
    if meant is None:
        return True
    return meant.name.endswith("Ptr") and machine.names.declared(machine.names.resolve(meant, frame)) is None


def is_list(machine: Machine, type_: Type, frame: Frame) -> bool:
    """Whether it is a container."""
    return machine.names.resolve(type_, frame).name in LISTS or machine.names.resolve(type_, frame).name in (
        "std::map",
        "std::unordered_map",
        "std::pair",
    )


def converted(machine: Machine, value: Value, type_: Type, frame: Frame, node: Node | None = None) -> Value:
    """``value`` as a variable of ``type_`` holds it."""
    if isinstance(value, Number):
        name = type_.name if type_.name in DOUBLES or type_.name in INTEGERS else machine.names.resolve(type_, frame).name
        if name in DOUBLES:
            return Number(float(value.value))
        if name in INTEGERS and (not isinstance(value.value, float) or abs(value.value) < 1e15):
            return Number(int(value.value))
        if name == "bool":
            return Number(bool(value.value))
        if is_pointer_type(machine, type_, frame):
            return NULL
        return value
    if isinstance(value, Thing) and value.type.name in COPIED:
        other = Thing(value.type, None, value.serial)
        other.fields.update({key: Cell(cell.value, cell.type, cell.serial) for key, cell in value.fields.items()})
        return other
    if isinstance(value, Text) and type_.name.endswith("NodeHandle"):
        from launchlint.extract.cpp.naming import below

        return Handle(below("", value.template))
    return value


# -- members --------------------------------------------------------------------------------------------------------------


def chain(machine: Machine, this: Thing) -> list[Class]:
    """The class of an object and its bases."""
    return [] if this.declared is None else machine.names.chain(this.declared)


def is_a(machine: Machine, this: Thing, name: str) -> bool:
    """Whether an object is of a class or of one derived from it."""
    return any(each.name == name for each in chain(machine, this))


def member(machine: Machine, this: Thing | None, name: str) -> Cell | None:
    """A member variable of an object."""
    if this is None:
        return None
    if name in this.fields:
        return this.fields[name]
    for declared in chain(machine, this):
        field = declared.fields.get(name)
        if field is None:
            continue
        inner = Frame(declared.path, declared.name, this, dict(bindings_in(machine, this, declared)))
        value: Value = UNKNOWN
        if field.initial is None:
            outside = machine.declarations.variables.get(joined(declared.name, name))
            if outside is not None and outside.initial is not None:
                value = initial_value(machine, outside, inner)
        elif field.constant:
            value = initial_value(machine, field, inner)
        cell = Cell(value, field.type, 0, field.constant)
        cell.changing = machine.declarations.is_assigned(name)
        this.fields[name] = cell
        return cell
    if name in _OF_NODELETS and any("azy" in base.name or base.last in LAZY for each in chain(machine, this) for base in each.bases):
        this.fields[name] = Cell(Handle(_OF_NODELETS[name]), UNTYPED, 0, True)
        return this.fields[name]
    return None


def bindings_in(machine: Machine, this: Thing, owner: Class | None) -> dict[str, Type]:
    """The template arguments of ``owner``, the object's class or one of its bases."""
    if owner is None or this.declared is None or owner is this.declared:
        return this.bindings
    frames: list[tuple[Class, dict[str, Type]]] = [(this.declared, this.bindings)]
    seen: set[str] = set()
    while frames and len(seen) < 60:
        declared, known = frames.pop(0)
        if declared.name in seen:
            continue
        seen.add(declared.name)
        if declared is owner:
            return known
        frame = Frame("", declared.name, None, known)
        for base in declared.bases:
            resolved = machine.names.resolve(base, frame)
            found = machine.names.declared(resolved)
            if found is not None:
                frames.append((found, dict(zip(found.template, resolved.arguments, strict=False))))
    return {}


def own_methods(machine: Machine, this: Thing, name: str, scope: str) -> list[Function]:
    """The functions that a call without an object means, in a function of the class ``scope``, which the object is derived from.

    It is the one of that class, unless it is virtual; while a constructor runs, the object is of its class and no other.
    """
    classes = chain(machine, this)
    names = [each.name for each in classes]
    if scope not in names[1:]:
        return methods(machine, this, name)
    start = names.index(scope)
    known = [function for each in names[start:] for function in machine.declarations.functions.get(joined(each, name), [])]
    if known and any(each.overrides for each in known):
        making = (each.owner for each in reversed(machine.calls) if each.last == each.owner.rpartition("::")[2])
        start = next((names.index(each) for each in making if each in names), 0)
    elif not known:
        start = 0
    return machine.names.methods_among(classes[start:], name) or methods(machine, this, name)


def methods(machine: Machine, this: Thing, name: str) -> list[Function]:
    """The functions of that name that a call on the object means."""
    return [] if this.declared is None else machine.names.methods(this.declared, name)


def overriders(machine: Machine, this: Thing, name: str) -> list[tuple[Class, list[Function]]]:
    """Derived classes that have the function, for an object of which only a base class is known."""
    if this.declared is None:
        return []
    found = []
    for declared in machine.names.derived(this.declared):
        functions = [each for each in machine.declarations.functions.get(joined(declared.name, name), []) if each.body]
        if functions:
            found.append((declared, functions))
    if any(overloads.tells(machine, each) for _, functions in found[_MOST_SUBCLASSES:] for each in functions):
        reason = f"{name} has more than {_MOST_SUBCLASSES} overriders, of which not all are followed"
        machine.doubt_all(reason, found[0][0].path, found[0][1][0].line)
    return found[:_MOST_SUBCLASSES]

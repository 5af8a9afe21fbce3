"""Places: the variable that an expression names, so that it can be assigned to or handed on by reference."""

from __future__ import annotations

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import UNKNOWN, Callable, Cell, Items, Null, Thing, Unknown, Value, choices, either

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_PAIR = 2


def cell_of(machine: Machine, node: Node | None, frame: Frame) -> Cell | None:
    """The variable that an expression names; None where it names none that is followed."""
    if node is None or not machine.step():
        return None
    machine.depth += 1
    cell = _cell(machine, node, frame)
    machine.depth -= 1
    return cell


def _cell(machine: Machine, node: Node, frame: Frame) -> Cell | None:
    kind = node.kind
    if kind in ("identifier", "type_identifier"):
        name = node.text
        found = frame.variable(name) or classes.member(machine, frame.this, name)
        return found or of_program(machine, name, frame)
    if kind == "field_expression":
        argument = node.fields.get("argument")
        if argument is None:
            return None
        value, cell = _looked_at(machine, argument, frame)
        return _member(machine, _object(machine, value, cell, frame), node)
    if kind == "qualified_identifier":
        text = node.text.replace(" ", "").removeprefix("::")
        owner_name, _, last = text.rpartition("::")
        if frame.this is not None and owner_name and any(each.name.endswith(owner_name) for each in classes.chain(machine, frame.this)):
            found = classes.member(machine, frame.this, last)
            if found is not None:
                return found
        return of_program(machine, text, frame)
    if kind in ("pointer_expression", "parenthesized_expression"):
        inner = node.fields.get("argument") or (node.children[0] if node.children else None)
        return cell_of(machine, inner, frame)
    return None


def of_member(machine: Machine, node: Node, frame: Frame) -> Value:
    """The value of ``a.b`` or ``a->b``."""
    argument = node.fields.get("argument")
    return UNKNOWN if argument is None else _value(machine, *_looked_at(machine, argument, frame), node, frame)


def read(machine: Machine, node: Node, frame: Frame) -> tuple[Value, Cell | None]:
    """The value of an expression, and the variable that it names; what stands before its last dot is evaluated once for both."""
    argument = node.fields.get("argument") if node.kind == "field_expression" else None
    if argument is None:
        cell = cell_of(machine, node, frame)
        return machine.evaluate(node, frame) if cell is None else machine.read(cell), cell
    if not machine.step():
        return UNKNOWN, None
    machine.depth += 1
    try:
        value, cell = _looked_at(machine, argument, frame)
        found = _member(machine, _object(machine, value, cell, frame), node)
        return _value(machine, value, cell, node, frame) if found is None else machine.read(found), found
    finally:
        machine.depth -= 1


def _looked_at(machine: Machine, node: Node, frame: Frame) -> tuple[Value, Cell | None]:
    """What stands before a dot: its value, and the variable that it names where that value is not known.

    It is evaluated once, however many dots follow.
    """
    argument = node.fields.get("argument") if node.kind == "field_expression" else None
    if argument is None:
        value = machine.evaluate(node, frame)
        return value, cell_of(machine, node, frame) if _is_in_doubt(value) else None
    if not machine.step():
        return UNKNOWN, None
    machine.depth += 1
    try:
        before, cell = _looked_at(machine, argument, frame)
        value = _value(machine, before, cell, node, frame)
        return value, _member(machine, _object(machine, before, cell, frame), node) if _is_in_doubt(value) else None
    finally:
        machine.depth -= 1


def _is_in_doubt(value: Value) -> bool:
    return any(isinstance(each, (Null, Unknown)) for _, each in choices(value))


def _value(machine: Machine, before: Value, cell: Cell | None, node: Node, frame: Frame) -> Value:
    """The value of the member that ``node`` names of an object; ``cell`` is the variable of one that nobody made."""
    named = node.fields.get("field")
    if named is None:
        return UNKNOWN
    name = named.text
    if isinstance(before, Items) and name in ("first", "second") and len(before.items) == _PAIR:
        return before.items[0 if name == "first" else 1]
    found: list[tuple[str, Value]] = []
    for condition, each in choices(before):
        owner = each
        if isinstance(each, (Null, Unknown)) and cell is not None and cell.type.name:
            # The same variable may have been given its object a moment ago, for another way that its value may be.
            owner = cell.value if isinstance(cell.value, Thing) else made_up(machine, cell, frame) or each
        if isinstance(owner, Thing):
            member = classes.member(machine, owner, name)
            if member is None:
                functions = classes.methods(machine, owner, name)
                found.append((condition, Callable(tuple(functions), owner) if functions else UNKNOWN))
            else:
                found.append((condition, machine.read(member)))
    return either(found) if found else UNKNOWN


def _object(machine: Machine, value: Value, cell: Cell | None, frame: Frame) -> Thing | None:
    """The object that a value is; one that nobody made is made up where the class of its variable is known."""
    if isinstance(value, (Null, Unknown)) and cell is not None and cell.type.name:
        return cell.value if isinstance(cell.value, Thing) else made_up(machine, cell, frame)
    return next((each for _, each in choices(value) if isinstance(each, Thing)), None)


def _member(machine: Machine, owner: Thing | None, node: Node) -> Cell | None:
    """The member variable that ``node`` names of an object; None where it has none."""
    named = node.fields.get("field")
    if owner is None or named is None or named.kind not in ("field_identifier", "identifier"):
        return None
    found = classes.member(machine, owner, named.text)
    if found is None and owner.declared is None:
        # An object of a library: what is assigned to its members is kept.
        found = owner.fields[named.text] = Cell(UNKNOWN)
    return found


def made_up(machine: Machine, cell: Cell, frame: Frame) -> Thing | None:
    """An object for a variable of which only the class is known. No constructor is followed."""
    resolved = machine.names.resolve(cell.type, frame)
    declared = machine.names.declared(resolved)
    if declared is None:
        return None
    machine.serial += 1
    thing = Thing(resolved, declared, -machine.serial, dict(zip(declared.template, resolved.arguments, strict=False)))
    machine.write(cell, thing)
    return thing


def of_program(machine: Machine, name: str, frame: Frame) -> Cell | None:
    """A variable outside of functions, made when it is first asked for."""
    known = machine.names.variable(name, frame.scope)
    if known is None:
        return None
    full, field = known
    if full in machine.globals:
        return machine.globals[full]
    cell = machine.globals[full] = Cell(UNKNOWN, field.type, 0, field.constant)
    cell.changing = machine.declarations.is_assigned(full.rpartition("::")[2])
    conditions, machine.conditions = machine.conditions, []
    inner = Frame(field.path, field.scope, None, {})
    if field.initial is not None:
        cell.value = classes.initial_value(machine, field, inner)
    elif not field.pointer and not field.array:
        cell.value = classes.default(machine, field.type, Node("declaration", b"", 0, 0), inner)
    machine.conditions = conditions
    return cell

"""Places: the variable that an expression names, so that it can be assigned to or handed on by reference."""

from __future__ import annotations

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.declarations import joined
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import UNKNOWN, Cell, Null, Thing, Unknown, choices

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine


def cell_of(machine: Machine, node: Node | None, frame: Frame) -> Cell | None:
    """The variable that an expression names; None where it names none that is followed."""
    if node is None or not machine.step():
        return None
    machine.depth += 1
    try:
        return _cell(machine, node, frame)
    finally:
        machine.depth -= 1


def _cell(machine: Machine, node: Node, frame: Frame) -> Cell | None:
    kind = node.kind
    if kind in ("identifier", "type_identifier"):
        name = node.text
        found = frame.variable(name) or classes.member(machine, frame.this, name)
        return found or of_program(machine, name, frame)
    if kind == "field_expression":
        named = node.field("field")
        if named is None or named.kind not in ("field_identifier", "identifier"):
            return None
        owner = thing_of(machine, node.field("argument"), frame)
        if owner is None:
            return None
        found = classes.member(machine, owner, named.text)
        if found is None and owner.declared is None:
            # An object of a library: what is assigned to its members is kept.
            found = owner.fields[named.text] = Cell(UNKNOWN)
        return found
    if kind == "qualified_identifier":
        text = node.text.replace(" ", "").removeprefix("::")
        owner_name, _, last = text.rpartition("::")
        if frame.this is not None and owner_name and any(each.name.endswith(owner_name) for each in classes.chain(machine, frame.this)):
            found = classes.member(machine, frame.this, last)
            if found is not None:
                return found
        return of_program(machine, text, frame)
    if kind in ("pointer_expression", "parenthesized_expression"):
        inner = node.field("argument") or (node.children[0] if node.children else None)
        return cell_of(machine, inner, frame)
    return None


def thing_of(machine: Machine, node: Node | None, frame: Frame) -> Thing | None:
    """The object that an expression names; one that nobody made is made up where its class is known."""
    if node is None:
        return None
    value = machine.evaluate(node, frame)
    for _, each in choices(value):
        if isinstance(each, Thing):
            return each
    if isinstance(value, (Null, Unknown)):
        cell = cell_of(machine, node, frame)
        if cell is not None and cell.type.name:
            return made_up(machine, cell, frame)
    return None


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
    declarations = machine.declarations
    for scope in machine.names.scopes(frame.scope):
        full = joined(scope, name)
        if full in machine.globals:
            return machine.globals[full]
        field = declarations.variables.get(full)
        if field is None:
            owner, _, last = full.rpartition("::")
            declared = declarations.classes.get(owner)
            field = declared.fields.get(last) if declared is not None and "::" in name else None
        if field is not None:
            cell = machine.globals[full] = Cell(UNKNOWN, field.type, 0, field.constant)
            cell.changing = machine.declarations.is_assigned(full.rpartition("::")[2])
            conditions, machine.conditions = machine.conditions, []
            inner = Frame(field.path, field.scope, None, {})
            if field.initial is not None:
                cell.value = classes.initial_value(machine, field, inner)
            elif not field.pointer and not field.array:
                source = Node("declaration", b"", 0, 0)
                cell.value = classes.default(machine, field.type, source, inner)
            machine.conditions = conditions
            return cell
    return None

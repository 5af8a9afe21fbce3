"""Expressions: the values of those that names can be made of."""

from __future__ import annotations

import re

from launchlint.extract.cpp import calls, classes
from launchlint.extract.cpp.declarations import joined
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.naming import ANY, braced, template, together
from launchlint.extract.cpp.spelled_type import Type, parse_type
from launchlint.extract.cpp.syntax import Node, parse_expression
from launchlint.extract.cpp.values import (
    NULL,
    UNKNOWN,
    Callable,
    Cell,
    Closure,
    Handle,
    Items,
    Null,
    Number,
    Text,
    Thing,
    Value,
    choices,
    either,
    plain,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_ESCAPES = {"n": "\n", "t": "\t", "0": "", "r": "", "\\": "\\", '"': '"', "'": "'", "/": "/"}
_LONGEST_TEXT = 2_000
_STREAMS = ("stringstream", "ostringstream")
_WRAPPED = ("parenthesized_expression", "condition_clause")


def evaluate(machine: Machine, node: Node, frame: Frame) -> Value:
    """The value of an expression."""
    kind = node.kind
    if kind in ("identifier", "field_expression", "qualified_identifier"):
        return _named(machine, node, frame)
    if kind == "call_expression":
        return calls.call(machine, node, frame)
    if kind in ("string_literal", "raw_string_literal", "concatenated_string"):
        return _literal(machine, node, frame)
    if kind == "number_literal":
        return _number(node.text)
    if kind in ("true", "false"):
        return Number(kind == "true")
    if kind in ("null", "nullptr"):
        return NULL
    if kind == "char_literal":
        return Text(braced(_unescaped(node.text[1:-1])))
    if kind in _WRAPPED:
        inner = node.field("value") or (node.children[0] if node.children else None)
        return machine.evaluate(inner, frame)
    if kind == "this":
        return frame.this or UNKNOWN
    if kind == "binary_expression":
        return _binary(machine, node, frame)
    if kind == "assignment_expression":
        return _assignment(machine, node, frame)
    if kind == "conditional_expression":
        return _conditional(machine, node, frame)
    if kind == "unary_expression":
        return _unary(machine, node, frame)
    if kind == "pointer_expression":
        return _pointer(machine, node, frame)
    if kind == "subscript_expression":
        return _subscript(machine, node, frame)
    if kind == "lambda_expression":
        return Closure(node, frame)
    if kind == "new_expression":
        type_, given = node.field("type"), node.field("arguments")
        if type_ is None:
            return UNKNOWN
        return classes.construct(machine, parse_type(type_.text), classes.arguments(machine, given, frame), node, frame)
    if kind == "compound_literal_expression":
        type_, value = node.field("type"), node.field("value")
        if type_ is None:
            return UNKNOWN
        return classes.construct(machine, parse_type(type_.text), classes.arguments(machine, value, frame), node, frame)
    if kind == "cast_expression":
        return _cast(machine, node, frame)
    if kind == "initializer_list":
        return Items(tuple(machine.evaluate(each, frame) for each in node.children[:200]))
    if kind == "comma_expression":
        value: Value = UNKNOWN
        for each in node.children:
            value = machine.evaluate(each, frame)
        return value
    if kind == "update_expression":
        return _update(machine, node, frame)
    if kind in ("ERROR", "expression_statement", "co_await_expression"):
        for each in node.children:
            machine.evaluate(each, frame)
    return UNKNOWN


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
    if kind == "identifier":
        name = node.text
        found = frame.variable(name) or classes.member(machine, frame.this, name)
        return found or _global(machine, name, frame)
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
        return _global(machine, text, frame)
    if kind in ("pointer_expression", "parenthesized_expression"):
        inner = node.field("argument") or (node.children[0] if node.children else None)
        return cell_of(machine, inner, frame)
    if kind == "subscript_expression":
        argument = node.field("argument")
        owner = cell_of(machine, argument, frame) if argument else None
        if owner is not None and isinstance(owner.value, Thing) and owner.value.type.name == "<elements>":
            key = template(_index(machine, node, frame))
            fields = owner.value.fields
            if key not in fields:
                fields[key] = Cell(UNKNOWN)
            return fields[key]
    return None


def thing_of(machine: Machine, node: Node | None, frame: Frame) -> Thing | None:
    """The object that an expression names; one that nobody made is made up where its class is known."""
    if node is None:
        return None
    value = machine.evaluate(node, frame)
    for _, each in choices(value):
        if isinstance(each, Thing):
            return each
    if isinstance(value, (Null, type(UNKNOWN))):
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


def _global(machine: Machine, name: str, frame: Frame) -> Cell | None:
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
            conditions, machine.conditions = machine.conditions, []
            inner = Frame(field.path, field.scope, None, {})
            if field.initial is not None:
                cell.value = classes._initial(machine, field, inner)
            elif not field.pointer and not field.array:
                source = Node("declaration", 1, b"", 0, 0)
                cell.value = classes.default(machine, field.type, source, inner)
            machine.conditions = conditions
            return cell
    return None


def _named(machine: Machine, node: Node, frame: Frame) -> Value:
    if node.kind == "field_expression":
        return _field(machine, node, frame)
    cell = _cell(machine, node, frame)
    if cell is not None:
        return machine.read(cell)
    name = node.text.replace(" ", "").removeprefix("::")
    functions = calls.functions(machine, name, frame)
    if functions:
        return Callable(tuple(functions))
    return constant(machine, name, frame)


def constant(machine: Machine, name: str, frame: Frame) -> Value:
    """The value of a macro or of an enumerator."""
    if name in machine.declarations.macros and machine.depth < 60:
        text = machine.declarations.macros[name]
        if len(text) < 500 and text != name:
            return machine.evaluate(parse_expression(text), Frame(frame.path, "", None, {}))
        return UNKNOWN
    if name in ("M_PI", "NAN", "INFINITY"):
        return Number(3.141592653589793) if name == "M_PI" else UNKNOWN
    for scope in machine.names.scopes(frame.scope):
        full = joined(scope, name)
        if full in machine.declarations.constants:
            value = machine.declarations.constants[full]
            return machine.evaluate(value, frame) if value is not None else UNKNOWN
    return UNKNOWN


def _field(machine: Machine, node: Node, frame: Frame) -> Value:
    argument, named = node.field("argument"), node.field("field")
    if argument is None or named is None:
        return UNKNOWN
    value = machine.evaluate(argument, frame)
    name = named.text
    if isinstance(value, Items) and name in ("first", "second") and len(value.items) == 2:
        return value.items[0 if name == "first" else 1]
    found: list[tuple[str, Value]] = []
    for condition, each in choices(value):
        if isinstance(each, (Null, type(UNKNOWN))):
            cell = cell_of(machine, argument, frame)
            made = made_up(machine, cell, frame) if cell is not None and cell.type.name else None
            each = made or each
        if isinstance(each, Thing):
            member = classes.member(machine, each, name)
            if member is None:
                functions = classes.methods(machine, each, name)
                found.append((condition, Callable(tuple(functions), each) if functions else UNKNOWN))
            else:
                found.append((condition, machine.read(member)))
    return either(found) if found else UNKNOWN


def _literal(machine: Machine, node: Node, frame: Frame) -> Value:
    if node.kind == "concatenated_string":
        value: Value = Text("")
        for each in node.children:
            value = together(value, machine.evaluate(each, frame))
        return value
    if node.kind == "raw_string_literal":
        content = node.child("raw_string_content")
        return Text(braced(content.text if content else "")[:_LONGEST_TEXT])
    text = node.text
    return Text(braced(_unescaped(text[text.find('"') + 1 : text.rfind('"')]))[:_LONGEST_TEXT])


def _unescaped(text: str) -> str:
    return re.sub(r"\\(.)", lambda match: _ESCAPES.get(match[1], match[1]), text) if "\\" in text else text


def _number(text: str) -> Value:
    plain_text = text.replace("'", "").rstrip("fFlLuU") if not text.lower().startswith("0x") else text.rstrip("lLuU")
    if len(plain_text) > 40:
        return UNKNOWN
    try:
        if any(char in plain_text for char in ".eE") and not plain_text.lower().startswith("0x"):
            return Number(float(plain_text))
        if text[-1:] in "fF" and not plain_text.lower().startswith("0x"):
            return Number(float(plain_text))
        if len(plain_text) > 1 and plain_text[0] == "0" and plain_text.isdigit():
            return Number(int(plain_text, 8))
        return Number(int(plain_text, 0))
    except ValueError:
        return UNKNOWN


def _binary(machine: Machine, node: Node, frame: Frame) -> Value:
    # a + b + c + … leans to the left: its left side is gone down in a loop.
    spine: list[Node] = []
    inner: Node | None = node
    while inner is not None and inner.kind == "binary_expression":
        spine.append(inner)
        inner = inner.field("left")
    value = machine.evaluate(inner, frame)
    for each in reversed(spine):
        operator = each.field("operator")
        sign = operator.text if operator else ""
        right = each.field("right")
        if sign in ("&&", "||") and isinstance(value, Number):
            if bool(value.value) is (sign == "||"):
                continue
            value = machine.evaluate(right, frame)
            continue
        if not machine.step():
            return UNKNOWN
        value = _combined(machine, sign, value, machine.evaluate(right, frame))
    return value


def _combined(machine: Machine, sign: str, left: Value, right: Value) -> Value:
    if sign == "<<" and isinstance(left, Thing):
        if left.type.last in _STREAMS:
            cell = left.fields.setdefault("<text>", Cell(Text("")))
            machine.write(cell, together(cell.value, right))
        return left
    if sign == "%" and isinstance(left, Thing) and left.type.last == "format":
        cell = left.fields.setdefault("<text>", Cell(UNKNOWN))
        if isinstance(cell.value, Text):
            machine.write(cell, Text(filled(cell.value.template, template(right))))
        return left
    if sign == "+":
        texts = [each for side in (left, right) for _, each in choices(side) if isinstance(each, Text)]
        if texts:
            found = together(left, right)
            return found if not isinstance(found, Text) or len(found.template) <= _LONGEST_TEXT else UNKNOWN
    if sign in ("==", "!="):
        return _equal(left, right, sign == "==")
    if sign in ("&&", "||"):
        if isinstance(right, Number) and bool(right.value) is (sign == "||"):
            return Number(bool(right.value))
        return UNKNOWN
    if isinstance(left, Number) and isinstance(right, Number):
        return _arithmetic(sign, left.value, right.value)
    return UNKNOWN


def filled(text: str, value: str) -> str:
    """A format with its first place filled in (boost::format, printf)."""
    match = re.search(r"%(?:\d+%|\d+\$\w|[-+ #0]*\d*(?:\.\d+)?(?:hh|h|ll|l|z)?[a-zA-Z])", text)
    return text if match is None else text[: match.start()] + value + text[match.end() :]


def _equal(left: Value, right: Value, wanted: bool) -> Value:
    first, second = plain(left), plain(right)
    if isinstance(left, Null) or isinstance(right, Null):
        other = right if isinstance(left, Null) else left
        return (
            Number((isinstance(other, Null)) is wanted)
            if isinstance(other, (Null, Thing, Callable)) and isinstance(other, Null)
            else UNKNOWN
        )
    if first is None or second is None or isinstance(left, Text) is not isinstance(right, Text):
        return UNKNOWN
    if isinstance(left, Number) and isinstance(right, Number):
        return Number((left.value == right.value) is wanted)
    return Number((first == second) is wanted)


def _arithmetic(sign: str, left: float, right: float) -> Value:
    if abs(left) > 1e15 or abs(right) > 1e15:
        return UNKNOWN
    whole = isinstance(left, int) and isinstance(right, int)
    if sign in ("+", "-", "*"):
        return Number(left + right if sign == "+" else left - right if sign == "-" else left * right)
    if sign == "/" and right:
        return Number(int(left / right) if whole else left / right)
    if sign == "%" and whole and right:
        return Number(int(left) % int(right))
    if sign in ("<", ">", "<=", ">="):
        return Number({"<": left < right, ">": left > right, "<=": left <= right, ">=": left >= right}[sign])
    return UNKNOWN


def _assignment(machine: Machine, node: Node, frame: Frame) -> Value:
    left, right, operator = node.field("left"), node.field("right"), node.field("operator")
    value = machine.evaluate(right, frame)
    cell = cell_of(machine, left, frame)
    if cell is None:
        if left is not None and left.kind == "subscript_expression":
            _store(machine, left, value, frame)
        return value
    sign = operator.text if operator else "="
    if sign == "+=":
        texts = isinstance(cell.value, Text) or isinstance(value, Text)
        value = together(cell.value, value) if texts else _combined(machine, "+", cell.value, value)
        if isinstance(value, Text) and len(value.template) > _LONGEST_TEXT:
            value = UNKNOWN
    elif sign != "=":
        value = UNKNOWN
    elif cell.type.name:
        value = classes.converted(machine, value, cell.type, frame, node)
        if (
            isinstance(value, Text)
            and not value.param
            and cell.type.name not in ("std::string", "string")
            and left is not None
            and value.template == ""
        ):
            value = Text("")
    machine.write(cell, value)
    return value


def _store(machine: Machine, left: Node, value: Value, frame: Frame) -> None:
    """``a[key] = value``: of a list with a number, or of a map."""
    cell = cell_of(machine, left.field("argument"), frame)
    if cell is None:
        return
    index = _index(machine, left, frame)
    if (
        isinstance(cell.value, Items)
        and isinstance(index, Number)
        and isinstance(index.value, int)
        and 0 <= index.value < len(cell.value.items)
    ):
        items = list(cell.value.items)
        items[index.value] = value
        machine.write(cell, Items(tuple(items)))
    elif isinstance(cell.value, Items):
        machine.write(cell, UNKNOWN)


def _index(machine: Machine, node: Node, frame: Frame) -> Value:
    indices = node.field("indices") or node.field("index")
    inner = indices.children[0] if indices and indices.kind == "subscript_argument_list" and indices.children else indices
    return machine.evaluate(inner, frame)


def _subscript(machine: Machine, node: Node, frame: Frame) -> Value:
    value = machine.evaluate(node.field("argument"), frame)
    index = _index(machine, node, frame)
    if isinstance(value, Thing) and value.type.name == "<argv>":
        if isinstance(index, Number) and isinstance(index.value, int) and 1 <= index.value < 1000:
            return Text(f"{{arg:{index.value}}}")
        return UNKNOWN
    if isinstance(value, Items):
        if isinstance(index, Number) and isinstance(index.value, int) and 0 <= index.value < len(value.items):
            return value.items[index.value]
        for pair in value.items:
            if isinstance(pair, Items) and len(pair.items) == 2 and pair.items[0] == index and isinstance(index, Text):
                return pair.items[1]
    return UNKNOWN


def _conditional(machine: Machine, node: Node, frame: Frame) -> Value:
    from launchlint.extract.cpp.statements import condition_text, decided, negated

    condition = node.field("condition")
    known = decided(machine, condition, frame)
    if known is not None:
        return machine.evaluate(node.field("consequence" if known else "alternative"), frame)
    text = condition_text(condition)
    found: list[tuple[str, Value]] = []
    for each, name in ((text, "consequence"), (negated(text), "alternative")):
        machine.conditions.append(each)
        try:
            found.append((each, machine.evaluate(node.field(name), frame)))
        finally:
            machine.conditions.pop()
    return either(found)


def _unary(machine: Machine, node: Node, frame: Frame) -> Value:
    value = machine.evaluate(node.field("argument"), frame)
    operator = node.field("operator")
    sign = operator.text if operator else ""
    if isinstance(value, Number):
        if sign in ("!", "not"):
            return Number(not value.value)
        if sign == "-":
            return Number(-value.value)
        if sign == "+":
            return value
    return UNKNOWN


def _pointer(machine: Machine, node: Node, frame: Frame) -> Value:
    operator, argument = node.field("operator"), node.field("argument")
    if argument is None:
        return UNKNOWN
    if (
        operator is not None
        and operator.text == "&"
        and argument.kind in ("qualified_identifier", "identifier", "template_function", "field_expression")
    ):
        name = argument.text.replace(" ", "").removeprefix("::")
        functions = calls.functions(machine, name, frame)
        if functions and frame.variable(name) is None:
            return Callable(tuple(functions))
    return machine.evaluate(argument, frame)


def _cast(machine: Machine, node: Node, frame: Frame) -> Value:
    type_ = node.field("type")
    value = machine.evaluate(node.field("value"), frame)
    return classes.converted(machine, value, parse_type(type_.text), frame) if type_ is not None else value


def _update(machine: Machine, node: Node, frame: Frame) -> Value:
    cell = cell_of(machine, node.field("argument"), frame)
    if cell is None:
        return UNKNOWN
    operator = node.field("operator")
    before = cell.value
    step = 1 if operator and operator.text == "++" else -1
    machine.write(cell, Number(before.value + step) if isinstance(before, Number) and not isinstance(before.value, bool) else UNKNOWN)
    return before


__all__ = ["ANY", "Handle", "Type"]

"""Expressions: the values of those that names can be made of."""

from __future__ import annotations

from collections.abc import Callable as Does

from launchlint.extract.cpp import calls, classes
from launchlint.extract.cpp.declarations import joined
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.naming import braced, together
from launchlint.extract.cpp.operators import LONGEST_TEXT, combined, literal, number, unescaped
from launchlint.extract.cpp.places import cell_of, of_member
from launchlint.extract.cpp.spelled_type import Type, parse_type
from launchlint.extract.cpp.standard import NPOS
from launchlint.extract.cpp.syntax import Node, parse_expression
from launchlint.extract.cpp.values import (
    MOST_ITEMS,
    NULL,
    UNKNOWN,
    Argument,
    Callable,
    Cell,
    Closure,
    Handle,
    Items,
    Number,
    Text,
    Thing,
    Unknown,
    Value,
    either,
    plain,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_MAPPINGS = ("map", "unordered_map", "M_string")


def _concatenated(machine: Machine, node: Node, frame: Frame) -> Value:
    text: Value = Text("")
    for each in node.children:
        text = together(text, machine.evaluate(each, frame))
    return text


def _wrapped(machine: Machine, node: Node, frame: Frame) -> Value:
    return machine.evaluate(node.fields.get("value") or (node.children[0] if node.children else None), frame)


def _template_function(machine: Machine, node: Node, frame: Frame) -> Value:
    named = node.fields.get("name")
    functions = calls.functions(machine, named.text, frame) if named is not None else []
    types = tuple(machine.names.resolve(each, frame) for each in calls.template_arguments(node))
    return Callable(tuple(functions), types=types) if functions else UNKNOWN


def _lambda(machine: Machine, node: Node, frame: Frame) -> Value:
    return machine.unseen.taken(Closure(node, frame), frame)


def _new(machine: Machine, node: Node, frame: Frame) -> Value:
    type_, given = node.fields.get("type"), node.fields.get("arguments")
    if type_ is None:
        return UNKNOWN
    return classes.construct(machine, parse_type(type_.text), classes.arguments(machine, given, frame), node, frame)


def _compound_literal(machine: Machine, node: Node, frame: Frame) -> Value:
    type_, listed = node.fields.get("type"), node.fields.get("value")
    if type_ is None:
        return UNKNOWN
    if listed is not None and listed.children and classes.is_list(machine, parse_type(type_.text), frame):
        return machine.evaluate(listed, frame)
    return classes.construct(machine, parse_type(type_.text), classes.arguments(machine, listed, frame), node, frame)


def _sequence(machine: Machine, node: Node, frame: Frame) -> Value:
    value: Value = UNKNOWN
    for each in node.children:
        value = machine.evaluate(each, frame)
    return value


def _each(machine: Machine, node: Node, frame: Frame) -> Value:
    """What has no value that a name is made of, and holds expressions that are evaluated."""
    for each in node.children:
        machine.evaluate(each, frame)
    return UNKNOWN


def _pack(machine: Machine, node: Node, frame: Frame) -> Value:
    """``(make<T>(), ...)``, ``make(arguments)...``: done once, and where that makes names, as often as nobody knows."""
    before = set(machine.facts)
    for each in node.children:
        machine.evaluate(each, frame)
    if not before.issuperset(machine.facts):
        machine.doubt_all("names are made for each of a pack of arguments", frame.path, node.line)
    return UNKNOWN


def _named(machine: Machine, node: Node, frame: Frame) -> Value:
    cell = cell_of(machine, node, frame)
    if cell is not None:
        return machine.read(cell)
    name = node.text.replace(" ", "").removeprefix("::")
    functions = calls.functions(machine, name, frame)
    if functions:
        return machine.unseen.taken(Callable(tuple(functions)), frame)
    return constant(machine, name, frame)


def constant(machine: Machine, name: str, frame: Frame) -> Value:
    """The value of a macro or of an enumerator."""
    if name in machine.declarations.macros and machine.depth < 60:
        text = machine.declarations.macros[name]
        if len(text) < 500 and text != name:
            return machine.evaluate(parse_expression(text), Frame(frame.path, "", None, {}))
        return UNKNOWN
    known = machine.tables.values
    if known:
        spelled = (
            name if name in known else next((f"{used}::{name}" for used in machine.declarations.used if f"{used}::{name}" in known), "")
        )
        if not spelled and "::" in name:
            space, _, last = name.rpartition("::")
            spelled = f"{machine.names.resolve(Type(space), frame).name}::{last}"
        if spelled in known:
            return known[spelled]()
    if name.endswith("::npos"):
        return Number(NPOS)
    if name in ("M_PI", "NAN", "INFINITY"):
        return Number(3.141592653589793) if name == "M_PI" else UNKNOWN
    for scope in machine.names.scopes(frame.scope):
        full = joined(scope, name)
        if full in machine.declarations.constants:
            node, behind = machine.declarations.constants[full]
            first = machine.evaluate(node, Frame(frame.path, scope, None, {})) if node is not None else Number(0)
            return combined(machine, "+", first, Number(behind)) if behind else first
    return UNKNOWN


def _binary(machine: Machine, node: Node, frame: Frame) -> Value:
    # a + b + c + … leans to the left: its left side is gone down in a loop.
    spine: list[Node] = []
    inner: Node | None = node
    while inner is not None and inner.kind == "binary_expression":
        spine.append(inner)
        inner = inner.fields.get("left")
    value = machine.evaluate(inner, frame)
    for each in reversed(spine):
        operator = each.fields.get("operator")
        sign = operator.text if operator else ""
        right = each.fields.get("right")
        if sign in ("&&", "||") and isinstance(value, Number):
            if bool(value.value) is (sign == "||"):
                continue
            value = machine.evaluate(right, frame)
            continue
        if not machine.step():
            return UNKNOWN
        other = machine.evaluate(right, frame)
        own = classes.methods(machine, value, f"operator{sign}")[:1] if isinstance(value, Thing) else ()
        if own and isinstance(value, Thing):
            value = machine.call(own[0], value, [Argument(other)])
        else:
            value = combined(machine, sign, value, other)
    return value


def _assignment(machine: Machine, node: Node, frame: Frame) -> Value:
    left, right, operator = node.fields.get("left"), node.fields.get("right"), node.fields.get("operator")
    value = machine.evaluate(right, frame)
    cell = cell_of(machine, left, frame)
    if cell is None:
        if left is not None and left.kind == "subscript_expression":
            _store(machine, left, value, frame)
        return value
    sign = operator.text if operator else "="
    if sign == "+=":
        texts = isinstance(cell.value, Text) or isinstance(value, Text)
        value = together(cell.value, value) if texts else combined(machine, "+", cell.value, value)
        if isinstance(value, Text) and len(value.template) > LONGEST_TEXT:
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
    cell = cell_of(machine, left.fields.get("argument"), frame)
    if cell is None:
        return
    index = _index(machine, left, frame)
    if isinstance(cell.value, Thing) and cell.value.type.last in _MAPPINGS and isinstance(index, Text) and plain(index):
        machine.write(cell.value.fields.setdefault(index.template, Cell(UNKNOWN)), value)
        return
    known = cell.value.items if isinstance(cell.value, Items) else ()
    at = index.value if isinstance(index, Number) and isinstance(index.value, int) else -1
    if isinstance(cell.value, Items) and 0 <= at < len(known):
        machine.write(cell, Items((*known[:at], value, *known[at + 1 :])))
    elif isinstance(value, Thing) and isinstance(cell.value, (Items, Unknown)) and at in (len(known), -1) and len(known) < MOST_ITEMS:
        machine.write(cell, Items((*known, value)))  # a list of unknown length that is filled one by one
    elif isinstance(cell.value, Items):
        machine.write(cell, UNKNOWN)


def _index(machine: Machine, node: Node, frame: Frame) -> Value:
    indices = node.fields.get("indices") or node.fields.get("index")
    inner = indices.children[0] if indices and indices.kind == "subscript_argument_list" and indices.children else indices
    return machine.evaluate(inner, frame)


def _subscript(machine: Machine, node: Node, frame: Frame) -> Value:
    value = machine.evaluate(node.fields.get("argument"), frame)
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
        if isinstance(index, Unknown) and value.items and all(isinstance(each, (Thing, Handle)) for each in value.items):
            return either([("", each) for each in value.items])
    inner = node.fields.get("indices") or node.fields.get("index")
    counted = inner is not None and any(each.kind == "identifier" for each in (inner, *inner.children))
    return machine.tables.each(value) if counted else UNKNOWN


def _conditional(machine: Machine, node: Node, frame: Frame) -> Value:
    from launchlint.extract.cpp.statements import condition_text, decided, negated

    condition = node.fields.get("condition")
    known = decided(machine, condition, frame)
    if known is not None:
        return machine.evaluate(node.fields.get("consequence" if known else "alternative"), frame)
    text = condition_text(condition)
    found: list[tuple[str, Value]] = []
    for each, name in ((text, "consequence"), (negated(text), "alternative")):
        machine.conditions.append(each)
        try:
            found.append((each, machine.evaluate(node.fields.get(name), frame)))
        finally:
            machine.conditions.pop()
    return either(found)


def _unary(machine: Machine, node: Node, frame: Frame) -> Value:
    value = machine.evaluate(node.fields.get("argument"), frame)
    operator = node.fields.get("operator")
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
    operator, argument = node.fields.get("operator"), node.fields.get("argument")
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
            return machine.unseen.taken(Callable(tuple(functions)), frame)
    return machine.evaluate(argument, frame)


def _cast(machine: Machine, node: Node, frame: Frame) -> Value:
    type_ = node.fields.get("type")
    value = machine.evaluate(node.fields.get("value"), frame)
    return classes.converted(machine, value, parse_type(type_.text), frame) if type_ is not None else value


def _update(machine: Machine, node: Node, frame: Frame) -> Value:
    cell = cell_of(machine, node.fields.get("argument"), frame)
    if cell is None:
        return UNKNOWN
    operator = node.fields.get("operator")
    before = cell.value
    step = 1 if operator and operator.text == "++" else -1
    after: Value = Number(before.value + step) if isinstance(before, Number) and not isinstance(before.value, bool) else UNKNOWN
    machine.write(cell, after)
    return after if node.text.startswith(("++", "--")) else before


BY_KIND: dict[str, Does[[Machine, Node, Frame], Value]] = {
    **dict.fromkeys(("identifier", "qualified_identifier", "type_identifier"), _named),
    "field_expression": of_member,
    "call_expression": calls.call,
    **dict.fromkeys(("string_literal", "raw_string_literal"), lambda machine, node, frame: literal(node)),
    "concatenated_string": _concatenated,
    "number_literal": lambda machine, node, frame: number(node.text),
    "true": lambda machine, node, frame: Number(True),
    "false": lambda machine, node, frame: Number(False),
    **dict.fromkeys(("null", "nullptr"), lambda machine, node, frame: NULL),
    "char_literal": lambda machine, node, frame: Text(braced(unescaped(node.text[1:-1]))),
    **dict.fromkeys(("parenthesized_expression", "condition_clause"), _wrapped),
    "this": lambda machine, node, frame: frame.this or UNKNOWN,
    "binary_expression": _binary,
    "assignment_expression": _assignment,
    "conditional_expression": _conditional,
    "unary_expression": _unary,
    "pointer_expression": _pointer,
    "subscript_expression": _subscript,
    "template_function": _template_function,
    "lambda_expression": _lambda,
    "new_expression": _new,
    "compound_literal_expression": _compound_literal,
    "cast_expression": _cast,
    "initializer_list": lambda machine, node, frame: Items(tuple(machine.evaluate(each, frame) for each in node.children[:200])),
    "comma_expression": _sequence,
    "update_expression": _update,
    **dict.fromkeys(
        ("ERROR", "expression_statement", "co_await_expression", "delete_expression", "user_defined_literal", "throw_statement"), _each
    ),
    **dict.fromkeys(("fold_expression", "parameter_pack_expansion"), _pack),
}
"""What evaluates the expressions that the grammar calls so; others have no value that a name is made of."""

"""Params of nodes: those that are declared, with what the declaration says, and those that are asked for."""

from __future__ import annotations

import re
from collections.abc import Callable as Does
from collections.abc import Sequence

from launchlint.extract.cpp.naming import finished
from launchlint.extract.cpp.rclcpp.qos import as_number
from launchlint.extract.cpp.ros import params
from launchlint.extract.cpp.spelled_type import DOUBLES, INTEGERS, LISTS, TEXTS, UNTYPED, Type, parse_type
from launchlint.extract.cpp.values import UNKNOWN, Cell, Handle, Items, Number, Text, Thing, Value, choices, either, node_of, plain
from launchlint.extract.fact import Descriptor

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.extract.cpp.calls import Call

_TYPE = "rclcpp::ParameterType"
_DESCRIPTOR = "rcl_interfaces::msg::ParameterDescriptor"
_RANGES = ("rcl_interfaces::msg::FloatingPointRange", "rcl_interfaces::msg::IntegerRange")
_KINDS = ("bool", "integer", "double", "string", "byte_array", "bool_array", "integer_array", "double_array", "string_array")
_OF_ITEMS = {"bool": "bool_array", "integer": "integer_array", "double": "double_array", "string": "string_array"}
_BYTES = frozenset(("uint8_t", "std::uint8_t", "char", "std::byte", "byte"))
_SLOT = re.compile(r"\{param:(~[^\s{}|]+)(?:\|[^{}]*)?\}")
_MOST_LISTED = 200


def value_type(asked: Call, type_: Type, value: Value = UNKNOWN) -> str:
    """What ROS 2 calls the type of a param, told by the C++ type, or by a value; empty where it is not known."""
    if type_.name:
        resolved = asked.machine.names.resolve(type_, asked.frame)
        name = resolved.name
        if name in LISTS and resolved.arguments:
            inner = resolved.arguments[0]
            return "byte_array" if inner.name in _BYTES else _OF_ITEMS.get(value_type(asked, inner), "")
        return (
            "string"
            if name in TEXTS
            else "bool"
            if name == "bool"
            else "double"
            if name in DOUBLES
            else "integer"
            if name in INTEGERS
            else ""
        )
    kinds = {_kind(each) for _, each in choices(value)}
    return kinds.pop() if len(kinds) == 1 else ""


def _kind(value: Value) -> str:
    if isinstance(value, Text):
        return "" if value.param else "string"
    if isinstance(value, Number):
        return "bool" if isinstance(value.value, bool) else "integer" if isinstance(value.value, int) else "double"
    if isinstance(value, Items) and value.items:
        kinds = {_kind(each) for each in value.items}
        return _OF_ITEMS.get(kinds.pop(), "") if len(kinds) == 1 else ""
    return ""


def default_of(value: Value, kind: str) -> Any:
    """A default as JSON has it; None where it is not known."""
    if isinstance(value, Items):
        inner = kind.removesuffix("_array")
        items = [default_of(each, inner) for each in value.items]
        return None if None in items or not kind.endswith("_array") else items
    return params.default_of(value, {"integer": "int", "string": "str"}.get(kind, kind)) if not kind.endswith("_array") else None


def named(name: Value) -> Value:
    """Names of params as a library has them: all are a node's own."""
    found: list[tuple[str, Value]] = []
    for condition, each in choices(name):
        text = each.template.lstrip("~/") if isinstance(each, Text) and each.template else "{any}"
        found.append((condition, Text(f"~{text}")))
    return either(found)


# -- declaring ------------------------------------------------------------------------------------------------------------


def declare(handle: Handle, asked: Call) -> Value:
    """``declare_parameter<T>(name, default, descriptor)``, ``declare_parameter(name, type, descriptor)``."""
    default = params.given_default(asked, 1, asked.types[0] if asked.types else UNTYPED)
    return declared(asked, handle, asked.value(0), default, asked.value(2), len(asked.arguments) > 1)


def declared(asked: Call, node: Value, name: Value, default: Value, descriptor: Value, given: bool = True) -> Value:
    """Note a declared param; its value."""
    if isinstance(default, Thing) and default.type.name == _DESCRIPTOR:
        default, descriptor, given = UNKNOWN, default, False
    default = as_number(default)
    explicit = asked.types[0] if asked.types else UNTYPED
    cell = asked.cell(1)
    kind = _type_held(default)
    if kind:
        default = UNKNOWN
    elif explicit.name:
        kind = value_type(asked, explicit) or value_type(asked, UNTYPED, default)
    else:
        kind = value_type(asked, UNTYPED, default)
        if not kind or kind.endswith("_array"):  # 0 may be an item of a list of doubles
            kind = _spelled(asked) or (value_type(asked, cell.type) if given and cell is not None and cell.type.name else "") or kind
    said = _described(descriptor)
    if said is not None and said.dynamic:
        kind = ""
    noted = default_of(default, kind)
    _note(asked, node, name, default=noted, value_type=kind, declared=True, descriptor=said)
    return value_of(name, default)


def _spelled(asked: Call) -> str:
    """The type of a default that is made where it is given: ``std::vector<bool>{}``."""
    node = asked.arguments[1].node if len(asked.arguments) > 1 else None
    if node is not None and node.kind in ("compound_literal_expression", "call_expression"):
        spelled = node.fields.get("type") or node.fields.get("function")
        return value_type(asked, parse_type(spelled.text)) if spelled is not None else ""
    return ""


def _note(asked: Call, node: Value, name: Value, **more: Any) -> None:
    """Note a param of a node; the namespace of a sub-node does not matter to it."""
    for condition, each in choices(node):
        handle = node_of(each) or Handle("", "")
        if condition:
            asked.machine.conditions.append(condition)
        asked.machine.fact("params", named(name), asked.node, asked.frame, node=handle.node or "", **more)
        if condition:
            asked.machine.conditions.pop()


def value_of(name: Value, default: Value) -> Value:
    """What stands for the value of a param."""
    found: list[tuple[str, Value]] = []
    for condition, each in choices(named(name)):
        for inner, value in choices(default):
            found.append((condition or inner, params.slot(each, value)))
    return either(found)


def each_of(value: Value) -> Value:
    """Each value of a param that holds a list: there is one name for each of them."""
    found = _SLOT.fullmatch(value.template) if isinstance(value, Text) and value.param else None
    return UNKNOWN if found is None else Text(f"{{each:{found[1]}}}")


def declare_all(handle: Handle, asked: Call) -> Value:
    """``declare_parameters<T>(namespace, {{name, default}, …})``."""
    space, listed = asked.value(0), asked.value(1)
    if not isinstance(space, Text) or not isinstance(listed, Items):
        asked.machine.doubt("params", "declare_parameters with names that are not known", asked.node, asked.frame)
        return UNKNOWN
    start = f"{space.template}." if space.template else ""
    for each in listed.items[:_MOST_LISTED]:
        name, default = each.items if isinstance(each, Items) and len(each.items) == 2 else (UNKNOWN, UNKNOWN)
        if isinstance(default, Items) and default.items and asked.types:
            default = default.items[0]  # a default with its descriptor
        text = Text(start + name.template) if isinstance(name, Text) else UNKNOWN
        declared(asked, handle, text, default, UNKNOWN)
    return UNKNOWN


def _type_held(value: Value) -> str:
    for _, each in choices(value):
        if isinstance(each, Thing) and each.type.name == _TYPE:
            cell = each.fields.get("<type>")
            return cell.value.template if cell is not None and isinstance(cell.value, Text) else ""
    return ""


def _described(value: Value) -> Descriptor | None:
    """What a descriptor says, as far as it is known."""
    if not isinstance(value, Thing) or value.type.name != _DESCRIPTOR:
        return None
    held = {key: cell.value for key, cell in value.fields.items()}
    limits: list[float | None] = [None, None, None]
    for key in ("floating_point_range", "integer_range"):
        ranges = held.get(key)
        for each in ranges.items if isinstance(ranges, Items) else ():
            if isinstance(each, Thing):
                found = [_number(each, end) for end in ("from_value", "to_value", "step")]
                limits = [new if new is not None else old for new, old in zip(found, limits, strict=True)]
    return Descriptor(
        plain(held.get("description", UNKNOWN)) or "",
        held.get("read_only") == Number(True),
        held.get("dynamic_typing") == Number(True),
        limits[0],
        limits[1],
        limits[2] or None,
    )


def _number(thing: Thing, name: str) -> float | None:
    cell = thing.fields.get(name)
    value = None if cell is None or not isinstance(cell.value, Number) else cell.value.value
    return None if value is None or isinstance(value, bool) or abs(value) > 1e300 else value


def descriptor(asked: Call) -> Value:
    """``ParameterDescriptor()``, or the copy of one."""
    first = asked.value(0)
    if isinstance(first, Thing) and first.type.name == _DESCRIPTOR:
        return first
    asked.machine.serial += 1
    thing = Thing(Type(_DESCRIPTOR), None, asked.machine.serial)
    for key, kind in zip(("floating_point_range", "integer_range"), _RANGES, strict=True):
        # One range is there from the start, for resize(1) and [0]: it says nothing as long as nobody sets it.
        thing.fields[key] = Cell(Items((Thing(Type(kind), None, asked.machine.serial),)))
    return thing


def range_(asked: Call) -> Value:
    """``FloatingPointRange()``."""
    asked.machine.serial += 1
    return Thing(Type(asked.name), None, asked.machine.serial)


# -- asking ---------------------------------------------------------------------------------------------------------------


def get(handle: Handle, asked: Call) -> Value:
    """``get_parameter(name)``, ``get_parameter(name, variable)``."""
    if isinstance(asked.value(0), Items):
        return UNKNOWN
    cell = asked.cell(1) if len(asked.arguments) > 1 else None
    kind = value_type(asked, asked.types[0]) if asked.types else value_type(asked, cell.type) if cell is not None else ""
    _note(asked, handle, asked.value(0), value_type=kind, declared=False)
    value = value_of(asked.value(0), _one_of(_declared_before(asked, handle, asked.value(0))))
    if cell is None:
        return value
    asked.machine.write(cell, value)
    return UNKNOWN


def _declared_before(asked: Call, handle: Handle, name: Value) -> list[Any]:
    """The defaults of the declarations of a param before; empty where there is none."""
    if not isinstance(name, Text):
        return []
    text = finished(f"~{name.template}")
    return [
        each.default
        for each in asked.machine.facts.values()
        if each.category == "params" and each.declared and each.name == text and each.node == (handle.node or "")
    ]


def _one_of(found: Sequence[Any]) -> Value:
    """The one default that a param was declared with, where that is a plain value."""
    if not found or found[0] is None or any(each != found[0] for each in found) or isinstance(found[0], list):
        return UNKNOWN
    return (
        Text(found[0])
        if isinstance(found[0], str) and "{" not in found[0]
        else Number(found[0])
        if not isinstance(found[0], str)
        else UNKNOWN
    )


def get_or(handle: Handle, asked: Call) -> Value:
    """``get_parameter_or(name, variable, default)``, ``get_parameter_or(name, default)``."""
    value = asked.value(2) if len(asked.arguments) > 2 else asked.value(1)
    cell = asked.cell(1) if len(asked.arguments) > 2 else None
    kind = value_type(asked, cell.type) if cell is not None and cell.type.name else value_type(asked, UNTYPED, value)
    before = _declared_before(asked, handle, asked.value(0))
    if before:  # it has a value: the one that is given here is for a param that is not there
        value = _one_of(before)
        _note(asked, handle, asked.value(0), value_type=kind, declared=False)
    else:
        _note(asked, handle, asked.value(0), value_type=kind, declared=False, default=default_of(value, kind))
    read = value_of(asked.value(0), value)
    if cell is None:
        return read
    asked.machine.write(cell, read)
    return UNKNOWN


def get_all(handle: Handle, asked: Call) -> Value:
    """``get_parameters({name, …})``; ``get_parameters(prefix, map)`` reads whatever there is below the prefix."""
    first = asked.value(0)
    if len(asked.arguments) > 1 or not isinstance(first, Items):
        start = f"{first.template}." if isinstance(first, Text) and first.template else ""
        if isinstance(first, Text):
            _note(asked, handle, Text(f"{start}{{any}}"), declared=False)
        else:
            asked.machine.doubt("params", "get_parameters with names that are not known", asked.node, asked.frame)
        return UNKNOWN
    for each in first.items[:_MOST_LISTED]:
        _note(asked, handle, each, declared=False)
    return Items(tuple(value_of(each, UNKNOWN) for each in first.items))


def has(handle: Handle, asked: Call) -> Value:
    """``has_parameter(name)``: asks for one that is declared elsewhere, if at all."""
    return UNKNOWN


def on_set(handle: Handle, asked: Call) -> Value:
    """``add_on_set_parameters_callback(callback)``."""
    for each in asked.arguments:
        asked.machine.later(each.value, "message")
    return UNKNOWN


def nothing(handle: Handle, asked: Call) -> Value:
    """A member that makes no name."""
    return UNKNOWN


def _first(asked: Call) -> Value:
    """``ParameterValue(x)``: what it holds."""
    return asked.value(0)


def _parameter(asked: Call) -> Value:
    """``Parameter(name, value)``."""
    return asked.value(1) if len(asked.arguments) > 1 else UNKNOWN


def _constants() -> dict[str, Does[[], Value]]:
    def of(kind: str) -> Does[[], Value]:
        def make() -> Value:
            thing = Thing(Type(_TYPE), None, 0)
            thing.fields["<type>"] = Cell(Text(kind))
            return thing

        return make

    names = {kind: f"PARAMETER_{kind.upper()}" for kind in _KINDS}
    found = {f"rclcpp::{name}": of(kind) for kind, name in names.items()}
    found.update({f"rclcpp::ParameterType::{name}": of(kind) for kind, name in names.items()})
    found.update({f"rcl_interfaces::msg::ParameterType::{name}": of(kind) for kind, name in names.items()})
    return found


OF_HANDLE: dict[str, Does[[Handle, Call], Value]] = {
    "declare_parameter": declare,
    "declare_parameters": declare_all,
    "get_parameter": get,
    "get_parameter_or": get_or,
    "get_parameters": get_all,
    "has_parameter": has,
    **dict.fromkeys(("add_on_set_parameters_callback", "add_post_set_parameters_callback", "add_pre_set_parameters_callback"), on_set),
    **dict.fromkeys(
        (
            "set_parameter", "set_parameters", "set_parameters_atomically", "undeclare_parameter", "describe_parameter",
            "describe_parameters", "get_parameter_types", "list_parameters", "remove_on_set_parameters_callback",
            "set_on_parameters_set_callback", "get_parameter_overrides",
        ),
        nothing,
    ),
}  # fmt: skip
MAKERS: dict[str, Does[[Call], Value]] = {
    _DESCRIPTOR: descriptor,
    **dict.fromkeys(_RANGES, range_),
    "rclcpp::ParameterValue": _first,
    "rclcpp::Parameter": _parameter,
}
VALUES: dict[str, Does[[], Value]] = {
    **_constants(),
    "bond::msg::Constants::DISABLE_HEARTBEAT_TIMEOUT_PARAM": lambda: Text("bond_disable_heartbeat_timeout"),
}

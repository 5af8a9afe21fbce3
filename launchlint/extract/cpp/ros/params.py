"""Params that are read: their names, types and defaults, and the values that stand for them."""

from __future__ import annotations

import re

from launchlint.extract.cpp.naming import ANY, finished, in_namespace
from launchlint.extract.cpp.spelled_type import ANYTHING, DOUBLES, INTEGERS, LISTS, MAPPINGS, TEXTS, UNTYPED, Type
from launchlint.extract.cpp.values import UNKNOWN, Cell, Handle, Items, Null, Number, Text, Unknown, Value, both, choices, either, plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.extract.cpp.calls import Call

_DEEPEST_TEMPLATE = 6
_SLOT = re.compile(r"\{param:([^|{}]+)(\|[^{}]*)?\}")


def named(handle: Handle, name: Value) -> Value:
    """A name in the namespace of a node handle. One that a param gives may be absolute; then the namespace does not matter."""
    found: list[tuple[str, Value]] = []
    for condition, each in choices(name):
        # Nothing can be called by an empty name: it is given elsewhere.
        text = each.template if isinstance(each, Text) and each.template else ANY
        below = in_namespace(handle.namespace, text)
        slot = _SLOT.match(text)
        if slot is not None and below == text and handle.namespace == "~":  # absolute by default: another value need not be
            found.append((condition, Text(f"~{text}")))
            continue
        if slot is None or below == text:
            found.append((condition, Text(below)))
            continue
        found.append((condition if slot[2] not in (None, "|") else both(condition, f"{slot[1]} is a relative name"), Text(below)))
        found.append((both(condition, f"{slot[1]} is an absolute name"), Text(f"{{param:{slot[1]}}}{text[slot.end() :]}")))
    return either(found)


def value_type(asked: Call, type_: Type, value: Value = UNKNOWN) -> str:
    """What the library format calls a type; told by a value where there is no type."""
    if type_.name:
        name = asked.machine.names.resolve(type_, asked.frame).name
        if name in TEXTS:
            return "str"
        if name == "bool":
            return "bool"
        if name in DOUBLES:
            return "double"
        if name in INTEGERS:
            return "int"
        if name in LISTS:
            return "list"
        if name in MAPPINGS:
            return "dict"
        return "*" if name in ANYTHING else ""
    for _, each in choices(value):
        if isinstance(each, Text):
            return "str" if not each.param else ""
        if isinstance(each, Number):
            return "bool" if isinstance(each.value, bool) else "int" if isinstance(each.value, int) else "double"
        if isinstance(each, Items):
            return "list"
    return ""


def default_of(value: Value, kind: str) -> Any:
    """A default as JSON has it; None where it is not known."""
    if isinstance(value, Text):
        constant = plain(value)
        return constant if kind in ("str", "") and constant is not None and constant.isprintable() else None
    if isinstance(value, Number):
        if kind == "double":
            return float(value.value)
        if kind == "int":
            return int(value.value) if abs(value.value) < 1e18 else None
        if kind == "bool":
            return bool(value.value)
        return value.value if kind == "" else None
    if isinstance(value, Items) and value.items:
        items = [default_of(each, "") for each in value.items]
        return None if None in items else items
    return None


def given_default(asked: Call, position: int, type_: Type) -> Value:
    """The default that stands at a position; any text for a constant of elsewhere, as ``mav_msgs::default_topics::ODOMETRY`` is.

    Where it is not known and none at all, a name made of the param would not be there as long as the param is not set.
    """
    value = asked.value(position)
    node = asked.arguments[position].node if position < len(asked.arguments) else None
    if not isinstance(value, Unknown) or node is None or node.kind != "qualified_identifier":
        return value
    return Text(ANY) if value_type(asked, type_) == "str" else value


def read(asked: Call, name: Value, default: Value, type_: Type, keep: bool = False) -> Value:
    """Note that a param is read, and give the value that stands for it.

    Args:
        asked: the call.
        name: the param's name.
        default: what is taken where the param is not set; UNKNOWN where that is not known or there is none.
        type_: of the variable that takes it.
        keep: ``default`` is what the variable holds already: no default of the param.
    """
    kind = value_type(asked, type_, default if not keep else UNKNOWN)
    noted = None if keep or isinstance(default, (Unknown, Null)) else default_of(default, kind)
    asked.machine.fact("params", name, asked.node, asked.frame, default=noted, value_type=kind)
    found: list[tuple[str, Value]] = []
    for condition, each in choices(name):
        for inner, value in choices(default):
            found.append((condition or inner, slot(each, value)))
    return either(found)


def slot(name: Value, default: Value) -> Value:
    """The value of a param: a template, with its default where that is known."""
    text = finished(name.template) if isinstance(name, Text) else ANY
    if any(char in text for char in "{}|"):
        return UNKNOWN
    if isinstance(default, Text):
        if default.template.count("{") > _DEEPEST_TEMPLATE or "|" in default.template.replace("|", "", default.template.count("{")):
            return Text(f"{{param:{text}}}", True)
        return Text(f"{{param:{text}|{default.template}}}", True)
    constant = plain(default)
    return Text(f"{{param:{text}}}" if constant is None else f"{{param:{text}|{constant}}}", True)


def into(asked: Call, name: Value, cell: Cell | None, default: Value, keep: bool, type_: Type = UNTYPED) -> Value:
    """Read a param into a variable."""
    type_ = cell.type if cell is not None and cell.type.name else type_
    if keep and cell is not None:
        default = cell.value
    value = read(asked, name, default, type_, keep)
    if cell is not None:
        asked.machine.write(cell, value)
    return UNKNOWN

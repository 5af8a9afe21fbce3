"""Params of nodes: declared, asked for, and the objects that stand for them.

Source: rclpy.node, rclpy.parameter. A param that is declared with a value has the type of that value for good, unless its descriptor says
``dynamic_typing``; one that is declared by its name alone may have any.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.extract.fact import Descriptor
from launchlint.extract.python.arguments import Call, plain
from launchlint.extract.python.ros2.names import NodeParam, interface_type, spelled
from launchlint.extract.python.ros2.nodes import Node
from launchlint.python.text import ANY, distribute, joined
from launchlint.python.values import (
    MISSING,
    UNKNOWN,
    Choice,
    External,
    Handle,
    Map,
    Seq,
    Text,
    Value,
    alternatives,
    choice,
)

_TYPE = "rclpy.parameter.Parameter.Type."
_TYPES = ("bool", "integer", "double", "string", "byte_array", "bool_array", "integer_array", "double_array", "string_array")
_OF_PYTHON: dict[type, str] = {bool: "bool", int: "integer", float: "double", str: "string", bytes: "byte"}
_RANGES = ("floating_point_range", "integer_range")


def parameter(made: Call) -> Value:
    """``rclpy.parameter.Parameter(name, type_, value)``."""
    return _object(made.get(0, "name", UNKNOWN), made.get(2, "value", None))


def message(made: Call) -> Value:
    """A message of which it matters what it says: its fields are given by name."""
    fields: dict[object, Value] = {("attribute", name): value for name, value in made.keywords.items()}
    return Handle("message", {"type": interface_type(External(made.name)), **fields})


def declare(key: str, node: Node | None, made: Call) -> Value:
    """``node.declare_parameter(name, value, descriptor)``."""
    return _declare(key, node, made, made.get(0, "name"), made.get(1, "value", None), made.get(2, "descriptor", None))


def declare_all(key: str, node: Node | None, made: Call) -> Value:
    """``node.declare_parameters(namespace, [(name, value, descriptor), …])``."""
    namespace = made.get(0, "namespace", UNKNOWN)
    listed = made.get(1, "parameters", UNKNOWN)
    if not isinstance(listed, Seq) or not listed.complete:
        made.doubt("it declares params that are not all known", ("params",))
    found: list[Value] = []
    for each in listed.items if isinstance(listed, Seq) else ():
        for condition, one in alternatives(each):
            mark = len(made.run.conditions)
            made.run.conditions += [condition] if condition else []
            found.append(_listed(key, node, made, namespace, one))
            del made.run.conditions[mark:]
    return Seq(found, isinstance(listed, Seq) and listed.complete)


def _listed(key: str, node: Node | None, made: Call, namespace: Value, one: Value) -> Value:
    if not isinstance(one, Seq) or not one.items:
        made.doubt("it declares params that are not all known", ("params",))
        return UNKNOWN
    name, *rest = one.items
    if namespace not in ("", None):
        name = joined([namespace, ".", name])
    return _declare(key, node, made, name, rest[0] if rest else None, rest[1] if len(rest) > 1 else None)


def _declare(key: str, node: Node | None, made: Call, name: Value, value: Value, descriptor: Value) -> Value:
    said = _descriptor(descriptor)
    if value is None and descriptor in (None, MISSING):
        said = (said or Descriptor())._replace(dynamic=True)
    default = MISSING if is_type(value) else value
    if isinstance(value, Choice):
        default = choice([(condition, each) for condition, each in value.alternatives if not is_type(each)])
    known = plain(default) if default is not MISSING else None
    made.fact(
        "params",
        name,
        default=None if known is MISSING else known,
        value_type="" if said is not None and said.dynamic else value_type(value),
        declared=True,
        descriptor=None if said == Descriptor() else said,
        node=key,
    )
    for _, each in alternatives(name) if node is not None else ():
        if node is not None and isinstance(each, str):
            node.declared.setdefault(each, default)
    return _object(name, _value(name, default))


def get(key: str, node: Node | None, made: Call) -> Value:
    """``node.get_parameter(name)``."""
    return _got(key, node, made, made.get(0, "name", UNKNOWN), MISSING)


def get_or(key: str, node: Node | None, made: Call) -> Value:
    """``node.get_parameter_or(name, alternative_value)``."""
    otherwise = made.get(1, "alternative_value", None)
    default = otherwise.state.get("value", MISSING) if isinstance(otherwise, Handle) else MISSING if otherwise is None else UNKNOWN
    return _got(key, node, made, made.get(0, "name", UNKNOWN), default)


def get_all(key: str, node: Node | None, made: Call) -> Value:
    """``node.get_parameters([name, …])``."""
    names = made.get(0, "names", UNKNOWN)
    if not isinstance(names, Seq):
        return UNKNOWN
    return Seq([_got(key, node, made, each, MISSING) for each in names.items], names.complete)


def by_prefix(key: str, node: Node | None, made: Call) -> Value:
    """``node.get_parameters_by_prefix(prefix)``."""
    prefix = made.get(0, "prefix", UNKNOWN)
    made.fact("params", UNKNOWN if prefix == "" else joined([prefix, ".", UNKNOWN]), declared=False, node=key)
    return Map({}, False)


def _got(key: str, node: Node | None, made: Call, name: Value, default: Value) -> Value:
    declared = {} if node is None else node.declared
    takes_any = node is None or node.made.undeclared
    asked = [each for _, each in alternatives(name) if not (isinstance(each, str) and each in declared)]
    for each in asked:
        # A name that nobody knows is one of those that are declared, or rclpy raises.
        if takes_any or spelled(each, "params") != ANY:
            made.fact("params", each, declared=False, node=key)
    return _object(name, distribute(lambda each: _value(each, declared.get(each, default) if isinstance(each, str) else default), name))


def _value(name: Value, default: Value) -> Value:
    def of(each: Value) -> Value:
        text = spelled(each, "params")
        return UNKNOWN if text == ANY else NodeParam(text, default)

    return distribute(of, UNKNOWN if name is MISSING else name)


def _object(name: Value, value: Value) -> Handle:
    return Handle("parameter", {"name": name, "value": value})


def member(receiver: Handle, name: str) -> Value:
    """An attribute of a param, or of the message that has its value; MISSING where it is a method."""
    if receiver.kind == "parameter":
        return {"value": receiver.state["value"], "name": receiver.state["name"]}.get(name, MISSING)
    return receiver.state["value"] if name.endswith("_value") else MISSING


def as_message(receiver: Handle, made: Call) -> Value:
    """``parameter.get_parameter_value()``."""
    return Handle("parameter value", {"value": receiver.state["value"]})


def is_type(value: Value) -> bool:
    """Whether a value is one of ``Parameter.Type``."""
    return isinstance(value, External) and value.name.startswith(_TYPE)


def value_type(value: Value) -> str:
    """The type that a param has by what it is declared with; empty where that is not known."""
    found = {_type_of(each) for _, each in alternatives(value)}
    return found.pop() if len(found) == 1 else ""


def _type_of(value: Value) -> str:
    if is_type(value):
        word = value.name[len(_TYPE) :].lower()
        return word if word in _TYPES else ""
    if isinstance(value, Text):
        return "string"
    if isinstance(value, Seq):
        if not value.complete:
            return ""
        if not value.items:
            return "byte_array"  # as Parameter.Type.from_parameter_value takes an empty list
        items = {_OF_PYTHON.get(type(each), "string" if isinstance(each, Text) else "") for each in value.items}
        return f"{items.pop()}_array" if len(items) == 1 and "" not in items else ""
    found = _OF_PYTHON.get(type(value), "")
    return "" if found == "byte" else found


def _descriptor(value: Value) -> Descriptor | None:
    if not isinstance(value, Handle) or value.kind != "message":
        return None
    said = {name: value.state.get(("attribute", name), MISSING) for name in ("description", "read_only", "dynamic_typing", *_RANGES)}
    text = said["description"]
    found = Descriptor(text if isinstance(text, str) else "", said["read_only"] is True, said["dynamic_typing"] is True)
    for name in _RANGES:
        for lowest, highest, step in _ranges(said[name]):
            found = found._replace(minimum=lowest, maximum=highest, step=step)
    return found


def _ranges(value: Value) -> Iterator[tuple[float | None, float | None, float | None]]:
    for each in value.items[:1] if isinstance(value, Seq) else ():
        if isinstance(each, Handle) and each.kind == "message":
            lowest, highest, step = (_number(each.state.get(("attribute", name), 0)) for name in ("from_value", "to_value", "step"))
            if lowest is not None and highest is not None:
                yield lowest, highest, step or None


def _number(value: Value) -> float | None:
    return value if isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1 << 63 else None

"""Classes that generate_parameter_library makes of a YAML file: each param is declared, and read through the members of a struct."""

from __future__ import annotations

import os
from collections.abc import Callable as Does
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from launchlint.errors import ConfigurationError
from launchlint.extract.cpp.rclcpp import params
from launchlint.extract.cpp.rclcpp.interface import node_at
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.tables import Tables
from launchlint.extract.cpp.values import UNKNOWN, Cell, Number, Text, Thing, Value, choices, node_of
from launchlint.extract.fact import Descriptor, Fact
from launchlint.workspace import looking
from launchlint.workspace.yaml_nodes import MAPPING, SCALAR, SEQUENCE, Node, parse_document

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call

_MOST_PARAMS = 2_000
_DEEPEST = 20
_LARGEST = 1 << 20
_MAP = "__map_"
_TYPES = {
    "bool": "bool", "int": "integer", "double": "double", "string": "string", "bool_array": "bool_array", "int_array": "integer_array",
    "double_array": "double_array", "string_array": "string_array",
}  # fmt: skip
_LEAST = ("bounds<>", "lower_bounds<>", "gt_eq<>")
_GREATEST = ("bounds<>", "upper_bounds<>", "lt_eq<>")


class Described(NamedTuple):
    """One param of a YAML file: its name with dots, ``{any}`` for the parts that another param gives."""

    name: str
    type: str
    default: bool | int | float | str | list[bool | int | float | str] | None
    descriptor: Descriptor
    line: int


class Description(NamedTuple):
    """A YAML file: the namespace of the classes that are made of it, and the params; ``whole`` says that all of them are understood."""

    space: str
    params: tuple[Described, ...]
    whole: bool


def read(path: str) -> Description | None:
    """What a YAML file describes; None where it cannot be read."""
    try:
        root = parse_document(looking.read_bytes(path, _LARGEST), path).root
    except (OSError, ConfigurationError):
        return None
    if root is None or root.kind != MAPPING or len(root.pairs) != 1:
        return None
    key, value = root.pairs[0]
    found = list(_params(value, "", 0))
    return Description(key.text, tuple(found[:_MOST_PARAMS]), len(found) <= _MOST_PARAMS)


def _params(node: Node, start: str, depth: int) -> Iterator[Described]:
    if node.kind != MAPPING or depth > _DEEPEST:
        return
    said = {key.text: value for key, value in node.pairs if key.kind == SCALAR}
    if start and "type" in said and said["type"].kind == SCALAR:
        yield _described(start, said, node.line)
        return
    for key, value in node.pairs:
        part = "{any}" if key.text.startswith(_MAP) else key.text
        if key.kind == SCALAR and part and (part == "{any}" or not set(part) & set("{}~/ ")):
            yield from _params(value, f"{start}.{part}" if start else part, depth + 1)


def _described(name: str, said: dict[str, Node], line: int) -> Described:
    kind = said["type"].text
    base, _, size = kind.rpartition("_fixed_")
    type_ = _TYPES.get(base if size.isdigit() else kind, "")
    checks = said.get("validation")
    given = {key.text: value for key, value in checks.pairs} if checks is not None and checks.kind == MAPPING else {}
    one_of = _first(given.get("one_of<>"))
    described = Descriptor(
        said["description"].text if "description" in said and said["description"].kind == SCALAR else "",
        "read_only" in said and said["read_only"].text == "true",
        False,
        _limit(given, _LEAST, 0),
        _limit(given, _GREATEST, -1),
        None,
        tuple(each for each in (_value(item) for item in one_of.items) if each is not None) if one_of is not None else (),
    )
    default = said.get("default_value")
    return Described(name, type_, _default(default, type_), described, line)


def _first(node: Node | None) -> Node | None:
    """The list that a check is given as its first argument."""
    found = node.items[0] if node is not None and node.kind == SEQUENCE and node.items else None
    return found if found is not None and found.kind == SEQUENCE else None


def _limit(given: dict[str, Node], names: Sequence[str], position: int) -> float | None:
    for name in names:
        node = given.get(name)
        value = _value(node.items[position]) if node is not None and node.kind == SEQUENCE and node.items else None
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            return value
    return None


def _default(node: Node | None, kind: str) -> bool | int | float | str | list[bool | int | float | str] | None:
    if node is None:
        return None
    if node.kind == SEQUENCE:
        items = [_value(each, kind.removesuffix("_array")) for each in node.items]
        known = [each for each in items if each is not None]
        return known if len(known) == len(items) else None
    return _value(node, kind)


def _value(node: Node, kind: str = "") -> bool | int | float | str | None:
    if node.kind != SCALAR:
        return None
    try:
        if kind == "string":
            return node.text
        if node.type == "bool":
            return node.text.lower() in ("true", "yes", "on")
        if node.type == "int":
            number = int(node.text.replace("_", ""), 0)
            return (float(number) if kind == "double" else number) if abs(number) < 10**18 else None
        if node.type == "float":
            return float(node.text) if abs(float(node.text)) < 1e300 else None
    except (ValueError, OverflowError):
        return None
    return node.text if node.type == "str" else None


def with_classes(tables: Tables, paths: Sequence[str], root: str) -> Tables:
    """The tables with the classes that are made of YAML files."""
    makers = dict(tables.makers)
    methods = dict(tables.methods)
    for path in paths:
        description = read(path)
        if description is not None:
            listener, struct = f"{description.space}::ParamListener", f"{description.space}::Params"
            makers[listener] = _listener(description, os.path.relpath(path, root).replace(os.sep, "/"))
            makers[struct] = _struct_of(description)
            for name in ("get_params", "get_stack_params", "try_get_params"):
                methods[listener, name] = _held_params
            for name in ("is_old", "update", "refresh_dynamic_parameters", "setUserCallback", "declare_params"):
                methods[listener, name] = _nothing
    return tables._replace(makers=makers, methods=methods)


def _listener(description: Description, path: str) -> Does[[Call], Value]:
    """``ParamListener(node, prefix)``: the params are declared."""

    def make(asked: Call) -> Value:
        machine = asked.machine
        prefix = next((each.value for each in asked.arguments if isinstance(each.value, Text)), Text(""))
        start = prefix.template
        start = f"{start.rstrip('.')}." if start else ""
        conditions = " and ".join(dict.fromkeys(machine.conditions))
        for _, one in choices(node_at(asked, 0)):
            node = node_of(one)
            for each in description.params:
                machine.note(
                    Fact(
                        "params",
                        f"~{start}{each.name}",
                        path,
                        each.line,
                        default=each.default,
                        value_type=each.type,
                        condition=conditions,
                        when=machine.when,
                        node="" if node is None else node.node or "",
                        exists=machine.exists,
                        declared=True,
                        descriptor=each.descriptor,
                    )
                )
        if not description.whole:
            machine.doubt("params", f"only {_MOST_PARAMS} params of {path} are listed", asked.node, asked.frame)
        machine.serial += 1
        thing = Thing(Type(asked.name), None, machine.serial)
        thing.fields["<params>"] = machine.cell(_struct(description, start))
        return thing

    return make


def _struct_of(description: Description) -> Does[[Call], Value]:
    def make(asked: Call) -> Value:
        first = asked.value(0)
        return first if isinstance(first, Thing) and first.type.name == asked.name else _struct(description, "")

    return make


def _struct(description: Description, start: str) -> Thing:
    """An object whose members are the values of the params."""
    top = Thing(Type(f"{description.space}::Params"), None, 0)
    for each in description.params:
        *spaces, last = each.name.split(".")
        thing = top
        for part in spaces:
            cell = thing.fields.setdefault(part, Cell(Thing(Type(""), None, 0)))
            if isinstance(cell.value, Thing):
                thing = cell.value
        default: Value = UNKNOWN
        if isinstance(each.default, str):
            default = Text(each.default) if not set("{}") & set(each.default) else UNKNOWN
        elif isinstance(each.default, (bool, int, float)):
            default = Number(each.default)
        thing.fields[last] = Cell(params.value_of(Text(f"{start}{each.name}"), default))
    return top


def _held_params(this: Thing, asked: Call) -> Value:
    cell = this.fields.get("<params>")
    return UNKNOWN if cell is None else cell.value


def _nothing(this: Thing, asked: Call) -> Value:
    return UNKNOWN

"""Classes that generate_parameter_library makes of a YAML file: each param is declared, and read through the members of a struct."""

from __future__ import annotations

import os
from collections.abc import Callable as Does
from collections.abc import Sequence

from launchlint.extract.cpp.rclcpp import params
from launchlint.extract.cpp.rclcpp.interface import node_at
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.tables import Tables
from launchlint.extract.cpp.values import UNKNOWN, Cell, Number, Text, Thing, Value, choices, node_of
from launchlint.extract.described_params import MOST_PARAMS, Description, read
from launchlint.extract.fact import Fact

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call


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
            machine.doubt("params", f"only {MOST_PARAMS} params of {path} are listed", asked.node, asked.frame)
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

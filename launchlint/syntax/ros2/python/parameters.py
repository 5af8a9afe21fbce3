"""What stands in ``parameters=[…]``: files and dicts (launch_ros.utilities.normalize_parameters)."""

from __future__ import annotations

from typing import Any

from launchlint.python.values import External, Handle, Map, Seq, Value
from launchlint.source import Place
from launchlint.syntax.ros2.description import Parameter, ParameterFile, Parameters, ParameterSource, Text, TypedValue
from launchlint.syntax.ros2.python.texts import NotUnderstood, is_substitution, pairs, text

_TYPES = {"builtins.str": "str", "builtins.bool": "bool", "builtins.int": "int", "builtins.float": "float"}
_SCALARS = (bool, int, float, str)


def number(value: Value, place: Place) -> Value:
    """A value that, if it is a number, is one that rcl can hold. Raises NotUnderstood."""
    if isinstance(value, (int, float)) and not abs(value) < 1 << 63:
        raise NotUnderstood("a number that is too large", place)
    return value


def parameters(value: Value, place: Place) -> tuple[ParameterSource, ...]:
    """The sources of a node's params, in order. Raises NotUnderstood."""
    if value is None:
        return ()
    if not isinstance(value, Seq) or not value.complete:
        raise NotUnderstood("parameters that are no list, or not known", place)
    return tuple(_source(each, place) for each in value.items)


def _source(value: Value, place: Place) -> ParameterSource:
    if isinstance(value, Map):
        return Parameters(_entries(value, place), place)
    if isinstance(value, Handle) and value.kind == "ParameterFile":
        given, place = value.state, value.state["place"]
        allowed = given.get("allow_substs", False)
        return ParameterFile(text(given["param_file"], place), allowed if isinstance(allowed, bool) else text(allowed, place), place)
    return ParameterFile(text(value, place), False, place)


def extra_arguments(value: Value, place: Place) -> tuple[Parameter, ...]:
    """What a component is loaded with. Raises NotUnderstood."""
    if value is None:
        return ()
    if not isinstance(value, Seq) or not value.complete or not all(isinstance(each, Map) for each in value.items):
        raise NotUnderstood("extra_arguments that are no list of dicts, or not known", place)
    found: list[Parameter] = []
    for each in value.items:
        for name, content in pairs(each, place):
            found.append(Parameter(text(name, place), set_value(content, place), (), place))
    return tuple(found)


def _entries(value: Map, place: Place) -> tuple[Parameter, ...]:
    found: list[Parameter] = []
    for name, content in pairs(value, place):
        if isinstance(content, Map):
            found.append(Parameter(text(name, place), None, _entries(content, place), place))
        else:
            found.append(Parameter(text(name, place), typed(content, place), (), place))
    return tuple(found)


def typed(value: Value, place: Place) -> TypedValue:
    """One value of a param. Raises NotUnderstood."""
    if isinstance(value, Handle) and value.kind == "ParameterValue":
        return _described(value)
    if isinstance(value, _SCALARS):
        return TypedValue(Text((str(number(value, place)),), place), None, value)
    if is_substitution(value):
        return TypedValue(text(value, place))
    if isinstance(value, Seq) and value.complete:
        return _list(value.items, place)
    if isinstance(value, (Seq, Map, Handle)) or value is None:
        raise NotUnderstood("a value of a param that is not known", place)
    return TypedValue(text(value, place), "str")


def _list(items: list[Value], place: Place) -> TypedValue:
    if not items:
        raise NotUnderstood("a list without items as a param", place)
    kinds = {type(number(each, place)) for each in items}
    if kinds <= {int, float}:
        plain: Any = tuple(items) if kinds == {int} else tuple(float(each) for each in items)
        return TypedValue(tuple(Text((str(each),), place) for each in items), None, plain)
    if kinds in ({bool}, {str}):
        return TypedValue(tuple(Text((str(each),), place) for each in items), None, tuple(items))
    if any(is_substitution(each) for each in items) and all(is_substitution(each) or isinstance(each, str) for each in items):
        return TypedValue(text(Seq(items), place))  # one text, in pieces
    if all(isinstance(each, Seq) for each in items):
        return TypedValue(tuple(text(each, place) for each in items))
    raise NotUnderstood("a list of several kinds of values as a param", place)


def _described(value: Handle) -> TypedValue:
    """``ParameterValue(…, value_type=…)``."""
    given, place = value.state, value.state["place"]
    type_, content = given.get("value_type"), given["value"]
    if type_ is None:
        return typed(content, place)
    name = _TYPES.get(type_.name) if isinstance(type_, External) else None
    if name is None or not (isinstance(content, str) or is_substitution(content) or isinstance(content, Seq)):
        raise NotUnderstood("a value of a type that is not known", place)
    return TypedValue(text(content, place), name)


def set_value(value: Value, place: Place) -> TypedValue:
    """The value of SetParameter, and of an extra argument: one text, which is read as YAML. Raises NotUnderstood."""
    if isinstance(value, bool):
        return TypedValue(Text(("true" if value else "false",), place))
    if isinstance(value, (int, float)):
        return TypedValue(Text((repr(number(value, place)),), place))
    if isinstance(value, str):
        return TypedValue(Text((_quoted(value),), place))
    if is_substitution(value):
        return TypedValue(text(value, place))
    if isinstance(value, Seq) and value.complete and value.items and len({type(each) for each in value.items}) == 1:
        first = value.items[0]
        if isinstance(first, (bool, int, float)):
            return TypedValue(Text((f"[{', '.join(str(number(each, place)).lower() for each in value.items)}]",), place))
        if isinstance(first, str):
            return TypedValue(Text((f"[{', '.join(map(_quoted, value.items))}]",), place))
    raise NotUnderstood("a value that is not known", place)


def _quoted(value: str) -> str:
    if not value.isprintable():
        raise NotUnderstood("a text of several lines")
    return "'" + value.replace("'", "''") + "'"

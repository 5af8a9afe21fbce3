"""What stands in ``parameters=[…]``: files and dicts (launch_ros.utilities.normalize_parameters)."""

from __future__ import annotations

from typing import Any

from launchlint.python.values import Choice, External, Handle, Map, Seq, Unknown, Value
from launchlint.source import Place
from launchlint.syntax.ros2.description import Parameter, ParameterFile, Parameters, ParameterSource, Text, TypedValue, unknown
from launchlint.syntax.ros2.python.texts import Texts, is_own_substitution, is_substitution, pairs, why

_TYPES = {"builtins.str": "str", "builtins.bool": "bool", "builtins.int": "int", "builtins.float": "float"}
_SCALARS = (bool, int, float, str)
_LARGEST = 1 << 63


def parameters(value: Value, place: Place, texts: Texts) -> tuple[ParameterSource, ...]:
    """The sources of a node's params, in order; a file that is not known stands for those that are not."""
    if value is None:
        return ()
    if not isinstance(value, Seq):
        return (_missing(why(value, "parameters that are no list"), place),)
    more = () if value.complete else (_missing("not all parameters are known", place),)
    return (*(source for each in value.items for source in _source(each, place, texts)), *more)


def _missing(reason: str, place: Place) -> ParameterFile:
    return ParameterFile(unknown(reason, place), False, place)


def _source(value: Value, place: Place, texts: Texts) -> tuple[ParameterSource, ...]:
    if isinstance(value, Map):
        entries = _entries(value, place, texts)
        if not value.complete:
            entries = (*entries, _more(place))
        return (Parameters(entries, place),)
    if isinstance(value, Handle) and value.kind == "ParameterFile":
        given, place = value.state, value.state["place"]
        allowed = given.get("allow_substs", False)
        return (
            ParameterFile(
                texts.text(given["param_file"], place), allowed if isinstance(allowed, bool) else texts.text(allowed, place), place
            ),
        )
    if isinstance(value, (Unknown, Choice)):
        return (_missing(why(value, ""), place),)
    return (ParameterFile(texts.text(value, place), False, place),)


def extra_arguments(value: Value, place: Place, texts: Texts) -> tuple[Parameter, ...]:
    """What a component is loaded with."""
    found: list[Parameter] = []
    for each in value.items if isinstance(value, Seq) else []:
        for name, content in pairs(each)[0]:
            found.append(Parameter(texts.text(name, place), set_value(content, place, texts), (), place))
    return tuple(found)


def _more(place: Place) -> Parameter:
    """Stands for the entries of a dict that are not known."""
    return Parameter(unknown("not all entries of the dict are known", place), TypedValue(unknown("", place)), (), place)


def _entries(value: Map, place: Place, texts: Texts) -> tuple[Parameter, ...]:
    found: list[Parameter] = []
    for name, content in value.entries.items():
        if isinstance(content, Map):
            inner = _entries(content, place, texts)
            if not content.complete:
                inner = (*inner, _more(place))
            found.append(Parameter(texts.text(name, place), None, inner, place))
        elif isinstance(content, (Unknown, Choice)):  # it may be a dict, too
            more = unknown(why(content, ""), place)
            found.append(Parameter(more, TypedValue(more), (), place))
        else:
            found.append(Parameter(texts.text(name, place), typed(content, place, texts), (), place))
    return tuple(found)


def typed(value: Value, place: Place, texts: Texts) -> TypedValue:
    """One value of a param."""
    if isinstance(value, Handle) and value.kind == "ParameterValue":
        return _described(value, texts)
    if isinstance(value, _SCALARS):
        if isinstance(value, (int, float)) and not abs(value) < _LARGEST:
            return TypedValue(unknown("the number is too large", place))
        return TypedValue(Text((str(value),), place), None, value)
    if is_substitution(value) or is_own_substitution(value):
        return TypedValue(texts.text(value, place))
    if isinstance(value, Seq):
        return _list(value, place, texts)
    if isinstance(value, (Map, Handle, Unknown, Choice)) or value is None:
        return TypedValue(unknown(why(value, "it is no value of a param"), place))
    return TypedValue(texts.text(value, place), "str")


def _list(value: Seq, place: Place, texts: Texts) -> TypedValue:
    items = value.items
    if not value.complete or not items:
        return TypedValue(unknown("the list is not known" if not value.complete else "a list without items has no type", place))
    if any(isinstance(each, (int, float)) and not abs(each) < _LARGEST for each in items):
        return TypedValue(unknown("a number is too large", place))
    kinds = {type(each) for each in items}
    if kinds <= {int, float}:
        plain: Any = tuple(items) if kinds == {int} else tuple(float(each) for each in items)
        return TypedValue(tuple(Text((str(each),), place) for each in items), None, plain)
    if kinds in ({bool}, {str}):
        return TypedValue(tuple(Text((str(each),), place) for each in items), None, tuple(items))
    if any(is_substitution(each) for each in items) and all(is_substitution(each) or isinstance(each, str) for each in items):
        return TypedValue(texts.text(value, place))  # one text, in pieces
    if all(isinstance(each, Seq) for each in items):
        return TypedValue(tuple(texts.text(each, place) for each in items))
    return TypedValue(unknown("it is not known of what the list is", place))


def _described(value: Handle, texts: Texts) -> TypedValue:
    """``ParameterValue(…, value_type=…)``."""
    given, place = value.state, value.state["place"]
    type_, content = given.get("value_type"), given["value"]
    if type_ is None:
        return typed(content, place, texts)
    name = _TYPES.get(type_.name) if isinstance(type_, External) else None
    if name is None or not (
        isinstance(content, str) or is_substitution(content) or is_own_substitution(content) or isinstance(content, Seq)
    ):
        return TypedValue(unknown(why(content if name else type_, "a value of a type that is not known"), place))
    return TypedValue(texts.text(content, place), name)


def set_value(value: Value, place: Place, texts: Texts) -> TypedValue:
    """The value of SetParameter, and of an extra argument: one text, which is read as YAML."""
    if isinstance(value, bool):
        return TypedValue(Text(("true" if value else "false",), place))
    if isinstance(value, (int, float)) and abs(value) < _LARGEST:
        return TypedValue(Text((repr(value),), place))
    if isinstance(value, str) and value.isprintable():
        return TypedValue(Text((_quoted(value),), place))
    if isinstance(value, Handle) and value.kind == "ParameterValue":
        described = _described(value, texts)
        return described if described.type is None or described.type == "str" else TypedValue(described.value)
    if is_substitution(value) or is_own_substitution(value):
        return TypedValue(texts.text(value, place))
    if isinstance(value, Seq) and value.complete and value.items and len({type(each) for each in value.items}) == 1:
        first = value.items[0]
        if isinstance(first, (bool, int, float)) and all(abs(each) < _LARGEST for each in value.items):
            return TypedValue(Text((f"[{', '.join(str(each).lower() for each in value.items)}]",), place))
        if isinstance(first, str) and all(each.isprintable() for each in value.items):
            return TypedValue(Text((f"[{', '.join(map(_quoted, value.items))}]",), place))
    return TypedValue(unknown(why(value, "a value that is not known"), place))


def _quoted(value: str) -> str:
    return "'" + value.replace("'", "''") + "'"

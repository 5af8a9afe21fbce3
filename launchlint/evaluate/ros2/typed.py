"""Performed texts to typed values, by the rules of PyYAML; only some types are allowed.

Source: ``launch/utilities/type_utils.py`` (``coerce_to_type``, ``perform_typed_substitution``) and ``launch_ros``'s
``evaluate_parameters``. Booleans are not converted from numbers, and ``1e3`` and ``y`` are texts here.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import Reader
from launchlint.yaml.values import load

LAUNCH = Reader("launch", longest=1_000_000)
_PYTHON: dict[str, type] = {"str": str, "bool": bool, "int": int, "float": float}
_LIST = "list_of_"
_SCALARS = (bool, int, float, str)
_LONGEST_NUMBER = 4_300


class TypeFault(Exception):
    """launch refuses a value: ``reason`` in plain words."""

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason


def convert(text: str, wanted: str | None, digits_are_boolean: bool = True) -> Any:
    """The value of a performed text, a scalar or a list; ``wanted`` is what ``type`` says. Raises TypeFault and YamlBeyond."""
    if wanted is None:
        return _allowed(by_yaml(text)) if text else text
    if wanted.startswith(_LIST):
        value = _allowed(by_yaml(text)) if text else text
        if not isinstance(value, list) or not is_uniform(value, wanted):
            raise TypeFault(f"YAML reads it as {what(value)}, and type is {wanted}")
        return value
    if wanted == "str":
        return text
    if wanted == "bool":
        if digits_are_boolean and text in ("0", "1"):
            return text == "1"
        value = _allowed(by_yaml(text)) if text else text
        if not isinstance(value, bool):
            raise TypeFault(f"YAML reads it as {what(value)}, and type is bool")
        return value
    try:
        if len(text) > _LONGEST_NUMBER:
            raise ValueError
        return _PYTHON[wanted](text)
    except ValueError:
        raise TypeFault(f"{text[:60]!r} is not {'a whole number' if wanted == 'int' else 'a number'}, and type is {wanted}") from None


def is_uniform(items: Sequence[Any], wanted: str | None) -> bool:
    """Whether the items of a list fit ``wanted``, or, without it, each other (``is_instance_of``)."""
    if wanted is not None:
        return all(isinstance(each, _PYTHON[wanted.removeprefix(_LIST)]) for each in items)
    member = next((type(each) for each in items if type(each) is not str), str)
    return member in _SCALARS and all(isinstance(each, member) for each in items)


def by_yaml_rules(text: str) -> Any:
    """The value of a performed text as ``<set_parameter>`` reads it: a list becomes a tuple, which may not be empty. Raises TypeFault."""
    value = by_yaml(text or "''")
    if isinstance(value, (*_SCALARS, bytes)):
        return value
    if not isinstance(value, list):
        raise TypeFault(f"YAML reads it as {what(value)}, and that is no value of a parameter")
    if not same_type(value):
        raise TypeFault("a list must have items, all of one type: true or false, whole numbers, numbers with a point, or texts")
    return tuple(value)


def same_type(items: Sequence[Any]) -> bool:
    """Whether there are items, all of the type of the first one (``check_sequence_type_is_allowed``)."""
    return bool(items) and type(items[0]) in _SCALARS and all(isinstance(each, type(items[0])) for each in items)


def by_yaml(text: str) -> Any:
    """What YAML makes of a text. Raises TypeFault and YamlBeyond."""
    try:
        return load(text, LAUNCH)
    except YamlError as error:
        raise TypeFault(f"it is no YAML: {error.message}") from None


def load_file(text: str) -> Any:
    """What PyYAML makes of a whole file. Raises YamlError and YamlBeyond."""
    return load(text, LAUNCH)


def what(value: Any) -> str:
    """A value in words."""
    if value is None:
        return "null"
    if isinstance(value, dict):
        return "a mapping"
    if isinstance(value, list):
        return "a list" if all(isinstance(each, _SCALARS) for each in value) else "a list of other things than values"
    names = {str: "a text", bool: "true or false", int: "a whole number", float: "a number with a point", bytes: "binary data"}
    return names.get(type(value), "a date" if hasattr(value, "year") else "something else")


def _allowed(value: Any) -> Any:
    if isinstance(value, list):
        if not value or is_uniform(value, None):
            return value
        raise TypeFault("the items of a list must all be of one type: true or false, whole numbers, numbers with a point, or texts")
    if isinstance(value, _SCALARS):
        return value
    raise TypeFault(f"YAML reads it as {what(value)}, and that is no value of a parameter")

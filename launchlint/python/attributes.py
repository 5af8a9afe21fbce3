"""Which attributes the objects of Python's own classes have."""

from __future__ import annotations

from launchlint.python.plain import SIMPLE
from launchlint.python.values import Map, Seq, Text, Value

_TYPES: dict[str, type] = {"list": list, "tuple": tuple, "set": set, "frozenset": frozenset, "range": range}


def lacks(value: Value, name: str) -> bool:
    """Whether ``value.name`` certainly raises AttributeError."""
    type_: type | None = None
    if isinstance(value, Text):
        type_ = str
    elif isinstance(value, SIMPLE):
        type_ = type(value)
    elif isinstance(value, Map):
        type_ = dict
    elif isinstance(value, Seq):
        type_ = _TYPES.get(value.kind)
    return type_ is not None and not hasattr(type_, name)

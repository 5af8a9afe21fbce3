"""Calls with more arguments than a followed function takes: Python raises TypeError, and nothing behind such a call is reached."""

from __future__ import annotations

from launchlint.python.values import Bound, Class, Function, Value

_PLAIN = ("staticmethod", "classmethod")


def takes_fewer(function: Value, given: int) -> bool:
    """Whether ``function`` certainly takes fewer than ``given`` arguments by position (Python reference, 6.3.4 Calls)."""
    if isinstance(function, Bound):
        return takes_fewer(function.function, given + 1)
    if isinstance(function, Class):
        made_by = _constructor(function)
        return made_by is not None and takes_fewer(made_by, given + 1)
    if not isinstance(function, Function) or not _is_plain(function):
        return False
    arguments = function.node.args
    return arguments.vararg is None and given > len(arguments.posonlyargs) + len(arguments.args)


def _is_plain(function: Function) -> bool:
    """Whether no decorator may have given it other arguments."""
    return all(getattr(each, "id", "") in _PLAIN for each in getattr(function.node, "decorator_list", ()))


def _constructor(type_: Class) -> Value | None:
    """The ``__init__`` that an object of ``type_`` is made with; ``None`` where something that is not followed may come first."""
    for base in type_.order:
        if not isinstance(base, Class) or "__new__" in base.attributes:
            return None
        if "__init__" in base.attributes:
            return base.attributes["__init__"]
    return None

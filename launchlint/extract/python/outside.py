"""Values that come from outside of a program of ROS: params, message classes, and the node's own name."""

from __future__ import annotations

import re
from collections.abc import Sequence

from launchlint.python.builtins import string_method
from launchlint.python.text import ANY, template
from launchlint.python.values import MISSING, SIGNS, UNKNOWN, Choice, Outside, Thing, Value

NODE = SIGNS[0]
"""In a :class:`Text`: the node's own resolved name, ``/namespace/name``."""
NAMESPACE = SIGNS[1]
"""In a :class:`Text`: the node's namespace as rospy.get_namespace gives it, with a slash at its end."""


class Param(Outside):
    """The value of a param. ``default`` is :data:`MISSING` where reading it without one fails."""

    __slots__ = ("default", "name")
    pattern = re.compile(r"[~/]?[A-Za-z0-9_][\w/]*", re.ASCII)

    def __init__(self, name: str, default: Value) -> None:
        self.name = name
        self.default = default

    def template(self) -> str:
        """``{param:~name|default}``."""
        if not self.pattern.fullmatch(self.name):
            return ANY
        if self.default is MISSING or self.default is None:
            return f"{{param:{self.name}}}"
        inner = ANY if isinstance(self.default, Choice) else template(self.default)
        if NODE in inner or NAMESPACE in inner or "}}" in inner.replace("{any}", "") or len(inner) > 200:
            inner = ANY
        return f"{{param:{self.name}|{inner}}}"

    def item(self, index: Value) -> Value:
        """The value of a param that is a dict has other params in it."""
        return Param(f"{self.name}/{index}", MISSING) if isinstance(index, str) and index.isidentifier() else UNKNOWN

    def method(self, name: str, positional: Sequence[Value]) -> Value:
        """What only takes blanks away leaves it the value of the param."""
        if name not in ("strip", "lstrip", "rstrip") or positional:
            return UNKNOWN
        default = string_method(self.default, name, ()) if isinstance(self.default, str) else self.default
        return type(self)(self.name, default)

    def otherwise(self, default: Value) -> Value:
        """``rospy.get_param(x, "") or default``."""
        return type(self)(self.name, default) if self.default in (None, "", MISSING) else MISSING


class MessageClass(Thing):
    """A message, service or action class by its type name, ``package/Type``."""

    __slots__ = ("type",)

    def __init__(self, type_: str) -> None:
        self.type = type_

    def __eq__(self, other: object) -> bool:
        return isinstance(other, MessageClass) and other.type == self.type

    def __hash__(self) -> int:
        return hash(self.type)

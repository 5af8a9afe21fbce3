"""The names that values make."""

from __future__ import annotations

import re

from launchlint.extract.python.outside import NAMESPACE, NODE, Param
from launchlint.python.text import ANY, ANYS, distribute, template, text
from launchlint.python.values import LONGEST_TEXT, MISSING, Choice, Handle, Value

_PLAIN = re.compile(r"[~/]?[A-Za-z0-9_][\w/]*|~|/", re.ASCII)
_LITERAL = re.compile(r"[\w/~]*", re.ASCII)


def ros_joined(namespace: Value, name: Value) -> Value:
    """``rosgraph.names.ns_join(ns, name)``."""

    def join(outer: Value, inner: Value) -> Value:
        start, end = template(outer), template(inner)
        if end.startswith(("/", "~", NODE, NAMESPACE)) or not start:
            return text(end)
        return text(start + end if start == "~" or start.endswith(("/", NAMESPACE)) else f"{start}/{end}")

    return distribute(join, namespace, name)


def ros_name(value: Value) -> str:
    """The name that a value makes when a program gives it to rospy, spelled as in the library format (``{any}`` where nothing is known).

    rospy.names.canonicalize_name: slashes in a row count as one, and none is left at the end.
    """
    if isinstance(value, Handle):
        return ANY
    if isinstance(value, Param) and value.default is not MISSING and not isinstance(value.default, Choice):
        inner = template(value.default)
        if NODE in inner or NAMESPACE in inner:
            value = Param(value.name, ros_name(value.default))  # the whole name is the default: it is one of this node's names
    spelled = template(value)
    if len(spelled) > LONGEST_TEXT:
        return ANY
    if spelled.startswith("/" + NODE):
        spelled = spelled[1:]
    if spelled.startswith("/" + NAMESPACE):
        spelled = spelled[1:]
    if spelled.startswith("/{remap:"):
        spelled = spelled[1:]
    if spelled.startswith(NODE):
        rest = spelled[len(NODE) :]
        spelled = "~" + rest.lstrip("/") if not rest or rest[0] == "/" else "{node}" + rest
    elif spelled.startswith(NAMESPACE):
        spelled = spelled[len(NAMESPACE) :].lstrip("/") or ANY
    spelled = spelled.replace(NODE, ANY).replace(NAMESPACE, ANY)
    if spelled.startswith("{param:") and spelled.endswith("|}"):
        spelled = spelled[:-2] + "}"  # an empty name is none
    spelled = re.sub(r"/{2,}", "/", ANYS.sub(ANY, spelled))
    if spelled.startswith("~/"):
        spelled = "~" + spelled[2:]
    if len(spelled) > 1:
        spelled = spelled.removesuffix("/")
    if "{" not in spelled and "}" not in spelled:
        return spelled if _PLAIN.fullmatch(spelled) else ANY
    rest = spelled
    for _ in range(20):
        rest, count = re.subn(r"\{[^{}]*\}", "", rest)
        if not count:
            break
    return spelled if _LITERAL.fullmatch(rest) and "~" not in rest[1:] else ANY

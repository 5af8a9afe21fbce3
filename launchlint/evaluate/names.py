"""ROS graph names as roslaunch joins and checks them (rosgraph.names)."""

from __future__ import annotations

import re

UNKNOWN_NAMESPACE = "unknown_namespace"
"""Stands in names for a namespace whose value is unknown; two of them need not be the same."""

_LEGAL = re.compile(r"[~/A-Za-z][\w/]*", re.ASCII)
_LEGAL_UNICODE = re.compile(r"[~/A-Za-z][\w/]*")


def join(namespace: str, name: str) -> str:
    """``name`` inside ``namespace``; global and private names stay as they are (rosgraph.names.ns_join)."""
    if name[:1] in ("~", "/") and name:
        return name
    if namespace == "~":
        return "~" + name
    if not namespace:
        return name
    return namespace + name if namespace.endswith("/") else f"{namespace}/{name}"


def canonical(name: str) -> str:
    """``name`` without doubled or trailing slashes (rosgraph.names.canonicalize_name)."""
    if not name or name == "/":
        return name
    joined = "/".join(part for part in name.split("/") if part)
    return "/" + joined if name[0] == "/" else joined


def as_namespace(name: str) -> str:
    """``name`` as a global namespace with slashes at both ends (rosgraph.names.make_global_ns).

    Raises ValueError for a private name, which cannot be made global.
    """
    if name.startswith("~"):
        raise ValueError(f"the private name {name} cannot be a namespace")
    if not name.startswith("/"):
        name = "/" + name
    return name if name.endswith("/") else name + "/"


def child_namespace(namespace: str, name: str | None) -> str:
    """The namespace that ``ns="name"`` opens inside ``namespace`` (roslaunch.loader.LoaderContext.child).

    Raises ValueError for a private name.
    """
    if not name:
        return namespace
    return as_namespace(name if name[0] == "/" else join(namespace, name))


def is_legal(name: str) -> bool:
    """Whether roslaunch takes ``name`` for a legal graph name; the empty name is (rosgraph.names.is_legal_name)."""
    return not name or (_LEGAL_UNICODE.fullmatch(name) is not None and "//" not in name)


def is_portable(name: str) -> bool:
    """Whether roscpp and rospy both take ``name``: as :func:`is_legal`, in ASCII."""
    return not name or (_LEGAL.fullmatch(name) is not None and "//" not in name)

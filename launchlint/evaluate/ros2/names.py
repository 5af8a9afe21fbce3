"""Names of nodes and namespaces: how launch_ros joins them, and what it refuses (launch_ros.utilities.namespace_utils, rmw)."""

from __future__ import annotations

import re

LONGEST_NAME = 255
LONGEST_NAMESPACE = 245
_NOT_IN_NAME = re.compile(r"[^a-zA-Z0-9_]")
_NOT_IN_NAMESPACE = re.compile(r"[^a-zA-Z0-9_/]")


def prefixed(base: str | None, namespace: str | None) -> str | None:
    """``namespace`` below ``base``: an absolute one stays as it is; without a ``/`` at its end. None where there is none of both."""
    if namespace is None:
        joined = base
    elif not base or namespace.startswith("/"):
        joined = namespace
    else:
        joined = ("" if base == "/" else base) + "/" + namespace
    return joined if joined is None or joined == "/" else joined.rstrip("/")


def absolute(namespace: str | None) -> str | None:
    """With a ``/`` at its beginning."""
    return namespace if namespace is None or namespace.startswith("/") else "/" + namespace


def name_fault(name: str) -> str:
    """What is wrong with a node's name, in plain words; empty where nothing is (rmw_validate_node_name)."""
    if not name:
        return "it is empty"
    if _NOT_IN_NAME.search(name):
        return "it holds something else than letters, digits and underscores"
    if name[0].isdigit():
        return "it starts with a digit"
    return f"it is longer than {LONGEST_NAME} characters" if len(name) > LONGEST_NAME else ""


def namespace_fault(namespace: str) -> str:
    """The same for a namespace (rmw_validate_namespace)."""
    if namespace == "/":
        return ""
    if _NOT_IN_NAMESPACE.search(namespace):
        return "it holds something else than letters, digits, underscores and slashes"
    if "//" in namespace:
        return "it has two slashes in a row"
    if re.search(r"/[0-9]", namespace):
        return "a part of it starts with a digit"
    return f"it is longer than {LONGEST_NAMESPACE} characters" if len(namespace) > LONGEST_NAMESPACE else ""

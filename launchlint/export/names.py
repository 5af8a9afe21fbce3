"""Namespaces and names as the exported file spells them: relative where they were relative, so that the file may itself be included."""

from __future__ import annotations

from launchlint.export.tree import Out
from launchlint.export.written import Written


def below(namespace: str, name: Written) -> str:
    """``name`` in ``namespace``, which is written relative to the enclosing group; global and private names stay as they are
    (rosgraph.names.ns_join).
    """
    if name.known[:1] in ("/", "~") or not namespace:
        return name.text
    if namespace == "~":
        return f"~{name.text}"
    return f"{namespace.rstrip('/')}/{name.text}"


def open_namespace(namespace: str) -> Out:
    """The group for names whose own namespace is decided only when the file is started: it may be a global one."""
    return Out("group", {"ns": namespace})

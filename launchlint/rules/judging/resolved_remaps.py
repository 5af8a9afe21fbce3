"""Names in remaps as the node resolves them."""

from __future__ import annotations

from launchlint.evaluate.names import UNKNOWN_NAMESPACE, canonical
from launchlint.model import Node


def has_known_name(node: Node) -> bool:
    """Whether the node's name and namespace are certain, so that names can be resolved."""
    return bool(node.name) and node.knows("name", "namespace") and UNKNOWN_NAMESPACE not in node.namespace


def resolve(node: Node, name: str) -> str:
    """The global name that ``name`` in a remap of ``node`` stands for (rosgraph.names.resolve_name)."""
    if name.startswith("/"):
        return canonical(name)
    if name.startswith("~"):
        return canonical(f"{node.full_name}/{name[1:]}")
    return canonical(node.namespace + name)

"""The nodes of a syntax tree, one after the other: many look for something in the same trees."""

from __future__ import annotations

import ast

_LEAVES = (ast.Load, ast.Store, ast.Del)
_KEPT = "nodes"


def children(node: ast.AST) -> list[ast.AST]:
    """What stands directly below a node, without what only says whether a name is read or written."""
    found: list[ast.AST] = []
    for name in node._fields:
        value = getattr(node, name, None)
        if isinstance(value, list):
            found += [each for each in value if isinstance(each, ast.AST)]
        elif isinstance(value, ast.AST) and type(value) not in _LEAVES:
            found.append(value)
    return found


def walk(node: ast.AST) -> list[ast.AST]:
    """A node and all below it, in the order of ``ast.walk``; they stay with the node."""
    known: list[ast.AST] | None = vars(node).get(_KEPT)
    if known is None:
        known = [node]
        for each in known:  # grows on the way
            known += children(each)
        setattr(node, _KEPT, known)
    return known

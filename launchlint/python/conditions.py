"""Conditions as text: what the source says, and its opposite."""

from __future__ import annotations

import ast
import re

_SAID = "said"
_SIMPLE = re.compile(r"[\w.]+(?:\([^()]*\))?")


def written(node: ast.expr) -> str:
    """The source text of a condition, on one line; it stays with the node, since loops and callbacks ask for it again."""
    known: str | None = vars(node).get(_SAID)
    if known is None:
        known = _written(node)
        setattr(node, _SAID, known)
    return known


def _written(node: ast.expr) -> str:
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        return negated(written(node.operand))
    try:
        said = " ".join(ast.unparse(node).split())
    except (ValueError, RecursionError):
        said = "a condition"
    if isinstance(node, ast.BoolOp) and isinstance(node.op, ast.Or):
        said = f"({said})"
    return said if len(said) <= 200 else said[:199] + "…"


def negated(said: str) -> str:
    """The text of a condition turned round."""
    if said.startswith("not (") and said.endswith(")") and _closes_at_end(said[4:]):
        return said[5:-1]
    if said.startswith("not ") and _SIMPLE.fullmatch(said[4:]):
        return said[4:]
    return f"not {said}" if _SIMPLE.fullmatch(said) or (said.startswith("(") and _closes_at_end(said)) else f"not ({said})"


def _closes_at_end(said: str) -> bool:
    depth = 0
    for at, char in enumerate(said):
        depth += (char == "(") - (char == ")")
        if depth == 0:
            return at == len(said) - 1
    return False

"""Values of a program that nothing is made of: texts that are only printed, or held by variables that nobody reads.

What a launch configuration becomes in such a value reaches no action. It is read off the text, by the names of variables in the whole
module: one that is read anywhere else counts as used.
"""

from __future__ import annotations

import ast

from launchlint.python.walking import walk

_HARMLESS = frozenset("str bool repr len int float".split())
_OF_TEXTS = frozenset("format join lower upper strip lstrip rstrip replace split".split())
_SAYS = frozenset("debug info warning warn error critical".split())
_LOOKS = frozenset(("locals", "globals", "vars", "eval", "exec"))


def idle(tree: ast.Module) -> frozenset[int]:
    """The expressions, by identity, of which nothing comes but text on the terminal."""
    held: list[tuple[set[str], list[ast.AST]]] = []
    said: list[list[ast.AST]] = []
    for node in walk(tree):
        if isinstance(node, (ast.Assign, ast.AnnAssign)) and node.value is not None:
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            inner = list(walk(node.value))
            if all(isinstance(each, ast.Name) for each in targets) and all(map(_is_harmless, inner)):
                held.append(({each.id for each in targets if isinstance(each, ast.Name)}, inner))
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) and _is_said(node.value):
            inner = [each for argument in (*node.value.args, *node.value.keywords) for each in walk(argument)]
            if all(map(_is_harmless, inner)):
                said.append(inner)
    if not held and not said:
        return frozenset()
    quiet = {id(each) for inner in (*said, *(inner for _, inner in held)) for each in inner}
    waiting = {
        each.id for each in walk(tree) if isinstance(each, ast.Name) and not isinstance(each.ctx, ast.Store) and id(each) not in quiet
    }
    if waiting & _LOOKS:
        return frozenset()
    read: dict[str, list[int]] = {}
    for at, (names, _) in enumerate(held):
        for name in names:
            read.setdefault(name, []).append(at)
    used: set[int] = set()
    while waiting:
        for at in read.pop(waiting.pop(), ()):
            if at not in used:
                used.add(at)
                waiting.update(each.id for each in held[at][1] if isinstance(each, ast.Name))
    return frozenset(id(each) for inner in (*said, *(inner for at, (_, inner) in enumerate(held) if at not in used)) for each in inner)


def _is_harmless(node: ast.AST) -> bool:
    """Whether a part of an expression does nothing but give a value."""
    if isinstance(node, (ast.NamedExpr, ast.Await, ast.Yield, ast.YieldFrom, ast.Lambda)):
        return False
    if not isinstance(node, ast.Call):
        return True
    of = node.func
    if isinstance(of, ast.Name):
        return of.id in _HARMLESS or of.id[:1].isupper()  # a class of launch
    return isinstance(of, ast.Attribute) and (of.attr in _OF_TEXTS or of.attr[:1].isupper() or ast.unparse(of).startswith("os.path."))


def _is_said(call: ast.Call) -> bool:
    """Whether it prints or logs something."""
    of = call.func
    return of.id == "print" if isinstance(of, ast.Name) else isinstance(of, ast.Attribute) and of.attr in _SAYS

"""What functions take: calls that Python refuses with a TypeError, and functions that are generators."""

from __future__ import annotations

import ast

from launchlint.python.failures import failure
from launchlint.python.values import MORE, Function, Value
from launchlint.python.walking import children, walk

_GENERATES = "generates"
_INSIDE = "own nodes"
_OWN = "own"
_OTHERS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)


def check_arguments(function: Function, positional: list[Value], keywords: dict[str, Value]) -> None:
    """Raises Raised (TypeError) where ``function`` does not take these arguments (Python reference, 6.3.4 Calls)."""
    arguments = function.node.args
    names = [each.arg for each in (*arguments.posonlyargs, *arguments.args)]
    called = getattr(function.node, "name", "<lambda>")
    if arguments.vararg is None and len(positional) > len(names) and MORE not in keywords:
        raise failure("TypeError", f"{called}() takes {len(names)} positional arguments but {len(positional)} were given")
    only = {each.arg for each in arguments.kwonlyargs}
    by_name = {each.arg for each in arguments.args} | only
    for name in keywords:
        if name == MORE:
            continue
        if name not in by_name and arguments.kwarg is None:
            raise failure("TypeError", f"{called}() got an unexpected keyword argument {name!r}")
        if name in names[: len(positional)] and name in by_name and MORE not in keywords:
            raise failure("TypeError", f"{called}() got multiple values for argument {name!r}")
    if MORE in keywords:
        return
    optional = {*names[len(names) - len(function.defaults) :], *(name for name, _ in function.keyword_defaults)}
    lacking = [each for each in (*names[len(positional) :], *sorted(only)) if each not in keywords and each not in optional]
    if lacking:
        raise failure("TypeError", f"{called}() missing {len(lacking)} required arguments: {lacking[0]!r}")


def is_generator(node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda) -> bool:
    """Whether a function gives its values one by one; that stays with the node, since loops ask for it again."""
    known: bool | None = vars(node).get(_GENERATES)
    if known is None:
        known = any(isinstance(each, (ast.Yield, ast.YieldFrom)) for each in own_nodes(node))
        setattr(node, _GENERATES, known)
    return known


def own_nodes(node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda) -> list[ast.AST]:
    """What stands in a function, without the functions and classes in it; they stay with the node."""
    known: list[ast.AST] | None = vars(node).get(_INSIDE)
    if known is None:
        known = []
        waiting: list[ast.AST] = [node.body] if isinstance(node, ast.Lambda) else list(node.body)
        while waiting:
            each = waiting.pop()
            known.append(each)
            if not isinstance(each, _OTHERS):
                waiting += children(each)
        setattr(node, _INSIDE, known)
    return known


def own_names(node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda) -> frozenset[str]:
    """The variables that a function writes itself; they stay with the node."""
    known: frozenset[str] | None = vars(node).get(_OWN)
    if known is None:
        found: set[str] = set()
        for each in own_nodes(node):
            if isinstance(each, ast.Name) and isinstance(each.ctx, (ast.Store, ast.Del)):
                found.add(each.id)
            elif isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
                found.add(each.name)
            elif isinstance(each, ast.alias):
                found.add((each.asname or each.name).partition(".")[0])
            elif isinstance(each, (ast.MatchAs, ast.MatchStar, ast.ExceptHandler)) and each.name:
                found.add(each.name)
        known = frozenset(found - _only_in_loops(node))
        setattr(node, _OWN, known)
    return known


def _only_in_loops(node: ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda) -> set[str]:
    """The names that the loops of comprehensions have for themselves, and nothing else in the function writes."""
    loops = {
        id(name): name.id
        for each in own_nodes(node)
        if isinstance(each, (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp))
        for loop in each.generators
        for name in walk(loop.target)
        if isinstance(name, ast.Name)
    }
    written = (each for each in own_nodes(node) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store))
    return set(loops.values()) - {each.id for each in written if id(each) not in loops}

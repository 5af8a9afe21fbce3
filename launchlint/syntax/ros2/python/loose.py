"""What of Python the interpreter does not follow to the letter: a file with such in it is not known."""

from __future__ import annotations

import ast

from launchlint.python.modules import ModuleFinder
from launchlint.python.source import Source, SourceError

_LOOSE_STATEMENTS = (
    ast.Set,
    ast.SetComp,
    ast.Delete,
    ast.AsyncFunctionDef,
    ast.AsyncFor,
    ast.AsyncWith,
    ast.Yield,
    ast.YieldFrom,
    ast.Match,
)
_LOOSE_METHODS = frozenset("sort reverse insert pop popitem remove discard clear popleft appendleft rotate format_map".split())
_LOOSE_FUNCTIONS = frozenset(
    """set frozenset sorted reversed iter next exec eval setattr delattr globals locals vars type filter round hash id divmod sum any all
    min max open input raw_input file compile breakpoint __import__""".split()
)
"""What the interpreter knows well enough for names that programs make, and not for the order of things and what is taken away."""


def loose(tree: ast.Module) -> str:
    """What in a module is not followed to the letter; empty where all is."""
    for node in ast.walk(tree):
        if isinstance(node, _LOOSE_STATEMENTS):
            return f"line {node.lineno}: a statement that is not followed to the letter"
        if isinstance(node, ast.Call):
            function = node.func
            if isinstance(function, ast.Attribute) and function.attr in _LOOSE_METHODS:
                return f"line {node.lineno}: .{function.attr}() is not followed to the letter"
            if isinstance(function, ast.Name) and function.id in _LOOSE_FUNCTIONS:
                return f"line {node.lineno}: {function.id}() is not followed to the letter"
    return ""


class LetterModules(ModuleFinder):
    """Modules that are followed to the letter."""

    __slots__ = ()

    def parse(self, path: str) -> Source:
        """A module. Raises SourceError."""
        source = super().parse(path)
        reason = loose(source.tree)
        if reason:
            raise SourceError(reason)
        return source

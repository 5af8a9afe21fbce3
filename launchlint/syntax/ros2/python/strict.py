"""The interpreter for launch files: where it would guess, or go on with less than there is, it gives up."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from launchlint.python.calls import DEEPEST_CALL, MOST_SPENT
from launchlint.python.memory import ENDED, Branch
from launchlint.python.modules import ModuleFinder
from launchlint.python.source import Source
from launchlint.python.values import UNKNOWN, Function, Handle, Map, Scope, Seq, Value, alternatives
from launchlint.source import Place, Span
from launchlint.source import Source as Written
from launchlint.syntax.ros2.python.noticing import Noticing
from launchlint.syntax.ros2.python.recogniser import LaunchRecogniser, Outside
from launchlint.syntax.ros2.python.texts import NotUnderstood
from launchlint.workspace import looking

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


class StrictModules(ModuleFinder):
    """Modules that are followed to the letter."""

    __slots__ = ()

    def parse(self, path: str) -> Source:
        """A module. Raises NotUnderstood, SourceError."""
        source = super().parse(path)
        reason = loose(source.tree)
        if reason:
            raise NotUnderstood(reason)
        return source


class Strict(Noticing):
    """Follows one launch file. All methods raise NotUnderstood."""

    def __init__(self, written: Written, outside: Outside, root: str, package: str, finder: ModuleFinder) -> None:
        recogniser = LaunchRecogniser(self, outside, self.place)
        super().__init__(recogniser, root, package, finder, package or "\0")
        self.environment: Map = recogniser.environment
        self.outside = outside
        self._written: dict[str, Written] = {self.shown(written.file): written}

    def place(self, node: ast.AST, scope: Scope) -> Place:
        """Where an expression stands."""
        path = scope.module.path
        source = self._written.get(path)
        if source is None:
            text = looking.content(f"{self.root}/{path}") or b""
            source = self._written[path] = Written(path, text.decode("utf-8-sig", "replace"), f"{self.root}/{path}")
        line, end = getattr(node, "lineno", 1), getattr(node, "end_lineno", None)
        start = _offset(source, line, getattr(node, "col_offset", 0))
        return Place(source, Span(start, start if end is None else _offset(source, end, getattr(node, "end_col_offset", 0))))

    def name_place(self, function: Function) -> Place:
        """Where the name of a function stands in its definition."""
        node = function.node
        source, span = self.place(node, function.scope)
        if isinstance(node, ast.Lambda):
            return Place(source, span)
        start = source.text.find(node.name, span.start)
        return Place(source, Span(start, start + len(node.name))) if start >= 0 else Place(source, span)

    def doubt(self, reason: str, path: str, line: int) -> None:
        """Doubts are what is not understood."""
        raise NotUnderstood(f"line {line} of {path}: {reason}")

    def escape(self, values: Sequence[Value], when: str, depth: int = 0) -> None:
        """Whoever is given objects of launch may do anything with them."""
        for value in values:
            for _, each in alternatives(value):
                if isinstance(each, Handle) and "place" in each.state:
                    raise NotUnderstood(f"{each.kind} is given to what is not known", each.state["place"])
                if isinstance(each, (Seq, Map)) and depth < 4:
                    inner = each.items if isinstance(each, Seq) else list(each.entries.values())
                    self.escape(inner, when, depth + 1)

    def _give(self, values: list[Value], node: ast.AST, scope: Scope) -> None:
        raise NotUnderstood("a function that is not known", self.place(node, scope))

    def item(self, value: Value, index: Value) -> Value:
        """An item that is not there ends the program, as one that is not known may."""
        found = super().item(value, index)
        if found is UNKNOWN:
            raise NotUnderstood("an item that is not known, or not there")
        return found

    def _widen(self, body: Sequence[ast.stmt], scope: Scope) -> None:
        raise NotUnderstood("a loop of which not all rounds are known")

    def call_function(self, function: Function, positional: list[Value], keywords: dict[str, Value]) -> Value:
        """Functions are followed as deep as they go, or not at all."""
        node = function.node
        if self.active.count(id(node)) >= 2 or len(self.active) >= DEEPEST_CALL or self._spent.get(id(node), 0) > MOST_SPENT:
            raise NotUnderstood("functions in functions too deep to be followed", self.place(node, function.scope))
        return super().call_function(function, positional, keywords)

    def _meet(self, ways: list[tuple[str, Branch]], scope: Scope) -> int:
        if any(way.flow == ENDED for _, way in ways):
            raise NotUnderstood("it may end with an error")
        return super()._meet(ways, scope)


def _offset(source: Written, line: int, column: int) -> int:
    """The offset of a column that is counted in bytes of UTF-8."""
    starts = source.line_starts
    if not 1 <= line <= len(starts):
        return len(source.text)
    start = starts[line - 1]
    return start + len(source.line(line).encode("utf-8", "replace")[:column].decode("utf-8", "ignore"))

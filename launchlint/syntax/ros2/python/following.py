"""The interpreter for launch files: it goes on with what it does not know, and lists and dicts that it loses sight of stay open."""

from __future__ import annotations

import ast
import os
from collections.abc import Callable, Sequence

from launchlint.python.failures import Asked, Raised
from launchlint.python.memory import ENDED, Ended
from launchlint.python.values import (
    COMPLETE,
    MISSING,
    UNKNOWN,
    Choice,
    External,
    Failure,
    Function,
    Handle,
    Instance,
    Map,
    Scope,
    Seq,
    Unknown,
    Value,
    alternatives,
)
from launchlint.source import Place, Span
from launchlint.source import Source as Written
from launchlint.syntax.ros2.python.bundled import DIRECTORY
from launchlint.syntax.ros2.python.command_line import SIGN, Word
from launchlint.syntax.ros2.python.files import FILE
from launchlint.syntax.ros2.python.noticing import Noticing
from launchlint.syntax.ros2.python.paths import is_path, spelled
from launchlint.syntax.ros2.python.recogniser import PACKAGES, LaunchRecogniser, Outside
from launchlint.syntax.ros2.python.running import VARIABLES
from launchlint.syntax.ros2.python.texts import is_of_class
from launchlint.syntax.ros2.python.workspace_modules import WorkspaceModules
from launchlint.workspace import looking

MOST_DEEP = 8


class Following(Noticing):
    """Follows one launch file, and the modules of the workspace that it imports."""

    exact = True
    most_steps = 300_000

    def __init__(self, written: Written, outside: Outside, root: str, package: str, finder: WorkspaceModules) -> None:
        recogniser = LaunchRecogniser(self, outside, self.place)
        super().__init__(recogniser, root, package, finder, package or "\0")
        self.finder: WorkspaceModules = finder
        self.known = recogniser
        self._outside = outside
        self._written: dict[str, Written] = {self.shown(written.file): written}
        self._unknowns = 0
        self._unknown: Unknown | None = None
        self._models = self.shown(DIRECTORY) + "/"
        self._entered: tuple[ast.AST, Scope]

    def place(self, node: ast.AST, scope: Scope) -> Place:
        """Where an expression stands; of one in a model, where the launch file calls that."""
        path = scope.module.path
        if path.startswith(self._models):
            node, scope = self._entered
            path = scope.module.path
        source = self._written.get(path)
        if source is None:
            file = os.path.normpath(f"{self.root}/{path}")
            text = (looking.content(file) or b"").decode("utf-8-sig", "replace")
            source = self._written[path] = Written(self._outside.shown(file), text, file)
        line, end = getattr(node, "lineno", 1), getattr(node, "end_lineno", None)
        start = source.offset(line, getattr(node, "col_offset", 0))
        return Place(source, Span(start, start if end is None else source.offset(end, getattr(node, "end_col_offset", 0))))

    def call(self, function: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Call ``function`` from a place in the module of ``scope``."""
        if not scope.module.path.startswith(self._models):
            self._entered = node, scope
        return super().call(function, positional, keywords, node, scope)

    def import_module(self, name: str, level: int, node: ast.stmt, scope: Scope) -> Value:
        """A module by its name as an import statement says it."""
        if not scope.module.path.startswith(self._models):
            self._entered = node, scope
        return super().import_module(name, level, node, scope)

    def name_place(self, function: Function) -> Place:
        """Where the name of a function stands in its definition."""
        node = function.node
        source, span = self.place(node, function.scope)
        if isinstance(node, ast.Lambda):
            return Place(source, span)
        start = source.text.find(node.name, span.start)
        return Place(source, Span(start, start + len(node.name))) if start >= 0 else Place(source, span)

    def doubt(self, reason: str, path: str, line: int) -> None:
        """What is not known is a value of its own here."""

    def lost(self, values: list[Value]) -> None:
        """What one of too many values is, is not known; nothing else follows from it."""

    # -- what is not known ---------------------------------------------------------------------------------------------

    def evaluate(self, node: ast.expr | None, scope: Scope) -> Value:
        """The value of an expression; one that is not known says where that began."""
        before = self._unknowns
        try:
            value = super().evaluate(node, scope)
        except Raised as raised:
            if node is None:
                raise
            if raised.asked is not None and not raised.where and not self.catching:
                self.asks(raised.asked, self.place(node, scope))
                return self.known.texts.stand_in(raised.asked)
            if not raised.where or raised.where[-1][1].module is not scope.module:
                raised.where.append((node, scope))
            raise
        if not isinstance(value, Unknown) or node is None:
            return value
        if value is UNKNOWN:
            inner = self._unknown if self._unknowns > before else None
            value = inner if inner is not None else Unknown(_why(node), self.place(node, scope))
        self._unknowns += 1
        self._unknown = value
        return value

    def escape(self, values: Sequence[Value], when: str, depth: int = 0) -> None:
        """Values are given to code that is not followed: it may change what can be changed."""
        for value in values:
            for _, each in alternatives(value):
                if depth > MOST_DEEP:
                    return
                if isinstance(each, (Seq, Map)):
                    inner = each.items if isinstance(each, Seq) else list(each.entries.values())
                    if not (isinstance(each, Seq) and each.is_tuple):
                        self.store(each.content, COMPLETE, False)
                    self.escape(inner, when, depth + 1)
                elif isinstance(each, Handle):
                    self.known.given_away(each)
                elif isinstance(each, Instance):
                    self.escape(list(each.attributes.values()), when, depth + 2)

    def item(self, value: Value, index: Value) -> Value:
        """``value[index]``; one that is not there ends the program."""
        if value is self.known.environment and isinstance(index, str) and index not in value.entries and value.is_sure:
            raise self._unset(index)
        if isinstance(value, Handle) and not isinstance(index, Choice):
            found = self.known.running.item(value, index)
            if found is MISSING and value.kind == VARIABLES and isinstance(index, str):
                raise self._unset(index)
            return self.fails("KeyError", index) if found is MISSING else found
        return super().item(value, index)

    @staticmethod
    def _unset(variable: str) -> Raised:
        return Raised(Failure(External("builtins.KeyError"), (variable,)), asked=Asked("env", variable))

    def _set_item(self, owner: Value, index: Value, value: Value) -> None:
        if isinstance(owner, Handle):
            self.known.running.set_item(owner, index, value)
        else:
            super()._set_item(owner, index, value)

    def combine(self, left: Value, operation: type[ast.operator], right: Value) -> Value:
        """``left operation right``."""
        if operation is ast.Div and not isinstance(left, Choice) and not isinstance(right, Choice) and (is_path(left) or is_path(right)):
            made = self.known.paths.made([left, right])
            return self.unknown() if made is MISSING else made
        return super().combine(left, operation, right)

    def as_text(self, value: Value) -> Value:
        """``str(value)``."""
        return spelled(value) if is_path(value) else super().as_text(value)

    def _rounds_exactly(self, value: Value) -> tuple[list[Value], bool]:
        if isinstance(value, Handle) and value.kind == FILE:
            return self.known.files.lines(value)
        return super()._rounds_exactly(value)

    def call_external(self, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Call something of a module that is not followed."""
        if name == "builtins.open":
            return self.known.files.call(name, positional, keywords, self.place(node, scope))
        known = is_of_class(*positional) if name == "builtins.isinstance" and len(positional) == 2 else None
        if known is not None:
            return known
        return super().call_external(name, positional, keywords, node, scope)

    def keys_for(self, items: Sequence[Value], key: Value = None) -> list[Value]:
        """What items are compared by: paths by their parts."""
        if key is None and items and all(map(is_path, items)):
            return [str(spelled(each)).split("/") for each in items]
        return super().keys_for(items, key)

    def compared(self, left: Value, operation: type[ast.cmpop], right: Value) -> Value:
        """``left operation right``."""
        if operation in (ast.Eq, ast.NotEq) and is_path(left) and is_path(right):
            return (spelled(left) == spelled(right)) is (operation is ast.Eq)
        if operation in (ast.In, ast.NotIn) and isinstance(right, Handle) and right.kind == PACKAGES:
            there = self.known.has_package(left)
            return there if isinstance(there, Unknown) else there is (operation is ast.In)
        if isinstance(right, Word) and operation in (ast.In, ast.NotIn) and isinstance(left, str) and SIGN in left:
            return operation is ast.NotIn
        if operation in (ast.In, ast.NotIn) and isinstance(right, Handle):
            found = self.known.running.item(right, left)
            return found if isinstance(found, Unknown) else (found is not MISSING) is (operation is ast.In)
        return super().compared(left, operation, right)

    def attempt(self, work: Callable[[], Value]) -> Value:
        """What ``work`` gives, with all that it has written taken back; MISSING where it ends."""
        made: Value = MISSING
        with self.branch("") as branch:
            try:
                made = work()
            except Ended:
                branch.flow = ENDED
        return made


def _why(node: ast.AST) -> str:
    said = " ".join(ast.unparse(node).split())
    if len(said) > 60:
        said = said[:59] + "…"
    return f"what {said} gives is not known"

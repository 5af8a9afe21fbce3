"""Statements of a ``setup.py``, followed one by one without running them: what is given to ``setup()``.

What cannot be known stays :data:`~launchlint.workspace.ament.setup_values.UNKNOWN`; both ways are gone through an ``if`` whose condition is
not known, and what they set is unknown afterwards.

This is no second :mod:`launchlint.python`: that room stands above this one, and follows programs for what they do, in order and to the
letter. Here only is asked which files may be installed: a list is a collection of which any part may be unknown, and paths are those of
the package.
"""

from __future__ import annotations

import ast
import os
import warnings
from collections.abc import Sequence

from launchlint.workspace.ament.setup_expressions import Evaluator, TooMuch
from launchlint.workspace.ament.setup_files import Files
from launchlint.workspace.ament.setup_values import UNKNOWN, Function, Name, items

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.ament.setup_values import Value

_DEEPEST = 20
_LONGEST_LOOP = 10_000
_MOST_ITEMS = 20_000


class _Leave(Exception):
    """A ``return``, ``break``, ``continue`` or ``raise``: ``kind`` says which."""

    def __init__(self, kind: str, value: Value = None) -> None:
        self.kind = kind
        self.value = value


def setup_calls(text: str, directory: str) -> list[dict[str, Value]] | None:
    """The keyword arguments of each call of ``setup()`` in the ``setup.py`` of the package at ``directory`` (absolute).

    ``**`` among the names stands for more of them. ``None`` where the file cannot be followed to its end.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(text)
        script = _Script(directory)
        script.run(tree.body)
    except _Leave:
        pass
    except (SyntaxError, ValueError, RecursionError, MemoryError, TooMuch):
        return None
    return script.evaluator.setups


class _Script:
    def __init__(self, directory: str) -> None:
        variables: dict[str, Value] = {"__file__": os.path.join(directory, "setup.py"), "__name__": "__main__"}
        self.evaluator = Evaluator(Files(directory), variables, self.call)
        self._depth = 0

    def run(self, body: Sequence[ast.stmt]) -> None:
        """Follow statements in order."""
        for statement in body:
            does = getattr(self, f"_{type(statement).__name__.lower()}", None)
            if does is not None:
                does(statement)

    def call(self, function: Function, given: list[Value], named: dict[str, Value]) -> Value:
        """Call a function of the file."""
        if self._depth >= _DEEPEST:
            raise TooMuch
        arguments = function.arguments
        names = [each.arg for each in (*arguments.posonlyargs, *arguments.args)]
        variables = dict(function.around)
        defaults = [self.evaluator.value(each) for each in arguments.defaults]
        variables |= dict(zip(names[len(names) - len(defaults) :], defaults, strict=True))
        variables |= {
            each.arg: self.evaluator.value(value) for each, value in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)
        }
        variables |= dict(zip(names, given, strict=False))
        if arguments.vararg is not None:
            variables[arguments.vararg.arg] = tuple(given[len(names) :])
        if arguments.kwarg is not None:
            variables[arguments.kwarg.arg] = {key: value for key, value in named.items() if key not in names}
        variables |= named
        outer, self.evaluator.variables = self.evaluator.variables, variables
        self._depth += 1
        try:
            if isinstance(function.body, ast.expr):
                return self.evaluator.value(function.body)
            self.run(function.body)
        except _Leave as leave:
            return leave.value if leave.kind == "return" else UNKNOWN
        finally:
            self.evaluator.variables = outer
            self._depth -= 1
        return None

    # -- one for each kind of statement -------------------------------------------------------------------------------

    def _expr(self, node: ast.Expr) -> None:
        self.evaluator.value(node.value)

    def _assign(self, node: ast.Assign) -> None:
        value = self.evaluator.value(node.value)
        for target in node.targets:
            self.evaluator.assign(target, value)

    def _annassign(self, node: ast.AnnAssign) -> None:
        if node.value is not None:
            self.evaluator.assign(node.target, self.evaluator.value(node.value))

    def _augassign(self, node: ast.AugAssign) -> None:
        before, value = self.evaluator.value(node.target), self.evaluator.value(node.value)
        if isinstance(node.op, ast.Add) and isinstance(before, list):
            listed = items(value)
            before.extend([UNKNOWN] if listed is None or len(before) + len(listed) > _MOST_ITEMS else listed)
        else:
            self.evaluator.assign(node.target, self.evaluator.add(before, value) if isinstance(node.op, ast.Add) else UNKNOWN)

    def _import(self, node: ast.Import) -> None:
        for alias in node.names:
            name = alias.asname or alias.name.partition(".")[0]
            self.evaluator.variables[name] = Name(alias.name if alias.asname else name)

    def _importfrom(self, node: ast.ImportFrom) -> None:
        for alias in node.names:
            self.evaluator.variables[alias.asname or alias.name] = Name(f"{node.module or ''}.{alias.name}")

    def _functiondef(self, node: ast.FunctionDef) -> None:
        self.evaluator.variables[node.name] = UNKNOWN if node.decorator_list else Function(node.args, node.body, self.evaluator.variables)

    def _classdef(self, node: ast.ClassDef) -> None:
        self.evaluator.variables[node.name] = UNKNOWN

    def _return(self, node: ast.Return) -> None:
        raise _Leave("return", self.evaluator.value(node.value))

    def _break(self, node: ast.Break) -> None:
        raise _Leave("break")

    def _continue(self, node: ast.Continue) -> None:
        raise _Leave("continue")

    def _raise(self, node: ast.Raise) -> None:
        raise _Leave("raise")

    def _if(self, node: ast.If) -> None:
        truth = self.evaluator.truth(node.test)
        if truth is not None:
            self.run(node.body if truth else node.orelse)
            return
        for body in (node.body, node.orelse):
            self._perhaps(body)

    def _perhaps(self, body: Sequence[ast.stmt]) -> None:
        """Statements that may or may not be reached."""
        try:
            self.run(body)
        except _Leave as leave:
            if leave.kind == "return":  # what follows may be reached or not: nothing is known of the result
                self._forget(body)
                raise _Leave("return", UNKNOWN) from None
        self._forget(body)

    def _forget(self, body: Sequence[ast.stmt]) -> None:
        for statement in body:
            for node in ast.walk(statement):
                if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                    before = self.evaluator.variables.get(node.id)
                    self.evaluator.variables[node.id] = [*before, UNKNOWN] if isinstance(before, list) else UNKNOWN

    def _for(self, node: ast.For) -> None:
        listed = items(self.evaluator.value(node.iter))
        if listed is None or len(listed) > _LONGEST_LOOP:
            self.evaluator.assign(node.target, UNKNOWN)
            self._perhaps(node.body)
            return
        for item in listed:
            self.evaluator.value(None)
            self.evaluator.assign(node.target, item)
            try:
                self.run(node.body)
            except _Leave as leave:
                if leave.kind == "break":
                    return
                if leave.kind != "continue":
                    raise
        self.run(node.orelse)

    def _while(self, node: ast.While) -> None:
        self._perhaps(node.body)

    def _with(self, node: ast.With) -> None:
        for each in node.items:
            if each.optional_vars is not None:
                self.evaluator.assign(each.optional_vars, UNKNOWN)
        self.run(node.body)

    def _try(self, node: ast.Try) -> None:
        self.run(node.body)
        for handler in node.handlers:
            imported = all(isinstance(each, (ast.Import, ast.ImportFrom)) for each in node.body)
            if not imported:
                self._perhaps(handler.body)
        self.run(node.orelse)
        self.run(node.finalbody)

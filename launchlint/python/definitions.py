"""Functions, classes and modules: how they come to be, from the source, or from code and names that a program works out."""

from __future__ import annotations

import ast

from launchlint.python.call import Call
from launchlint.python.calls import DATA, Calls
from launchlint.python.memory import ENDED, GOES_ON, Ended
from launchlint.python.recogniser import Recogniser
from launchlint.python.source import Source, SourceError, parse_text
from launchlint.python.values import (
    UNKNOWN,
    Class,
    External,
    Function,
    Module,
    Outside,
    Partial,
    Scope,
    Seq,
    Text,
    Unknown,
    Value,
    alternatives,
)

SETTER = "\0set "
"""Before the name of a property, in a class: the function that is called when it is set."""
LONGEST_CODE = 10_000
_KEEPING = (
    "functools.lru_cache",
    "functools.cache",
    "functools.total_ordering",
    "contextlib.",
    "abc.",
    "builtins.",
    "typing.",
    "dataclasses.",
    "enum.",
)
"""Decorators that leave what they decorate as it is, seen from outside."""


def _is_data(decorator: Value) -> bool:
    """``dataclass``, or what it gives where it is called with options."""
    made = decorator.function if isinstance(decorator, Partial) else decorator
    return isinstance(made, External) and made.name == "dataclasses.dataclass"


class Definitions(Calls):
    """Making functions, classes and modules."""

    def __init__(self, recogniser: Recogniser) -> None:
        super().__init__(recogniser)
        self._sources: list[Source] = []  # what is known of nodes hangs on their ids, so that they must live on

    def import_module(self, name: str, level: int, node: ast.stmt, scope: Scope) -> Value:
        """A module by its name as an import statement says it."""
        raise NotImplementedError

    def _function_definition(self, node: ast.FunctionDef | ast.AsyncFunctionDef, scope: Scope) -> int:
        kind = ""
        value: Value = None
        for decorator in node.decorator_list:
            name = decorator.id if isinstance(decorator, ast.Name) else getattr(decorator, "attr", "")
            if name in ("staticmethod", "classmethod", "property", "cached_property"):
                kind = {"staticmethod": "static", "classmethod": "class"}.get(name, "property")
            elif name in ("setter", "deleter"):
                if name == "setter":
                    owner = scope.variables.get("__owner__")
                    function = self.function(node, scope, owner if isinstance(owner, Class) else None)
                    self.store(scope.variables, f"{SETTER}{node.name}", function)
                return GOES_ON
            elif isinstance(decorator, ast.Call):
                value = decorator
        owner = scope.variables.get("__owner__")
        made: Value = self.function(node, scope, owner if isinstance(owner, Class) else None, kind)
        self.store(scope.shared.get(node.name, scope).variables, node.name, made)
        if value is not None or (node.decorator_list and not kind):
            self.store(scope.shared.get(node.name, scope).variables, node.name, self._decorated(node, made, scope))
        return GOES_ON

    def _decorated(self, node: ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef, value: Value, scope: Scope) -> Value:
        """What the decorators make of a function or class: itself, where they give back what is not known."""
        for decorator in reversed(node.decorator_list):
            named = decorator.func if self.exact and isinstance(decorator, ast.Call) else decorator
            made = self.evaluate(named, scope)
            if _is_data(made):
                if isinstance(value, Class):
                    self.store(value.attributes, DATA, True)
                continue
            if named is not decorator:
                made = self.evaluate(decorator, scope)
            if isinstance(made, External) and made.name.startswith(_KEEPING):
                continue
            result = self.call(made, [value], {}, decorator, scope)
            if isinstance(result, Function) and isinstance(value, Function):
                value = result._replace(owner=result.owner or value.owner, kind=value.kind)
            elif isinstance(result, Class) and isinstance(value, Class):
                value = result
        return value

    def _class_definition(self, node: ast.ClassDef, scope: Scope) -> int:
        bases = [self._base(each, scope) for each in node.bases]
        bases = [each for base in bases for _, each in alternatives(base)]
        inner = Scope(scope.module, scope)
        type_ = Class(node.name, bases, inner)
        inner.variables["__qualname__"] = node.name
        inner.variables["__owner__"] = type_
        if self.execute(node.body, inner) == ENDED and self.exact:
            raise self.raised or Ended
        for keyword in node.keywords:
            if keyword.arg == "metaclass":
                self.call(self.evaluate(keyword.value, scope), [node.name, Seq(bases), UNKNOWN], {}, node, scope)
        self.store(scope.shared.get(node.name, scope).variables, node.name, self._decorated(node, type_, scope))
        return GOES_ON

    def _base(self, node: ast.expr, scope: Scope) -> Value:
        """A base class. What a library that makes no names gives for one makes none either."""
        value = self.evaluate(node, scope)
        if isinstance(value, External) and "[" in value.name:
            return External(value.name.partition("[")[0])
        if isinstance(value, Unknown) and isinstance(node, ast.Name) and scope.module.stars:
            return External("builtins.object")  # of a library that makes no names: of another one it would not be unknown
        if isinstance(value, Unknown) and isinstance(node, (ast.Call, ast.Subscript)):
            maker = self.evaluate(node.func if isinstance(node, ast.Call) else node.value, scope)
            if isinstance(maker, External) and self.recogniser.is_silent(maker.name):
                return External("builtins.object")
            return maker if isinstance(node, ast.Subscript) else value  # Base[T]
        return value

    def made_code(self, word: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """``eval``, ``exec``, ``execfile`` and ``__import__``."""
        made = Call(self, word, positional, keywords, node, scope)
        code = made.get(0, "name", UNKNOWN)
        if word == "__import__":
            loaded = self.module(code, made)
            first = code.partition(".")[0] if isinstance(code, str) and made.get(3, "fromlist", None) is None else code
            return loaded if first == code else self.module(first, made)
        if word == "eval" and (isinstance(code, Outside) or (isinstance(code, Text) and code.template.startswith(("{arg:", "{option:")))):
            return UNKNOWN  # a value that somebody writes into a launch file
        if word == "execfile" or not isinstance(code, str) or len(code) > LONGEST_CODE:
            made.doubt(f"it runs code that it works out ({word})")
            return UNKNOWN
        try:
            source = parse_text(code.strip())
        except SourceError:
            return UNKNOWN
        self._sources.append(source)
        body = source.tree.body
        for each in ast.walk(source.tree):
            if hasattr(each, "lineno"):
                each.lineno = made.line
        if word == "eval" and len(body) == 1 and isinstance(body[0], ast.Expr):
            return self.evaluate(body[0].value, scope)
        self.execute(body, scope)
        return None

    def module(self, name: Value, made: Call) -> Value:
        """A module by a name that the program has worked out. What it has in its messages makes no names."""
        if isinstance(name, str):
            return self.import_module(name, 0, ast.Pass(lineno=made.line, col_offset=0), made.scope)
        if not (isinstance(name, Text) and self.recogniser.is_harmless(name.template)):
            made.doubt("it imports a module by a name that is not known")
        return UNKNOWN

    def _import(self, node: ast.Import, scope: Scope) -> int:
        for alias in node.names:
            module = self.import_module(alias.name, 0, node, scope)
            if alias.asname is not None:
                self.store(scope.variables, alias.asname, module)
            else:
                first = alias.name.split(".")[0]
                self.store(scope.variables, first, self.import_module(first, 0, node, scope) if "." in alias.name else module)
        return GOES_ON

    def _import_from(self, node: ast.ImportFrom, scope: Scope) -> int:
        module = self.import_module(node.module or "", node.level, node, scope)
        for alias in node.names:
            if alias.name == "*":
                self._import_star(module, scope)
            else:
                found = self.attribute(module, alias.name, node, scope)
                self.store(scope.variables, alias.asname or alias.name, found)
        return GOES_ON

    def _import_star(self, module: Value, scope: Scope) -> None:
        if isinstance(module, Module):
            for name, value in list(module.scope.variables.items()):
                if not name.startswith("_"):
                    self.store(scope.variables, name, value)
            scope.module.stars += module.stars
        elif isinstance(module, External):
            scope.module.stars.append(module.name)

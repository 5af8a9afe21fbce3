"""The interpreter with the modules that its program imports: those whose source is at hand are followed, others are the recogniser's."""

from __future__ import annotations

import ast
import os

from launchlint.python.memory import ENDED, Ended, Exhausted
from launchlint.python.modules import ModuleFinder
from launchlint.python.recogniser import Recogniser
from launchlint.python.source import Source, SourceError
from launchlint.python.statements import Statements
from launchlint.python.values import UNKNOWN, External, Module, Scope, Value

MOST_MODULES = 200


class Interpreter(Statements):
    """Follows one program and the modules that it imports.

    Args:
        recogniser: what lies outside.
        root: the directory that paths in places are relative to.
        package: directory of the package that the program is of; empty where it is of none.
        finder: where its modules are looked for.
        beside: the directory of the program.
    """

    def __init__(self, recogniser: Recogniser, root: str, package: str, finder: ModuleFinder, beside: str) -> None:
        super().__init__(recogniser)
        self.root = root
        self.package = package
        self.finder = finder
        self.beside = beside
        self.modules: dict[str, Module] = {}

    def main(self, path: str, source: Source, name: str = "__main__") -> Module:
        """The module of the program itself, before its first statement; ``name`` is that which it is imported by."""
        main = Module(name, self.shown(path), source)
        main.scope.variables.update({"__name__": name, "__file__": UNKNOWN, "__doc__": UNKNOWN})
        self.modules[os.path.realpath(path)] = main
        return main

    def leave(self) -> None:
        """Let go of the recogniser when all is followed: each of the two holds the other, and only a search would find them then."""
        del self.recogniser

    def import_module(self, name: str, level: int, node: ast.stmt, scope: Scope) -> Value:
        """A module by its name as an import statement says it."""
        if level == 0 and self.recogniser.stays_outside(name):
            return External(name)
        if level == 0 and name == "__builtin__":
            return External("builtins")  # as Python 2 calls it
        if level:
            base = scope.module.name.split(".")
            base = base[: len(base) - level + (1 if scope.module.path.endswith("__init__.py") else 0)]
            if not base or base == ["__main__"]:
                return self._load(name, node, scope) if name else UNKNOWN
            name = ".".join([*base, *([name] if name else [])])
        found = self._load(name, node, scope)
        if isinstance(found, External) and level == 0 and "." in scope.module.name:
            inner = self._load(f"{scope.module.name.rpartition('.')[0]}.{name}", node, scope)  # as Python 2 has it: beside the module first
            if isinstance(inner, Module):
                return inner
        return found

    def submodule(self, module: Module, name: str) -> Value:
        """A module of a package, by its name in it."""
        if self.recogniser.is_generated(f"{module.name}.{name}"):
            return External(f"{module.name}.{name}")
        found = self._load(f"{module.name}.{name}", ast.Pass(lineno=1, col_offset=0), module.scope)
        return found if isinstance(found, Module) else self.from_stars(name, module)

    def from_stars(self, name: str, module: Module) -> Value:
        """A name that some ``from x import *`` may have brought."""
        return self.recogniser.from_stars(name, module.stars)

    def shown(self, path: str) -> str:
        """A path as places say it."""
        return os.path.relpath(path, self.root).replace(os.sep, "/")

    def _load(self, name: str, node: ast.stmt, scope: Scope) -> Value:
        parts = name.split(".")
        module: Value = External(name)
        for end in range(1, len(parts) + 1):
            full = ".".join(parts[:end])
            path = self.finder.find(full, self.beside, self.package)
            if path is None:
                return External(name)
            module = self._module(full, path, node, scope)
            if not isinstance(module, Module):
                return External(name)
        return module

    def _module(self, name: str, path: str, node: ast.stmt, scope: Scope) -> Value:
        key = self.finder.real(path)
        if key in self.modules:
            return self.modules[key]
        if path.endswith(os.sep):
            self.modules[key] = Module(name, self.shown(path), None)
            return self.modules[key]
        if len(self.modules) >= MOST_MODULES:
            raise Exhausted
        try:
            source = self.finder.parse(path)
        except SourceError as error:
            self.doubt(f"the module {name} {error}", scope.module.path, getattr(node, "lineno", 1))
            return External(name)
        module = Module(name, self.shown(path), source)
        module.scope.variables.update({"__name__": name, "__file__": UNKNOWN, "__doc__": UNKNOWN})
        self.modules[key] = module
        mark = self.opened
        flow = self.execute(source.tree.body, module.scope)
        if self.opened > mark:
            flow = self._leave(mark, flow, module.scope)
        if self.exact and flow == ENDED:
            raise self.raised or Ended
        return module

"""Where a function's variables live while it is followed."""

from __future__ import annotations

from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import Cell, Thing, Value


class Frame:
    """One call of a function.

    ``scope`` is the class or namespace that names are looked up from, ``bindings`` are template arguments, ``outer`` is the frame
    that a lambda was made in, ``path`` the file.
    """

    __slots__ = ("aliases", "bindings", "outer", "path", "returns", "scope", "this", "variables")

    def __init__(self, path: str, scope: str, this: Thing | None, bindings: dict[str, Type], outer: Frame | None = None) -> None:
        self.path = path
        self.scope = scope
        self.this = this
        self.bindings = bindings
        self.outer = outer
        self.variables: dict[str, Cell] = {}
        self.aliases: dict[str, Type] = {}
        self.returns: list[tuple[str, Value]] = []

    def variable(self, name: str) -> Cell | None:
        """The local variable ``name``, also of the frames around a lambda."""
        frame: Frame | None = self
        while frame is not None:
            if name in frame.variables:
                return frame.variables[name]
            frame = frame.outer
        return None

    def alias(self, name: str) -> Type | None:
        """The type that is called ``name`` in this function or by its template arguments."""
        frame: Frame | None = self
        while frame is not None:
            if name in frame.aliases:
                return frame.aliases[name]
            if name in frame.bindings:
                return frame.bindings[name]
            frame = frame.outer
        return None

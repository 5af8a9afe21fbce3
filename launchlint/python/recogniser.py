"""What an interpreter asks whoever knows the modules that are not followed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

TYPE_CHECKING = False
if TYPE_CHECKING:
    import ast

    from launchlint.python.values import Handle, Instance, Scope, Value


class Recogniser(Protocol):
    """What lies outside of a program: modules whose source is not followed, and objects that come from them.

    Full names are ``module.name``; ``node`` and ``scope`` are the place of a call or an import. What is not known is
    :data:`~launchlint.python.values.UNKNOWN`. Functions that are called later are given to the run's ``arrange`` or ``escape``.
    """

    def call(self, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """Something outside is called: a function or class, by its full name."""
        ...

    def attribute(self, name: str, member: str) -> Value:
        """``name.member`` of a module or class outside."""
        ...

    def member(self, receiver: Handle, name: str) -> Value:
        """An attribute of an object of a recogniser that nobody has set; MISSING where it is a method."""
        ...

    def method(
        self, receiver: Handle, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """A method of an object of a recogniser is called."""
        ...

    def inherited(
        self, base: str, instance: Instance, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> None:
        """The constructor of a class outside is called for an object of a followed class that inherits from it."""
        ...

    def inherited_method(
        self, name: str, instance: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """A method is called that a followed class has from one outside."""
        ...

    def text_method(self, spelled: str, name: str, positional: Sequence[Value]) -> Value:
        """A method of a string with open parts, where the recogniser knows more of them; MISSING where it does not."""
        ...

    def stays_outside(self, name: str) -> bool:
        """Whether a module is known so well that its source is not followed even where it is at hand."""
        ...

    def is_generated(self, name: str) -> bool:
        """Whether a module of this name is made by a build, from what is no Python: ``package.msg``."""
        ...

    def is_harmless(self, spelled: str) -> bool:
        """Whether nothing that matters comes of a module although parts of its name, spelled as a template, are open."""
        ...

    def from_stars(self, name: str, stars: list[str]) -> Value:
        """A name that ``from x import *`` of one of the modules ``stars`` may have brought."""
        ...

    def is_silent(self, name: str) -> bool:
        """Whether nothing that matters comes of a module outside, or of what is in it, but what is recognised."""
        ...

    def is_open(self, name: str) -> bool:
        """Whether it is not known what comes of something outside."""
        ...

    def matters(self, name: str) -> bool:
        """Whether something that matters comes of calling something outside, or of a module."""
        ...

    def mattering(self, name: str) -> list[str]:
        """What in a module or class outside matters, by the names it has there."""
        ...

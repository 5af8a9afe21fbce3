"""One call at a place in the source, with its arguments by place or name."""

from __future__ import annotations

from launchlint.python.values import MISSING, MORE, Scope, Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    import ast

    from launchlint.python.calls import Calls


class Call:
    """A call at a place in the source."""

    __slots__ = ("keywords", "line", "name", "node", "path", "positional", "run", "scope")

    def __init__(self, run: Calls, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> None:
        self.run = run
        self.name = name
        self.positional = positional
        self.keywords = {key: value for key, value in keywords.items() if key != MORE} if MORE in keywords else keywords
        self.node = node
        self.scope = scope
        self.path = scope.module.path
        self.line: int = getattr(node, "lineno", 1)

    def get(self, position: int, name: str, default: Value = MISSING) -> Value:
        """An argument."""
        if position < len(self.positional):
            return self.positional[position]
        return self.keywords.get(name, default)

    def doubt(self, reason: str) -> None:
        """Note why not everything is known."""
        self.run.doubt(reason, self.path, self.line)

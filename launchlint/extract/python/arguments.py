"""One call of a recognised function: noting what it makes."""

from __future__ import annotations

from typing import Any

from launchlint.python import call
from launchlint.python.values import MISSING, UNKNOWN, Map, Scope, Seq, Value, alternatives, conjunction

TYPE_CHECKING = False
if TYPE_CHECKING:
    import ast

    from launchlint.extract.python.following import Following

LONGEST_DEFAULT = 2_000


class Call(call.Call):
    """A call at a place in the source of a program of ROS."""

    __slots__ = ()
    run: Following

    def __init__(self, run: Following, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> None:
        super().__init__(run, name, positional, keywords, node, scope)

    def fact(self, category: str, name: Value, **more: Any) -> None:
        """Note a name, once for each thing that it, or its type, can be."""
        types = more.pop("type", "")
        for condition, each in alternatives(UNKNOWN if name is MISSING else name):
            for other, type_ in alternatives(types):
                spelled = self.run.dialect.spelled(each, category)
                fact = {"category": category, "name": spelled, "path": self.path, "line": self.line, **more}
                if category != "params":
                    fact["type"] = type_ if isinstance(type_, str) else self.run.dialect.type_of(type_)
                self.run.note(fact, conjunction((condition, other)))

    def doubt(self, reason: str, categories: tuple[str, ...] | None = None) -> None:
        """Note why there may be more."""
        if categories is None:
            self.run.doubt(reason, self.path, self.line)
        else:
            self.run.doubt(reason, self.path, self.line, categories)


def queue(value: Value) -> int | None:
    """A queue size."""
    return value if isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 1 << 31 else None


def number_or_none(value: Value) -> int | None:
    """A number that is known."""
    return value if isinstance(value, int) and not isinstance(value, bool) else None


def plain(value: Value, depth: int = 0) -> Any:
    """A value as JSON; MISSING where it is not known as a whole."""
    if isinstance(value, str):
        return value if len(value) <= LONGEST_DEFAULT and value.isprintable() else MISSING
    if isinstance(value, (bool, type(None))):
        return value
    if isinstance(value, (int, float)):
        return value if abs(value) < 1 << 63 else MISSING  # not infinite, and no number: false for both
    if isinstance(value, Seq) and value.complete and depth < 5 and len(value.items) <= 50:
        items = [plain(each, depth + 1) for each in value.items]
        return MISSING if any(each is MISSING for each in items) else items
    if isinstance(value, Map) and value.complete and depth < 5 and len(value.entries) <= 50:
        entries = {key: plain(each, depth + 1) for key, each in value.entries.items()}
        bad = any(each is MISSING for each in entries.values()) or not all(isinstance(key, str) for key in entries)
        return MISSING if bad else entries
    return MISSING

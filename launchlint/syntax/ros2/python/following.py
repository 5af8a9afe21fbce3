"""The interpreter for launch files: it goes on with what it does not know, and lists and dicts that it loses sight of stay open."""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence

from launchlint.python.memory import ENDED, Branch, Ended
from launchlint.python.modules import ModuleFinder
from launchlint.python.values import (
    COMPLETE,
    ENTRIES,
    ITEMS,
    MISSING,
    UNKNOWN,
    Choice,
    Function,
    Handle,
    Instance,
    Map,
    Scope,
    Seq,
    Unknown,
    Value,
    alternatives,
    same,
)
from launchlint.source import Place, Span
from launchlint.source import Source as Written
from launchlint.syntax.ros2.python.noticing import Noticing
from launchlint.syntax.ros2.python.recogniser import LaunchRecogniser, Outside
from launchlint.workspace import looking

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_DEEP = 8


class Following(Noticing):
    """Follows one launch file, and the modules of the workspace that it imports."""

    def __init__(self, written: Written, outside: Outside, root: str, package: str, finder: ModuleFinder) -> None:
        recogniser = LaunchRecogniser(self, outside, self.place)
        super().__init__(recogniser, root, package, finder, package or "\0")
        self.known = recogniser
        self._written: dict[str, Written] = {self.shown(written.file): written}
        self._open_rounds = 0

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
        """What is not known is a value of its own here."""

    def lost(self, values: list[Value]) -> None:
        """What one of too many values is, is not known; nothing else follows from it."""

    # -- what is not known ---------------------------------------------------------------------------------------------

    def evaluate(self, node: ast.expr | None, scope: Scope) -> Value:
        """The value of an expression; one that is not known says where that began."""
        value = super().evaluate(node, scope)
        if value is UNKNOWN and node is not None:
            return Unknown(_why(node), self.place(node, scope))
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
        if isinstance(value, Handle):
            found = self.known.running.item(value, index)
            if found is MISSING:
                raise Ended(f"KeyError: {index}")
            return found
        if isinstance(value, Map) and value.complete and isinstance(index, str) and index not in value.entries:
            raise Ended(f"KeyError: {index}")
        return super().item(value, index)

    def _set_item(self, owner: Value, index: Value, value: Value) -> None:
        if isinstance(owner, Handle):
            self.known.running.set_item(owner, index, value)
        else:
            super()._set_item(owner, index, value)

    def _contained(self, left: Value, right: Value, positive: bool) -> Value:
        if isinstance(right, Handle):
            found = self.known.running.item(right, left)
            return found if isinstance(found, Unknown) else (found is not MISSING) is positive
        return super()._contained(left, right, positive)

    # -- ways that may be taken ----------------------------------------------------------------------------------------

    def merged(self, key: Any, outcomes: list[tuple[str, Any]]) -> Any:
        """What is known behind several ways: of lists what is in all of them, and what may be."""
        if key == COMPLETE:
            return all(value is True for _, value in outcomes) and not self._open_rounds
        if key == ITEMS:
            return _together([(condition or "a way that is not known", value) for condition, value in outcomes if isinstance(value, list)])
        if key == ENTRIES:
            return _entries(outcomes)
        return super().merged(key, outcomes)

    def join(self, ways: list[tuple[str, Branch]], local: dict[Any, Any]) -> None:
        """Go on after one of several ways was taken: what has rounds of which not all are known, may have more in its lists."""
        if self._open_rounds:
            for mapping, key, _ in [each for _, way in ways for each in way.written.values()]:
                if key in (ITEMS, ENTRIES):
                    self.store(mapping, COMPLETE, False)
        super().join(ways, local)

    def _some_rounds(self, node: ast.For | ast.AsyncFor, items: list[Value], scope: Scope) -> int:
        self._open_rounds += 1
        try:
            return super()._some_rounds(node, items, scope)
        finally:
            self._open_rounds -= 1

    def _meet(self, ways: list[tuple[str, Branch]], scope: Scope) -> int:
        """Where one of two ways ends with an error, the other one is taken for the one that people take."""
        going = [way for _, way in ways if way.flow != ENDED]
        if len(going) == 1 and len(ways) > 1:
            for mapping, key, value in going[0].written.values():
                self.store(mapping, key, value)
            return going[0].flow
        return super()._meet(ways, scope)

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


def _together(lists: list[tuple[str, list[Value]]]) -> list[Value]:
    """What all lists begin and end with is there; what stands between in one of them may be."""
    if not lists:
        return []
    first = lists[0][1]
    shortest = min(len(each) for _, each in lists)
    start = 0
    while start < shortest and all(same(each[start], first[start]) for _, each in lists):
        start += 1
    end = 0
    while end < shortest - start and all(same(each[-1 - end], first[-1 - end]) for _, each in lists):
        end += 1
    between = [_perhaps(condition, item) for condition, each in lists for item in each[start : len(each) - end]]
    return [*first[:start], *between, *(first[len(first) - end :] if end else [])]


def _perhaps(condition: str, item: Value) -> Value:
    if isinstance(item, Choice) and len(item.alternatives) == 1:
        return item
    return Choice(tuple((condition, each) for _, each in alternatives(item)))


def _entries(outcomes: list[tuple[str, Any]]) -> dict[Any, Value]:
    mappings = [(condition, value) for condition, value in outcomes if isinstance(value, dict)]
    found: dict[Any, Value] = {}
    for key in dict.fromkeys(key for _, value in mappings for key in value):
        held = [(condition or "a way that is not known", value[key]) for condition, value in mappings if key in value]
        if all(same(each, held[0][1]) for _, each in held) and len(held) == len(mappings):
            found[key] = held[0][1]
        else:
            found[key] = Choice(tuple((condition, each) for condition, one in held for _, each in alternatives(one)))
    return found


def _offset(source: Written, line: int, column: int) -> int:
    """The offset of a column that is counted in bytes of UTF-8."""
    starts = source.line_starts
    if not 1 <= line <= len(starts):
        return len(source.text)
    start = starts[line - 1]
    return start + len(source.line(line).encode("utf-8", "replace")[:column].decode("utf-8", "ignore"))

"""What no evaluation of a launch file shows: elements under conditions that are never met, nodes whose name is never known.

What they would do cannot be compared, so they must be written the same, among the same things that act on them.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.session import Read
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.tree import Document, Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from typing_extensions import Self

_ABOUT = {
    "remap": "from", "env": "name", "machine": "name", "param": "name", "rosparam": "param", "node": "name", "test": "test-name",
    "group": "ns", "include": "file",
}  # fmt: skip
"""Tags whose effect may depend on what stands before or after them, each with the attribute that says what they are about."""

_ONLY_BEFORE = frozenset({"remap", "env", "machine", "group", "include"})
"""Tags of these that matter to what follows them only."""

_IN_SCOPE = frozenset({"remap", "env"})
"""Tags of these that matter to nothing outside of their parent."""


class Shown(NamedTuple):
    """What one evaluation shows of its entry file: the elements that are ``taken``, and where nodes start that have a name or none."""

    taken: frozenset[int]
    named: frozenset[int]
    nameless: frozenset[int]

    @classmethod
    def of(cls, evaluation: Evaluation) -> Self:
        """Of ``evaluation``."""
        path = evaluation.launch.entry.path
        named: set[int] = set()
        nameless: set[int] = set()
        for node in (*evaluation.launch.nodes, *evaluation.launch.tests):
            place = node.origin.place
            if place.source.path == path:
                (named if node.knows("name", "namespace") else nameless).add(place.span.start)
        return cls(frozenset(evaluation.visited.get(path, ())), frozenset(named), frozenset(nameless))


class Hidden:
    """Collects what the evaluations of one text show, and compares the rest with that of another text."""

    def __init__(self, document: Document | Read) -> None:
        self._document = None if isinstance(document, Read) else document
        self._taken: set[int] = set()
        self._named: set[int] = set()
        self._nameless: set[int] = set()

    def see(self, shown: Shown) -> None:
        """Take note of what one evaluation shows."""
        self._taken.update(shown.taken)
        self._named.update(shown.named)
        self._nameless.update(shown.nameless)

    def difference(self, other: Hidden) -> str:
        """Why what was never seen is not the same in ``other``, in one sentence; empty where it is, or there is nothing of it."""
        if self._sequence() == other._sequence():
            return ""
        element = next(self._elements(), None) or next(other._elements())
        return f"no configuration shows what this does to the <{element.tag}> under a condition that is never met, or of unknown name"

    def _elements(self) -> Iterator[Element]:
        """The outermost hidden elements, in order."""
        inside = 0
        nameless = self._nameless - self._named
        if self._document is None:
            return
        for element in self._document.elements:
            start, end = element.span
            # The condition of <launch> itself is no condition: roslaunch takes no notice of it.
            conditional = ("if" in element.attributes or "unless" in element.attributes) and element is not self._document.launch
            if start >= inside and ((conditional and element.index not in self._taken) or start in nameless):
                inside = end
                yield element

    def _sequence(self) -> list[Any]:
        """The hidden elements as they are written, between whatever acts on them or is overwritten by them.

        The order of args does not matter, only which of them stand before a hidden element, and how often; so they are counted, from one
        hidden element to the next.
        """
        hidden = list(self._elements())
        if not hidden or self._document is None:
            return []
        outermost = {element.index for element in hidden}
        last = hidden[-1].span.start
        scopes = _around(hidden)
        sequence: list[Any] = []
        declared: Counter[tuple[str | None, int]] = Counter()
        inside = 0
        for element in self._document.elements:
            start, end = element.span
            if start < inside:
                continue
            if element.index in outermost:
                inside = end
                sequence.append((declared, element.depth, _written(element)))
                declared = Counter()
            elif element.tag == "arg":
                declared[element.get("name"), element.depth] += 1
            elif element.tag in _ABOUT and (start < last or element.tag not in _ONLY_BEFORE):
                if element.tag in _IN_SCOPE and element.parent is not None and element.parent.index not in scopes:
                    continue
                sequence.append((element.tag, element.depth, element.get(_ABOUT[element.tag])))
        return sequence


def _around(elements: list[Element]) -> set[int]:
    """The indices of the elements that ``elements`` stand in."""
    found: set[int] = set()
    for element in elements:
        parent = element.parent
        while parent is not None and parent.index not in found:
            found.add(parent.index)
            parent = parent.parent
    return found


def _written(element: Element) -> tuple[Any, ...]:
    """Everything that is written in ``element``, without the order of attributes and without blank text, in one flat sequence."""
    sequence: list[Any] = []
    waiting: list[Element | None] = [element]
    while waiting:
        current = waiting.pop()
        if current is None:
            sequence.append(None)
            continue
        attributes = sorted((attribute.name, attribute.value) for attribute in current.attributes.values())
        sequence.append((current.tag, tuple(attributes), current.text.strip()))
        waiting.append(None)
        waiting.extend(reversed(current.children))
    return tuple(sequence)

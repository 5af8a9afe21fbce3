"""Whether what roslaunch refuses may be due to empty defaults, from the texts alone: where it cannot be, nothing is evaluated again."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache

from launchlint.evaluate.assemble import Evaluation
from launchlint.evaluate.problems import EnvUnset, PackageNotFound, RequiredArgUnset
from launchlint.evaluate.session import Session
from launchlint.problem import Problem
from launchlint.source import Place
from launchlint.syntax.ros1.substitutions import expression_in
from launchlint.syntax.tree import Attribute, Document, Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Words: TypeAlias = Mapping[str, frozenset[str]]

LOCAL_KINDS = (PackageNotFound, RequiredArgUnset, EnvUnset)
"""Problems that go away only where the text they stand in is not looked at any more, or is another; all others may depend on more."""
ANY = "arg()"
"""Stands for a name that an expression makes."""
MADE = re.compile(r"""\barg\s*\((?!\s*(?:'[^'"\\\s()]+'|"[^'"\\\s()]+")\s*\))""")
"""``arg(…)`` of an expression, with anything else in it than one plain text."""
FOLLOWING = ("if", "unless", "file")
SCOPES = frozenset({"launch", "group", "include"})
"""Elements that go on with what is inside them unless their condition does not hold, and the attributes that decide on it."""
DEEPEST = 40
"""Elements inside elements; in a file with more of them the words around each would be too many."""


def may_be_caused(session: Session, evaluation: Evaluation, empty: Iterable[str]) -> bool:
    """Whether one of the problems for which roslaunch refuses ``evaluation`` may vanish when the args named ``empty`` are unknown.

    Args are told apart by name only, over all files, so that the answer *yes* may be wrong, and *no* is not.
    """
    refusing = [problem for problem in evaluation.launch.problems if problem.refused]
    if not all(isinstance(problem, LOCAL_KINDS) for problem in refusing):
        return True
    tables = [_table(session, document) for document in evaluation.documents.values()]
    if any(ANY in table for table in tables):
        return True
    reached = _reached(tables, empty)
    for place, followed in dict.fromkeys(place for problem in refusing for place in _places(problem)):
        document = evaluation.documents.get(place.source.path)
        words = None if document is None else _deciding_at(session, document, place, followed=followed)
        if words is None or not reached.isdisjoint(words):
            return True
    return False


def _deciding_at(session: Session, document: Document, place: Place, *, followed: bool) -> frozenset[str] | None:
    """As :func:`_deciding`, for what is at ``place``; ``None`` where that is not plain. The same in all configurations, and kept."""
    key = document, place.span, followed
    if key not in session.deciding:
        element = _around(document, place)
        session.deciding[key] = None if element is None else frozenset(_deciding(element, None if followed else place))
    return session.deciding[key]


def _places(problem: Problem) -> Iterator[tuple[Place, bool]]:
    """Where the problem stands and what shows it; the includes that lead to it, which are followed."""
    yield problem.place, False
    yield from ((place, False) for place, _ in problem.related)
    yield from ((place, True) for place in problem.origin.chain)


def _around(document: Document, place: Place) -> Element | None:
    """The element in whose start tag ``place`` is, where that is plain."""
    after = document.element_from(place.span.start + 1)
    index = (len(document.elements) if after is None else after.index) - 1
    if index < 0 or document.elements[index].start_span.end <= place.span.start:
        return None  # it is in a text
    element = document.elements[index]
    several = index and document.elements[index - 1].start_span.start == element.start_span.start  # out of an entity
    return None if several else element


def _reached(tables: list[Words], empty: Iterable[str]) -> set[str]:
    """The args whose value may be made of those named ``empty``, these included."""
    reached = {*empty, ANY}
    waiting = list(reached)
    while waiting:
        word = waiting.pop()
        for table in tables:
            new = table.get(word, frozenset()) - reached
            reached |= new
            waiting.extend(new)
    return reached


def _table(session: Session, document: Document) -> Words:
    """For each word, the args that are declared or passed in an element of ``document`` in which it stands, or inside of such a one.

    What an include passes hangs on the words of the ``<arg>`` alone: whether the file is entered is asked of the includes that lead to a
    problem. It holds :data:`ANY` where names of args are made, or the file is too deep to be looked at.
    """
    known = session.words.get(document)
    if known is None:
        table: dict[str, set[str]] = {}
        deep = document.max_depth > DEEPEST
        if deep:
            table[ANY] = set()
        for element in () if deep else document.elements:
            name = element.get("name") if element.tag.lower() == "arg" else None
            if name:
                passed = element.parent is not None and element.parent.tag == "include"
                words = _words(element, element.attributes) if passed else _all_words(element)
                for word in words:
                    table.setdefault(word, set()).add(name)
                if "$" in name or ANY in words:
                    table[ANY] = set()
        known = session.words[document] = {word: frozenset(names) for word, names in table.items()}
    return known


def _deciding(element: Element, looked_at: Place | None) -> set[str]:
    """The words that decide whether the text at ``looked_at`` in ``element``, or the file that it includes, is looked at at all.

    All of a text is looked at for what is wrong with it, whatever the values; an expression is not, nor is a file that is read.
    """
    words: set[str] = set()
    if looked_at is None:
        words |= _words(element, FOLLOWING)
    else:
        own = {name for name, each in element.attributes.items() if _holds(each, looked_at) and expression_in(each.value) is None}
        words |= _words(element, element.attributes.keys() - (set() if "subst_value" in element.attributes else own))
    outer = element.parent
    while outer is not None:
        words |= _words(outer, FOLLOWING if outer.tag in SCOPES else outer.attributes)
        outer = outer.parent
    return words


def _holds(attribute: Attribute, place: Place) -> bool:
    return attribute.value_span.start <= place.span.start < attribute.value_span.end


def _all_words(element: Element) -> set[str]:
    """What may be names of args in the attributes of an element and of those around it."""
    words: set[str] = set()
    inner: Element | None = element
    while inner is not None:
        words |= _words(inner, inner.attributes)
        inner = inner.parent
    return words


def _words(element: Element, names: Iterable[str]) -> set[str]:
    """What may be names of args in the attributes of these ``names``."""
    words: set[str] = set()
    for name in names:
        text = element.get(name)
        if text is not None and "$" in text:
            words |= _words_of(text)
    return words


@lru_cache(maxsize=1024)  # the conditions around many elements are the same
def _words_of(text: str) -> frozenset[str]:
    words = {*re.findall(r"\w+", text), *(word.strip("'\"") for word in re.findall(r"[^\s()]+", text))}
    return frozenset(words | {ANY} if MADE.search(text) else words)

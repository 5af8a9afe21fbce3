"""Mistakes that people make in launch files of ROS 2, each as a function from a file to the file with that mistake.

A mistake takes one element that is always active, so that it counts, and says which lines it is about. Kinds are grouped as a reader would
look for them: structure, names, substitutions, scoping, params, conditions, timers, containers, processes.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from difflib import SequenceMatcher
from random import Random
from typing import NamedTuple

from tests.conformance.ros2.elements import Attribute, Document, Element


class Mutant(NamedTuple):
    """A file with one mistake: its text, and the lines (the first is 1) at which it would be told."""

    text: str
    lines: tuple[tuple[int, int], ...]


Make = Callable[[Document, Element, Random], "str | tuple[str, str] | None"]


class Kind(NamedTuple):
    """One kind of mistake. ``make`` gives the new text for an element (None: not of this one), with a name whose uses are places, too."""

    group: str
    name: str
    make: Make
    tags: frozenset[str]
    dialect: str = ""


KINDS: list[Kind] = []
STARTED = ("node", "node_container", "composable_node", "executable")
_VARIABLE = re.compile(r"\$\(var ([\w/.-]+)\)")
_SUBSTITUTION = re.compile(r"\$\(([\w-]+)([^()]*)\)")


def kind(group: str, *tags: str, dialect: str = "") -> Callable[[Make], Make]:
    """Registers a mistake in elements of these tags (none: of any tag)."""

    def register(make: Make) -> Make:
        KINDS.append(Kind(group, make.__name__, make, frozenset(tags), dialect))
        return make

    return register


def mutants(document: Document, each: Kind, random: Random) -> Iterator[Mutant]:
    """Mutants of one kind, one for each element that can have the mistake, in random order."""
    if each.dialect and (each.dialect == "yaml") != document.yaml:
        return
    elements = [element for element in document.elements if (not each.tags or element.tag in each.tags) and element.always]
    random.shuffle(elements)
    for element in elements:
        made = each.make(document, element, random)
        if made is None:
            continue
        text, name = made if isinstance(made, tuple) else (made, "")
        if text != document.text:
            yield Mutant(text, tuple(_lines(document, element, text, name)))


def _lines(document: Document, element: Element, text: str, name: str) -> Iterator[tuple[int, int]]:
    changes = SequenceMatcher(None, document.text.splitlines(), text.splitlines(), autojunk=False).get_opcodes()
    yield from ((start + 1, max(end, start + 1)) for how, _, _, start, end in changes if how != "equal")
    first = document.line(element.at[0])
    yield first, max(document.line(element.at[1]) + text.count("\n") - document.text.count("\n"), first)
    if name:
        word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
        yield from ((number, number) for number, line in enumerate(text.splitlines(), 1) if word.search(line))


# -- how texts are changed


def cut(text: str, at: tuple[int, int], instead: str = "") -> str:
    """``text`` with something else at a span."""
    return text[: at[0]] + instead + text[at[1] :]


def with_value(document: Document, attribute: Attribute | None, value: str | None) -> str | None:
    """The file with another value of an attribute."""
    if attribute is None or value is None or value == attribute.value:
        return None
    return cut(document.text, attribute.value_at, document.quoted(value))


def with_attribute(document: Document, element: Element, name: str, value: str) -> str | None:
    """The file with another value of an attribute, or with one more attribute."""
    if name in element.attributes:
        return with_value(document, element.attributes[name], value)
    if not document.yaml:
        return cut(document.text, (element.head_end, element.head_end), f" {name}={document.quoted(value)}")
    return with_raw(document, element, name, document.quoted(value))


def with_raw(document: Document, element: Element, name: str, value: str) -> str | None:
    """The file with one more attribute, its value written as it is given."""
    first = min(element.attributes.values(), key=lambda each: each.name_at, default=None)
    if first is None:
        return None
    line = document.text.rfind("\n", 0, first.name_at[0]) + 1
    before = document.text[line : first.name_at[0]]
    separator = "\n" + re.sub(r"-", " ", before) if re.fullmatch(r"[ -]*", before) else ", "
    return cut(document.text, (first.name_at[0], first.name_at[0]), f"{name}: {value}{separator}")


def without(document: Document, element: Element, name: str) -> str | None:
    """The file without an attribute."""
    attribute = element.attributes.get(name)
    if attribute is None or (document.yaml and len(element.attributes) == 1):
        return None
    text = document.text
    if document.yaml and text[attribute.at[0] : attribute.name_at[0]].strip(" ") == "-":
        return None
    return cut(text, attribute.at)


def of_element(document: Document, element: Element) -> tuple[int, int] | None:
    """Where all of an element stands, with its line in YAML; None where that cannot be cut out."""
    if not document.yaml:
        return element.at
    line = document.text.rfind("\n", 0, element.at[0]) + 1
    if not document.text[line : element.at[0]].isspace() and line != element.at[0]:
        return None
    if element.parent is not None and len(element.parent.children) == 1:
        return None
    return line, min(element.at[1] + 1, len(document.text))


def misspelt(word: str, random: Random) -> str:
    """A word as a person mistypes it: a letter lost, doubled or swapped."""
    letters = [at for at, letter in enumerate(word) if letter.isalpha()]
    if len(letters) < 3:
        return word + word[-1:]
    at = random.choice(letters[1:-1])
    how = random.randrange(3)
    if how == 0:
        return word[:at] + word[at + 1 :]
    if how == 1 and word[at] != word[at + 1]:
        return word[:at] + word[at + 1] + word[at] + word[at + 2 :]
    return word[:at] + word[at] + word[at:]


def _any_value(element: Element, random: Random, holds: Callable[[str, str], bool]) -> Attribute | None:
    fitting = [value for name, value in element.attributes.items() if holds(name, value.value)]
    return random.choice(fitting) if fitting else None


def _has_variable(name: str, value: str) -> bool:
    return name != "description" and _VARIABLE.search(value) is not None


def _in_substitution(change: Callable[[re.Match[str], Random], str]) -> Make:
    def make(document: Document, element: Element, random: Random) -> str | None:
        attribute = _any_value(element, random, lambda name, value: name != "description" and _SUBSTITUTION.search(value) is not None)
        if attribute is None:
            return None
        match = random.choice(list(_SUBSTITUTION.finditer(attribute.value)))
        return with_value(document, attribute, cut(attribute.value, match.span(), change(match, random)))

    return make


def _values(*choices: str) -> Callable[[Document, Element, str, Random], str | None]:
    def make(document: Document, element: Element, name: str, random: Random) -> str | None:
        return with_attribute(document, element, name, random.choice(choices))

    return make


def table(group: str, rows: Iterable[tuple[str, tuple[str, ...], str, tuple[str, ...]]]) -> None:
    """Mistakes that give an attribute one of some values: (name, tags, attribute, values)."""

    def one(name: str, attribute: str, values: tuple[str, ...]) -> Make:
        def make(document: Document, element: Element, random: Random) -> str | None:
            return with_attribute(document, element, attribute, random.choice(values))

        make.__name__ = name
        return make

    for name, tags, attribute, values in rows:
        kind(group, *tags)(one(name, attribute, values))


def substitution(name: str, change: Callable[[re.Match[str], Random], str]) -> None:
    """A mistake inside a ``$(…)``."""
    make = _in_substitution(change)
    make.__name__ = name
    kind("substitutions")(make)

"""Which ROS a launch file in XML is for, by the words that stand in it.

Both are XML with a ``<launch>`` root and share most of their tag names, and the same file endings are in use for both. What differs are
tags, attributes and substitutions that only one of the two metamodels has; the side with more of them wins, and what the package is built
for counts as well, or else the environment. One slip (``exec=`` written in a ROS 1 file) must never turn a file into the other dialect.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache

from launchlint.model import ROS1, ROS2
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.ros1.dialect import TAGS
from launchlint.syntax.ros1.domains import PARAM_TYPES
from launchlint.syntax.ros1.substitutions import COMMANDS
from launchlint.syntax.tree import Document

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.model import DialectName
    from launchlint.syntax.ros2.tables import Read

WEIGHT = 2
"""Of the package, or the environment: as much as two words of a dialect, so that a short file with a slip or two stays what it is."""
MOST_WORDS = 100_000
"""Words after which enough has been seen."""

_EVAL, _QUOTED = "eval", "eval '…'"
"""An expression in quotes is one of ROS 2; what else differs in it is told by nothing but its grammar."""
_QUOTES = ("'", '"', "\\")
_OPENS = "$("


class Word(NamedTuple):
    """A tag (then the others are empty), an attribute of a tag, with its value, or a substitution."""

    tag: str = ""
    attribute: str = ""
    value: str = ""
    substitution: str = ""


OF_ROS1 = ".launch"
"""The end of names that ROS 2 does not use."""
_ALONE = frozenset(("param", "remap"))
"""Elements that stand in those of a node in ROS 2, and in any other of roslaunch as well."""
_TEST = Word("test")
"""rostest has no counterpart of this kind in ROS 2: nobody writes it by a slip."""


class Only(NamedTuple):
    """What one dialect has and the other has not: ``attributes`` by tag, where both have the tag; ``types`` of a ``<param>``."""

    tags: frozenset[str]
    attributes: Mapping[str, frozenset[str]]
    substitutions: frozenset[str]
    types: frozenset[str]

    def has(self, word: Word) -> bool:
        """Whether ``word`` is one of them."""
        if word.substitution:
            return word.substitution in self.substitutions
        if not word.attribute:
            return word.tag in self.tags
        return word.attribute in self.attributes.get(word.tag, ()) or (
            (word.tag, word.attribute) == ("param", "type") and word.value in self.types
        )


def told(document: Document, expected: DialectName | None, *, only_where_equal: bool = False, of_ros2_only: bool = False) -> DialectName:
    """The dialect of a launch file.

    Args:
        document: as far as it could be read.
        expected: the dialect that its package is built for, else that of the environment; None where neither says one.
        only_where_equal: what is expected decides only where the words do not.
        of_ros2_only: nobody but ros2 launch could start it, by its package: a file that is called as those of ROS 1 are (``*.launch``), and
            has words of ROS 1 but not one of ROS 2, was left behind when the package was ported. No slip: ros2 launch refuses it.
    """
    weight = 0 if only_where_equal else WEIGHT
    ros1 = weight if expected == ROS1 else 0
    ros2 = weight if expected == ROS2 else 0
    listed = _words(document)
    # Where roslaunch knows every word, the tables of ROS 2 need not even be loaded, unless the file is expected to be one of it.
    if expected != ROS2 and all(map(_is_known_to_ros1, listed)):
        return ROS1
    only1, only2 = _only()
    before = ros1, ros2
    for word in listed:
        ros1 += WEIGHT + 1 if word == _TEST else only1.has(word)
        ros2 += only2.has(word)
    if of_ros2_only and ros2 == before[1] and document.source.path.endswith(OF_ROS1) and (ros1 > before[0] or _has_alone(document)):
        return ROS1
    return expected or ROS1 if ros1 == ros2 and only_where_equal else ROS1 if ros1 >= ros2 else ROS2


def _has_alone(document: Document) -> bool:
    """Whether something stands in ``<launch>`` that ROS 2 has in nodes only."""
    return any(each.tag in _ALONE and each.parent is document.root for each in document.elements)


def _is_known_to_ros1(word: Word) -> bool:
    if word.substitution:
        return word.substitution == _EVAL or word.substitution in COMMANDS
    rule = TAGS.get(word.tag)
    return rule is not None and (not word.attribute or rule.attribute(word.attribute) is not None)


def _words(document: Document) -> list[Word]:
    """The words of a document; where it is not well-formed, what looks like them in its text."""
    if document.root is None or document.root.span == document.root.start_span:
        return _words_of_text(document.source.text)
    found: list[Word] = []
    for element in document.elements:
        found.append(Word(element.tag))
        for attribute in element.attributes.values():
            found.append(Word(element.tag, attribute.name, attribute.value))
            found += _substitutions(attribute.value)
        found += (each for text in element.texts for each in _substitutions(text.value))
        if len(found) > MOST_WORDS:
            break
    return found


def _substitutions(value: str) -> Iterator[Word]:
    """``$(var x)`` and the like, wherever they begin."""
    if _OPENS not in value:
        return
    for part in value.split(_OPENS)[1:]:
        name, blank, rest = part.partition(" ")
        name = name.partition(")")[0]
        if name == _EVAL and blank:
            name = _QUOTED if rest.lstrip().startswith(_QUOTES) else _EVAL
        yield Word(substitution=name)


def _words_of_text(text: str) -> list[Word]:
    """As far as can be told without reading it as XML: whatever looks like a tag, and like an attribute behind one."""
    found: list[Word] = []
    text = re.sub(r"<!--.*?(?:-->|\Z)", "", text, flags=re.DOTALL)
    for piece in text.split("<")[1:]:
        name = re.match(r"[A-Za-z_][\w.-]*", piece)
        if name is not None:
            found.append(Word(name[0]))
            found += (Word(name[0], each[1]) for each in re.finditer(r"\s([A-Za-z_][\w.-]*)\s*=", piece))
        if len(found) > MOST_WORDS:
            return found
    return [*found, *_substitutions(text)]


@cache
def _only() -> tuple[Only, Only]:
    """What only ROS 1 has, and what only ROS 2 has."""
    from launchlint.syntax.ros2.tables import PARAMETER, PARAMETER_TYPES, SUBSTITUTIONS
    from launchlint.syntax.ros2.tables import TAGS as TAGS2

    attributes1 = {tag: {each.name for each in rule.attributes if each.status != "refused"} for tag, rule in TAGS.items()}
    attributes2: dict[str, set[str]] = {"launch": set(), "param": {*PARAMETER, "if", "unless"}}
    for tag in TAGS2.values():
        _gather(tag.name, tag.reads, attributes2)
    return (
        Only(
            frozenset(attributes1.keys() - attributes2.keys()),
            _difference(attributes1, attributes2),
            frozenset(COMMANDS) - SUBSTITUTIONS.keys() | {_EVAL},
            frozenset(PARAM_TYPES) - frozenset(PARAMETER_TYPES),
        ),
        Only(
            frozenset(attributes2.keys() - attributes1.keys()),
            _difference(attributes2, attributes1),
            frozenset(SUBSTITUTIONS) - frozenset(COMMANDS) - {_EVAL} | {_QUOTED},
            frozenset(PARAMETER_TYPES) - frozenset(PARAM_TYPES),
        ),
    )


def _gather(tag: str, reads: Iterable[Read], found: dict[str, set[str]]) -> None:
    from launchlint.syntax.ros2.tables import Attribute, Children, Conditions

    known = found.setdefault(tag, set())
    for each in reads:
        if isinstance(each, Attribute):
            known.add(each.name)
        elif isinstance(each, Conditions):
            known.update(("if", "unless"))
        elif isinstance(each, Children):
            _gather(each.name, each.reads, found)


def _difference(one: Mapping[str, set[str]], other: Mapping[str, set[str]]) -> dict[str, frozenset[str]]:
    """The attributes that ``one`` has and ``other`` has not, of the tags that both have; conditions are no sign."""
    shared = {tag: one[tag] - other[tag] - {"if", "unless"} for tag in one if tag in other}
    return {tag: frozenset(names) for tag, names in shared.items() if names}

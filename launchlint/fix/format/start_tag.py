"""Start tags: their attributes in canonical order, in one line or one line each."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache

from launchlint.fix.format.style import Style
from launchlint.fix.format.tokens import Token
from launchlint.named_tuple import NamedTuple
from launchlint.syntax.ros1.dialect import TAGS
from launchlint.syntax.ros2.order import ORDER

_ATTRIBUTE = re.compile(r"""(?<![^ \t\n=/>"'])([^ \t\n=/>"']+)[ \t\n]*=[ \t\n]*(?:"([^"]*)"|'([^']*)')""")


class Attribute(NamedTuple):
    """One attribute: ``written`` is the whole of it, with the quotes of the normal form; ``distance`` says how far from the start of the
    tag it stood.
    """

    name: str
    value: str
    written: str
    distance: int


def attributes_of(tag: Token) -> list[Attribute]:
    """The attributes of a start tag in the order they are written.

    Quotes become double where the value has none in it. References in values stay as they are.
    """
    found: list[Attribute] = []
    for match in _ATTRIBUTE.finditer(tag.text, 1 + len(tag.name)):
        name, double, single = match.groups()
        value = single if double is None else double
        quote = "'" if '"' in value else '"'
        found.append(Attribute(name, value, f"{name}={quote}{value}{quote}", match.start()))
    return found


def start_tag(tag: Token, *, closed: bool, style: Style, column: int) -> str:
    """A start tag in normal form, as it stands at ``column`` (from 0): one line, or several joined by line feeds.

    ``closed``: the element is empty, and closed at once. A tag that is too long for a line, or has a value of several lines, gets one line
    for each attribute.
    """
    attributes = attributes_of(tag)
    if style.sort_attributes:
        attributes = in_canonical_order(tag.name, attributes)
    start, end = f"<{tag.name}", "/>" if closed else ">"
    if not attributes:
        return start + end
    line = " ".join([start, *(each.written for each in attributes)]) + end
    if len(attributes) == 1 or ("\n" not in line and column + len(line) <= style.line_width):
        return line
    between = "\n" + " " * (column + len(start) + 1)
    return f"{start} {between.join(each.written for each in attributes)}{end}"


def in_canonical_order(tag: str, attributes: list[Attribute]) -> list[Attribute]:
    """Those that either dialect knows in the order of its table, then all others as they were."""
    ranks = _ranks(tag)
    last = len(ranks)
    return sorted(attributes, key=lambda each: ranks.get(each.name, last))


@lru_cache(maxsize=64)
def _ranks(tag: str) -> Mapping[str, int]:
    """The order of both dialects in one: what only ROS 2 has goes behind what stands before it there."""
    rule = TAGS.get(tag) or TAGS.get(tag.lower())  # inside <node> and <include> roslaunch takes tags in any case
    names = [each.name for each in (() if rule is None else rule.attributes)]
    position = 0
    for name in ORDER.get(tag, ()):
        if name not in names:
            names.insert(position, name)
        position = names.index(name) + 1
    return {name: number for number, name in enumerate(names)}

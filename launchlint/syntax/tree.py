"""The positioned tree: every element, attribute, text and comment of an XML file, with the place it is written at.

All offsets are code points of ``Document.source.text``. Positions are kept as plain integers and handed out as
:class:`~launchlint.source.Span` when asked for, since most of them never are.

What stands in an internal entity has no place of its own: elements and attributes that come out of ``&name;`` have the
span of that reference.
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from copy import copy
from itertools import accumulate

from launchlint.problem import Problem
from launchlint.source import Place, Source, Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from launchlint.syntax.parts import Parts
    from launchlint.syntax.ros2.description import Description

_UNIT = re.compile(r"\r\n|&[^;&<]*;")
_LINE_END = re.compile(r"\r\n")
_PREDEFINED = frozenset(("&lt;", "&gt;", "&amp;", "&quot;", "&apos;"))


def unit_offsets(raw: str, value: str, references: bool = True) -> list[int] | None:
    """Where each character of ``value`` starts in ``raw``, plus the end of ``raw`` as last item.

    ``raw`` is what is written, ``value`` what an XML parser makes of it: a CRLF and a reference (``&lt;``, ``&#10;``, ``&name;``) are one
    unit each. How long the text of an internal entity is, follows from the lengths; ``None`` where it does not (two different entities, or
    a value that a DTD had trimmed). CDATA has no ``references``.
    """
    units = [match.span() for match in (_UNIT if references else _LINE_END).finditer(raw)]
    named = {raw[start:end] for start, end in units if raw[start] == "&" and raw[start + 1] != "#"} - _PREDEFINED
    single = len(raw) - sum(end - start - 1 for start, end in units)
    width = 1
    if len(named) == 1:
        count = sum(1 for start, end in units if raw[start:end] in named)
        width, rest = divmod(len(value) - (single - count), count)
        if rest or width < 0:
            return None
    elif named or single != len(value):
        return None
    offsets: list[int] = []
    position = 0
    for start, end in units:
        offsets.extend(range(position, start))
        offsets.extend([start] * (width if raw[start:end] in named else 1))
        position = end
    offsets.extend(range(position, len(raw) + 1))
    return offsets if len(offsets) == len(value) + 1 else None


class Attribute:
    """One attribute of a start tag: ``name="value"``.

    ``value`` is what expat makes of it (references resolved, line ends and tabs turned into blanks), ``raw`` what is
    written between the quotes. ``parts`` is kept here by the grammar of the dialect (:mod:`launchlint.syntax.parts`), which takes the
    value apart when it is first asked to.
    """

    __slots__ = ("_name_end", "_name_start", "_offsets", "_value_end", "_value_start", "_written", "name", "parts", "raw", "value")

    def __init__(self, name: str, value: str, raw: str, name_start: int, name_end: int, value_start: int, value_end: int) -> None:
        self.name = name
        self.value = value
        self.raw = raw
        self._name_start = name_start
        self._name_end = name_end
        self._value_start = value_start
        self._value_end = value_end
        self._offsets: Sequence[int] | None = None
        self._written: Place | None = None
        self.parts: Parts | None = None

    def __repr__(self) -> str:
        return f"Attribute({self.name!r}, {self.value!r})"

    @property
    def name_span(self) -> Span:
        """The name."""
        return Span(self._name_start, self._name_end)

    @property
    def value_span(self) -> Span:
        """What is written inside the quotes."""
        return Span(self._value_start, self._value_end)

    @property
    def value_or_name_span(self) -> Span:
        """The value inside the quotes; the name where nothing is written between them."""
        return self.value_span if self.raw else self.name_span

    @property
    def shown_span(self) -> Span:
        """The value as a caret should point at it: inside the quotes, or the quotes themselves where there is nothing between them."""
        if self._value_start == self._value_end:
            return Span(self._value_start - 1, self._value_end + 1)
        return Span(self._value_start, self._value_end)

    @property
    def span(self) -> Span:
        """From the first letter of the name to the closing quote (to the end of the reference in an entity)."""
        if self._name_start == self._value_start:
            return Span(self._value_start, self._value_end)
        return Span(self._name_start, self._value_end + 1)

    def span_of(self, start: int, end: int) -> Span:
        """The source span of ``value[start:end]``.

        A reference or CRLF that is touched is covered as a whole. Where the value cannot be matched to what is written (text
        of several entities), the span of the whole value.
        """
        base = self._value_start
        offsets = self._offsets
        if offsets is None:
            # Looked for once: a value of megabytes may hold a hundred thousand substitutions, each with a span.
            plain = len(self.raw) == len(self.value) and "&" not in self.raw and "\r\n" not in self.raw
            # An empty list says "cannot be matched": a list that can has at least the end in it.
            offsets = self._offsets = range(len(self.value) + 1) if plain else unit_offsets(self.raw, self.value) or []
        if isinstance(offsets, range):
            return Span(base + start, base + end)
        if not offsets:
            return self.value_span
        first = offsets[start]
        if end <= start:
            return Span(base + first, base + first)
        last = end
        while last < len(offsets) - 1 and offsets[last] == offsets[end - 1]:
            last += 1  # inside the text of an entity: to the end of its reference
        return Span(base + first, base + offsets[last])

    def written(self, source: Source) -> Place:
        """The place of :attr:`value_span`; made once, since the same is evaluated again and again."""
        if self._written is None:
            self._written = Place(source, self.value_span)
        return self._written

    def place(self, source: Source) -> Place:
        """The place of the value, see :attr:`shown_span`."""
        return Place(source, self.shown_span)


class Text:
    """A stretch of text or one CDATA section directly inside an element.

    ``raw`` is what is written (inside the CDATA brackets), ``value`` what expat makes of it.
    """

    __slots__ = ("_end", "_offsets", "_start", "cdata", "raw", "value")

    def __init__(self, value: str, raw: str, start: int, end: int, cdata: bool) -> None:
        self._offsets: list[int] | None = None
        self.value = value
        self.raw = value if raw == value else raw  # one string instead of two where nothing was changed
        self.cdata = cdata
        self._start = start
        self._end = end

    def __repr__(self) -> str:
        return f"Text({self.value!r})"

    @property
    def span(self) -> Span:
        """Where it is written."""
        return Span(self._start, self._end)

    def offset(self, index: int) -> int:
        """The source offset of ``value[index]`` (of its end for ``index == len(value)``)."""
        offsets = self._offsets
        if offsets is None and self.raw is not self.value:
            # Looked for once: a text of megabytes may be YAML with a mistake in each of its lines. An empty list says "cannot be matched".
            offsets = self._offsets = unit_offsets(self.raw, self.value, not self.cdata) or []
        if not offsets or index >= len(offsets):
            return min(self._start + index, self._end)
        return self._start + offsets[index]


class Comment:
    """A comment: ``text`` is what stands between ``<!--`` and ``-->``; ``parent`` the element it stands in."""

    __slots__ = ("_end", "_start", "parent", "text")

    def __init__(self, text: str, start: int, end: int, parent: Element | None) -> None:
        self.text = text
        self.parent = parent
        self._start = start
        self._end = end

    def __repr__(self) -> str:
        return f"Comment({self.text!r})"

    @property
    def span(self) -> Span:
        """The whole comment, with its brackets."""
        return Span(self._start, self._end)


class Element:
    """One element. ``index`` is its number in document order (the document element is 0), ``depth`` counts from 0.

    ``tag`` and the attribute names are as written (``prefix:local``). ``texts`` are its direct text and CDATA in order.
    """

    __slots__ = (
        "_end",
        "_end_start",
        "_name_end",
        "_start",
        "_start_end",
        "_text_ends",
        "attributes",
        "children",
        "depth",
        "index",
        "parent",
        "self_closed",
        "tag",
        "texts",
    )

    def __init__(self, tag: str, parent: Element | None, index: int, depth: int, start: int) -> None:
        self.tag = tag
        self.parent = parent
        self.index = index
        self.depth = depth
        self.attributes: dict[str, Attribute] = {}
        self.children: list[Element] = []
        self.texts: list[Text] = []
        self._text_ends: Sequence[int] = ()
        self.self_closed = False
        self._start = self._name_end = self._start_end = self._end_start = self._end = start

    def __repr__(self) -> str:
        return f"Element({self.tag!r}, {self.index})"

    @property
    def span(self) -> Span:
        """The whole element, from ``<`` to the ``>`` of its end tag (its start tag, if it is never closed)."""
        return Span(self._start, self._end)

    @property
    def start_span(self) -> Span:
        """The start tag, with its brackets."""
        return Span(self._start, self._start_end)

    @property
    def name_span(self) -> Span:
        """The tag name in the start tag."""
        if self._name_end == self._start_end:  # out of an entity: there is no name to see
            return Span(self._start, self._start_end)
        return Span(self._start + 1, self._name_end)

    @property
    def end_span(self) -> Span:
        """The end tag; empty, at the end, where there is none."""
        return Span(self._end_start, self._end)

    def get(self, name: str) -> str | None:
        """The value of attribute ``name``."""
        attribute = self.attributes.get(name)
        return None if attribute is None else attribute.value

    @property
    def text(self) -> str:
        """Direct text and CDATA in one piece, as ``roslaunch.xmlloader._get_text`` gives it."""
        return "".join(text.value for text in self.texts)

    def text_offset(self, index: int) -> int:
        """The source offset of ``text[index]`` (of its end for ``index == len(text)``)."""
        if not self.texts:
            return self._start_end
        if len(self._text_ends) != len(self.texts):
            self._text_ends = tuple(accumulate(len(text.value) for text in self.texts))
        number = min(bisect_right(self._text_ends, index), len(self.texts) - 1)
        return self.texts[number].offset(index - (self._text_ends[number - 1] if number else 0))


class Document:
    """One parsed file.

    ``root`` is the document element. ``launch`` is what roslaunch works on: the only ``<launch>`` element, wherever it stands;
    ``None`` where there is none or more than one, or the file is not well-formed (then ``elements`` and ``comments`` hold what
    was read until there). ``description`` is what the front ends of ROS 2 make of the file, where one of them has read it.
    ``max_depth`` is the depth of the deepest element (0 for the document element). ``encoding`` is a Python codec name; ``bom`` the
    byte order mark the file begins with.
    """

    __slots__ = ("bom", "comments", "description", "elements", "encoding", "launch", "max_depth", "problems", "root", "source")

    def __init__(self, source: Source, encoding: str = "utf-8", bom: bytes = b"") -> None:
        self.source = source
        self.encoding = encoding
        self.bom = bom
        self.root: Element | None = None
        self.launch: Element | None = None
        self.elements: list[Element] = []
        self.comments: list[Comment] = []
        self.max_depth = 0
        self.problems: list[Problem] = []
        self.description: Description | None = None

    def __repr__(self) -> str:
        return f"Document({self.source.path!r})"

    def place(self, span: Span) -> Place:
        """``span`` as a place in this file."""
        return Place(self.source, span)

    def telling(self, problems: Iterable[Problem], description: Description) -> Document:
        """The same file as ROS 2 has it: with other problems, and with what it describes."""
        other = copy(self)
        other.problems = list(problems)
        other.description = description
        return other

    def element_from(self, offset: int) -> Element | None:
        """The first element that starts at or after ``offset``."""
        index = bisect_left(self.elements, offset, key=lambda element: element._start)
        return self.elements[index] if index < len(self.elements) else None

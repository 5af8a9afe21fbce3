"""A text of a launch file, in XML or YAML, that knows where each of its characters is written."""

from __future__ import annotations

import re

from launchlint.source import Place, Source, Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.tree import Attribute

_ESCAPED = re.compile(r"\\(?:x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|\r?\n[ \t]*|.)", re.DOTALL)
_BLANK = " \t\r\n"
_LINE_END = re.compile(r"\r\n?")


class Written:
    """``text``, and the ``place`` where a value of it is shown: inside the quotes, if there are any."""

    __slots__ = ("place", "text")

    def __init__(self, text: str, place: Place) -> None:
        self.text = text
        self.place = place

    def at(self, start: int, end: int) -> Place:
        """The place of ``text[start:end]``; here, where that cannot be told, the whole one."""
        return self.place

    def part(self, text: str, start: int) -> Written:
        """``text``, which stands in this one at ``start``, as a text of its own; a ``start`` below 0 says that nobody knows where."""
        return _Part(text, self, start) if start >= 0 else Written(text, self.place)


class _Part(Written):
    __slots__ = ("_start", "_whole")

    def __init__(self, text: str, whole: Written, start: int) -> None:
        super().__init__(text, whole.at(start, start + len(text)))
        self._whole = whole
        self._start = start

    def at(self, start: int, end: int) -> Place:
        """As far as it can be told."""
        return self._whole.at(self._start + start, self._start + end)


class InXml(Written):
    """The value of an attribute."""

    __slots__ = ("_attribute",)

    def __init__(self, attribute: Attribute, source: Source) -> None:
        super().__init__(attribute.value, attribute.place(source))
        self._attribute = attribute

    def at(self, start: int, end: int) -> Place:
        """As far as it can be told."""
        return Place(self.place.source, self._attribute.span_of(start, end))


class InText(Written):
    """The whole of a file that is no launch file: the line ends are those that Python makes of its own."""

    __slots__ = ()

    def __init__(self, source: Source) -> None:
        text = source.text
        super().__init__(_LINE_END.sub("\n", text) if "\r" in text else text, Place(source, Span(0, len(text))))

    def at(self, start: int, end: int) -> Place:
        """Exact, where no line end is longer than one character."""
        return Place(self.place.source, Span(start, end)) if len(self.text) == self.place.span.end else self.place


class InYaml(Written):
    """A scalar: ``span`` is all of it, with its quotes."""

    __slots__ = ("_offsets", "_span")

    def __init__(self, text: str, source: Source, span: Span) -> None:
        start, end = span
        inside = (
            Span(start + 1, end - 1)
            if end - start > 2 and source.text[start] in "'\"" and source.text[end - 1] == source.text[start]
            else span
        )
        super().__init__(text, Place(source, inside))
        self._span = span
        self._offsets: list[int] | None = None

    def at(self, start: int, end: int) -> Place:
        """As far as it can be told."""
        offsets = self._offsets
        if offsets is None:
            offsets = self._offsets = scalar_offsets(self.place.source.text, self._span, self.text)
        if not offsets:
            return self.place
        last = offsets[end] if end > start else offsets[start]
        if end > start and end < len(self.text) and self.text[end - 1] not in _BLANK:
            last = min(last, offsets[end - 1] + max(1, offsets[end] - offsets[end - 1]))
        return Place(self.place.source, Span(offsets[start], last))


def scalar_offsets(source: str, span: Span, text: str) -> list[int]:
    """Where in ``source`` each character of ``text`` is written, and its end as last item, for the scalar at ``span``.

    Blanks of the text match any run of blanks: what is folded over several lines is one. Empty where the two do not go together.
    """
    start, end = span
    opened = source[start : start + 1]
    position = start
    if opened in ("'", '"'):
        position, end = start + 1, end - 1
    elif opened in ("|", ">"):
        opened, position = "|", source.find("\n", start, end) + 1 or end
    else:
        opened = ""
    offsets: list[int] = []
    for letter in text:
        if letter in _BLANK:
            offsets.append(position)
            if opened == '"' and source[position : position + 1] == "\\":
                position = _after_escape(source, position)
            elif source[position : position + 1] in ("\n", "\r"):
                while position < end and source[position] in _BLANK:
                    position += 1
            elif position < end and source[position] in _BLANK:
                position += 1
            continue
        while position < end and source[position] in _BLANK:
            position += 1
        if opened == '"' and source.startswith(("\\\n", "\\\r"), position):
            position = _after_escape(source, position)
        if position >= end:
            return []
        offsets.append(position)
        if opened == '"' and source[position] == "\\":
            position = _after_escape(source, position)
        elif source[position] != letter:
            return []
        else:
            position += 2 if opened == "'" and letter == "'" else 1
    offsets.append(min(position, end))
    return offsets


def _after_escape(source: str, position: int) -> int:
    match = _ESCAPED.match(source, position)
    return position + 1 if match is None else match.end()

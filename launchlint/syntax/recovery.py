"""A text that can be read, made of one that is being written: what is half written is left out, and all else keeps its meaning.

:class:`Recovered` says which places of the two belong together. In XML a half-written tag keeps the attributes that are whole; an element
that nothing closes ends before the next tag that is indented no further. Of YAML and Python the lines are left out that keep the rest from
being read.
"""

from __future__ import annotations

import ast
import pyexpat as expat
import re

from launchlint.finding import Edit
from launchlint.late import late
from launchlint.named_tuple import NamedTuple

_NAME = r"[A-Za-z_:][\w:.-]*"
_OPEN = late(rf"<({_NAME})")
_CLOSE = late(rf"</({_NAME})\s*>")
_BROKEN_CLOSE = late(rf"</(?:{_NAME})?")
_ATTRIBUTE = late(rf"""(?<!\s)\s+({_NAME})\s*=\s*(?:"([^"<]*)"|'([^'<]*)')""")
_SWALLOWED = late(rf"\s{_NAME}\s*=\s*$")
_END = late(r"\s*(/?)>")
_AMPERSAND = late(r"&(?!(?:lt|gt|amp|quot|apos|#\d+|#x[0-9a-fA-F]+);)")
_DECLARATION = late(
    r"""<\?xml\s+version\s*=\s*["']1\.\d["'](?:\s+encoding\s*=\s*["'][\w.-]+["'])?(?:\s+standalone\s*=\s*["'](?:yes|no)["'])?\s*\?>"""
)
_BAD = late(r"[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]")
_WHOLE = (("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>"), ("<!DOCTYPE", ">"))
_ROOT = "launch"
MOST_LINES = 8
"""Lines of YAML or Python that are left out, one after another, until the rest can be read."""
MOST_EDITS = 400
"""Changes of a text, and elements that are open at one place: who types makes a few mistakes, and a file with more is left as it is."""


class Recovered(NamedTuple):
    """A ``text`` that can be read: another one with ``edits``, in order, none of which meets another."""

    text: str
    edits: tuple[Edit, ...] = ()

    def forth(self, offset: int) -> int:
        """Where an offset of the original is in :attr:`text`; what was replaced is where its replacement begins."""
        moved = 0
        for edit in self.edits:
            if offset < edit.end or (offset == edit.start == edit.end):
                return min(offset, edit.start) + moved
            moved += len(edit.text) - (edit.end - edit.start)
        return offset + moved

    def back(self, offset: int) -> int:
        """Where an offset of :attr:`text` was in the original."""
        moved = 0
        for edit in self.edits:
            start = edit.start + moved
            if offset <= start:
                break
            if offset < start + len(edit.text):
                return edit.start
            moved += len(edit.text) - (edit.end - edit.start)
        return offset - moved

    def is_lost(self, start: int, end: int) -> bool:
        """Whether a stretch of the original meets one that was replaced."""
        return any(edit.start <= end and start <= edit.end for edit in self.edits)


def with_edits(text: str, edits: list[Edit]) -> Recovered:
    """``text`` after ``edits``; of those that meet each other the first ones."""
    taken: list[Edit] = []
    pieces: list[str] = []
    done = 0
    for edit in sorted(edits, key=lambda each: (each.start, each.end)):
        if edit.start < done:
            continue
        pieces += (text[done : edit.start], edit.text)
        done = edit.end
        taken.append(edit)
    return Recovered("".join([*pieces, text[done:]]), tuple(taken))


def recovered(text: str, path: str) -> Recovered:
    """``text`` as it can be read, by the name of its file and how it begins."""
    if path.endswith((".yaml", ".yml")):
        return _by_lines(text, _yaml_error)
    if path.endswith(".py"):
        return _by_lines(text, _python_error)
    return recovered_xml(text)


def is_readable(text: str, path: str) -> bool:
    """Whether ``text`` is XML, YAML or Python, by the name of its file."""
    if path.endswith((".yaml", ".yml")):
        return _yaml_error(text) is None
    if path.endswith(".py"):
        return _python_error(text) is None
    from launchlint.syntax.parse import parse
    from launchlint.syntax.problems import MalformedXml

    return not any(isinstance(problem, MalformedXml) for problem in parse(text.encode("utf-8", "surrogateescape"), path).problems)


def changed_from(text: str, before: str) -> Recovered:
    """``before``, which can be read, for ``text``: with what is different between the two as one edit."""
    start = _alike(text, before)
    most = min(len(text), len(before)) - start
    end = _alike(text[::-1][:most], before[::-1][:most])
    return Recovered(before, (Edit("", start, len(text) - end, before[start : len(before) - end]),))


def _alike(one: str, other: str) -> int:
    """How many characters the beginnings of two texts share."""
    low, high = 0, min(len(one), len(other))
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if one[low:middle] == other[low:middle] else (low, middle - 1)
    return low


class _Open:
    """An element that is not closed yet: the place behind its attributes, and whether its ``>`` is there."""

    __slots__ = ("end", "indentation", "name", "whole")

    def __init__(self, name: str, end: int, indentation: int, whole: bool) -> None:
        self.name = name
        self.end = end
        self.indentation = indentation
        self.whole = whole


MOST_LOOKS = 40
"""How often the rest of a text is looked through for the end of an element."""


class _GivenUp(Exception):
    """There is too much to be changed."""


class _Scan:
    """One reading of a text, which notes what has to be changed."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.edits: list[Edit] = []
        self.opened: list[_Open] = []
        self.rooted = False
        self.looks = 0
        self.has_entities = "<!ENTITY" in text

    def replace(self, start: int, end: int, by: str = "") -> None:
        if len(self.edits) >= MOST_EDITS:
            raise _GivenUp
        self.edits.append(Edit("", start, end, by))

    def indentation(self, at: int) -> int:
        """Of a tag that is the first on its line; else more than any."""
        line = self.text.rfind("\n", 0, at) + 1
        return at - line if not self.text[line:at].strip() else 1 << 30

    def run(self) -> list[Edit]:
        text, at = self.text, 0
        while (start := text.find("<", at)) >= 0:
            self._between(at, start)
            at = self._markup(start)
        self._between(at, len(text))
        self._close_down_to(0, len(text.rstrip()))
        if not self.rooted:
            self.replace(len(text), len(text), "<launch/>")
        return self.edits

    def _between(self, start: int, end: int) -> None:
        for match in _BAD.finditer(self.text, start, end):
            self.replace(match.start(), match.end())
        if not self.opened:
            words = self.text[start:end]
            if words.strip(" \t\r\n\ufeff"):
                self.replace(start, end)
            return
        self._ampersands(start, end)

    def _ampersands(self, start: int, end: int) -> None:
        if not self.has_entities:
            for match in _AMPERSAND.finditer(self.text, start, end):
                self.replace(match.start(), match.end(), "&amp;")

    def _markup(self, start: int) -> int:
        """What begins with ``<`` at ``start``. Returns its end."""
        text = self.text
        for opens, closes in _WHOLE:
            if text.startswith(opens, start):
                return self._whole(start, opens, closes)
        close = _CLOSE.match(text, start)
        if close is not None:
            self._closed(close[1], start, close.end())
            return close.end()
        broken = _BROKEN_CLOSE.match(text, start)
        if broken is not None:
            self.replace(start, broken.end())
            return broken.end()
        opening = _OPEN.match(text, start)
        if opening is None:
            self.replace(start, start + 1)
            return start + 1
        return self._tag(opening)

    def _whole(self, start: int, opens: str, closes: str) -> int:
        end = self.text.find(closes, start + len(opens))
        if end < 0:
            line = self.text.find("\n", start)
            end = len(self.text) if line < 0 else line
            self.replace(start, end)
            return end
        if opens == "<!--" and ("--" in self.text[start + 4 : end] or self.text[end - 1] == "-"):
            self.replace(start, end + 3)
        elif (opens == "<?" and self._is_bad_declaration(start)) or (opens == "<![CDATA[" and not self.opened):
            self.replace(start, end + len(closes))
        return end + len(closes)

    def _is_bad_declaration(self, start: int) -> bool:
        return self.text.startswith("<?xml", start) and (start > 0 or _DECLARATION.match(self.text) is None)

    def _name(self, opening: re.Match[str]) -> str:
        """The name of a tag; of the first one what it is going to be."""
        name: str = opening[1]
        if self.rooted or self.opened or name == _ROOT or f"</{_ROOT}" not in self.text:
            return name
        self.replace(opening.start(1), opening.end(1), _ROOT)
        return _ROOT

    def _tag(self, opening: re.Match[str]) -> int:
        text, start, name = self.text, opening.start(), self._name(opening)
        indentation = self.indentation(start)
        before = max((number for number, each in enumerate(self.opened) if each.indentation >= indentation), default=-1)
        unclosed = [number for number, each in enumerate(self.opened) if each.indentation >= indentation and indentation < 1 << 30]
        if unclosed and before >= 0 and self.opened[0].indentation < indentation and not self._is_closed_later(unclosed[0], start):
            self._close_down_to(unclosed[0], start)
        at = opening.end()
        limit = text.find("<", at)
        limit = len(text) if limit < 0 else limit
        names: set[str] = set()
        while True:
            end = _END.match(text, at)
            if end is not None:
                self._opened(name, end.end(), indentation, closed=bool(end[1]), start=start)
                return end.end()
            attribute = _ATTRIBUTE.match(text, at)
            if attribute is None:
                following = _ATTRIBUTE.search(text, at, limit)
                finish = _finish(text, at, limit) if following is None else following.start()
                self.replace(at, finish)
                at = finish
                if following is None and _END.match(text, at) is None:
                    return self._unfinished(name, at, indentation, start)
                continue
            value = attribute[2] if attribute[2] is not None else attribute[3]
            swallowed = _SWALLOWED.search(value)
            if swallowed is not None:  # a quote is missing: the next attribute stands in the value
                resume = attribute.end() - 1 - len(value) + swallowed.start()
                self.replace(attribute.start(), resume)
                at = resume
                continue
            if attribute[1] in names:
                self.replace(attribute.start(), attribute.end())
            names.add(attribute[1])
            self._ampersands(attribute.start(), attribute.end())
            at = attribute.end()

    def _is_closed_later(self, number: int, start: int) -> bool:
        """Whether the text behind ``start`` closes more elements of the name than it opens."""
        self.looks += 1
        if self.looks > MOST_LOOKS:
            raise _GivenUp
        name = re.escape(self.opened[number].name)
        depth = 0
        for match in re.finditer(rf"<(/?){name}(?=[\s/>])(?:[^<>]*?(/?)>)?", self.text[start:]):
            if match[1]:
                depth -= 1
                if depth < 0:
                    return True
            elif not match[2]:
                depth += 1
        return False

    def _opened(self, name: str, end: int, indentation: int, *, closed: bool, start: int) -> None:
        if not self.opened and self.rooted:
            self.replace(start, end)  # a second root
            return
        self.rooted = True
        if len(self.opened) >= MOST_EDITS:
            raise _GivenUp
        if not closed:
            self.opened.append(_Open(name, end, indentation, whole=True))

    def _unfinished(self, name: str, at: int, indentation: int, start: int) -> int:
        if not self.opened and self.rooted:
            self.replace(start, at)
            return at
        self.rooted = True
        if len(self.opened) >= MOST_EDITS:
            raise _GivenUp
        self.opened.append(_Open(name, at, indentation, whole=False))
        return at

    def _closed(self, name: str, start: int, end: int) -> None:
        number = next((each for each in reversed(range(len(self.opened))) if self.opened[each].name == name), None)
        if number is None:
            self.replace(start, end)
            return
        self._close_down_to(number + 1, start)
        last = self.opened.pop()
        if not last.whole:
            self.replace(last.end, last.end, ">")

    def _close_down_to(self, number: int, at: int) -> None:
        """Close the elements that are open above ``number``, in front of ``at``."""
        ends = ""
        while len(self.opened) > number:
            last = self.opened.pop()
            if last.whole:
                ends += f"</{last.name}>"
            else:
                self.replace(last.end, last.end, "/>")
        if ends:
            self.replace(at, at, ends)


def _finish(text: str, at: int, limit: int) -> int:
    """Where the rest of a tag that cannot be read ends: before its ``>`` or ``/>``, else behind the last of it."""
    rest = text[at:limit].rstrip()
    for end in ("/>", ">"):
        if rest.endswith(end):
            return at + len(rest) - len(end)
    closing = rest.find(">")
    if closing >= 0:
        return at + closing - (1 if rest[closing - 1 : closing] == "/" else 0)
    return at + len(rest)


def recovered_xml(text: str) -> Recovered:
    """``text`` as XML that can be read, as far as that can be had."""
    if _is_well_formed(text):
        return Recovered(text)
    try:
        edits = _Scan(text).run()
    except _GivenUp:
        return Recovered(text)
    merged: dict[tuple[int, int], Edit] = {}
    for edit in edits:  # what is put in at one place goes into one edit, in order
        same = merged.get((edit.start, edit.end)) if edit.start == edit.end else None
        merged[edit.start, edit.end] = edit if same is None else same._replace(text=same.text + edit.text)
    return with_edits(text, list(merged.values()))


def _is_well_formed(text: str) -> bool:
    """Whether an XML parser reads all of it: told without making anything of it."""
    parser = expat.ParserCreate(namespace_separator=" ")
    try:
        parser.Parse(text.encode("utf-8", "surrogateescape"), True)
    except (expat.ExpatError, LookupError, ValueError, TypeError):
        return False
    return True


def _by_lines(text: str, error: object) -> Recovered:
    """``text`` without the lines at which ``error`` says that it cannot be read; as it is where that does not help."""
    assert callable(error)
    lines = text.split("\n")
    edits: list[Edit] = []
    for _ in range(MOST_LINES):
        number = error("\n".join(lines))
        if number is None:
            return with_edits(text, edits)
        number = min(max(number, 0), len(lines) - 1)
        while number > 0 and not lines[number].strip():
            number -= 1
        if not lines[number].strip():
            break
        start = sum(len(each) + 1 for each in text.split("\n")[:number])
        line = text.split("\n")[number]
        edits.append(Edit("", start, start + len(line), ""))
        lines[number] = ""
    return Recovered(text)


def _yaml_error(text: str) -> int | None:
    from launchlint.syntax.ros2.yaml_data import load
    from launchlint.yaml.refusals import YamlError
    from launchlint.yaml.tree import YamlBeyond

    try:
        load(text, [])
    except YamlError as error:
        return text.count("\n", 0, error.offset)
    except YamlBeyond:
        return None
    return None


def _python_error(text: str) -> int | None:
    try:
        ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        return (getattr(error, "lineno", None) or 1) - 1
    return None

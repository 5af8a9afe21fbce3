"""The proof that two texts say the same in XML, where only white space and the order of attributes may differ.

What is compared is what expat reads, in the manner of canonical XML (C14N): elements, attributes with their values, text, comments and
processing instructions, in order. White space counts in the text of ``<rosparam>``, which is YAML, though not
in which column all of it stands. roslaunch reads no other text (in
``roslaunch.xmlloader.XmlLoader`` only ``_rosparam_tag`` calls ``_get_text``), and there it counts only where ``xml:space`` says so.
"""

from __future__ import annotations

import pyexpat as expat
import re

from launchlint.fix.format.yaml_block import unindented

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Event = tuple[Any, ...]

_SPACE = re.compile(r"[ \t\r\n]+")


def says_the_same(before: bytes, after: bytes) -> bool:
    """Whether two well-formed documents differ at most in white space that means nothing and in the order of attributes."""
    return events(before) == events(after)


def events(data: bytes) -> list[Event]:
    """What expat reads in a document that is known to be well-formed and harmless (:func:`launchlint.syntax.parse.parse` says so)."""
    reader = _Reader()
    reader.read(data)
    return reader.found


class _Reader:
    def __init__(self) -> None:
        self.found: list[Event] = []
        self._text: list[str] = []
        self._exact = 0  # how many of the open elements keep their white space

    def read(self, data: bytes) -> None:
        parser = expat.ParserCreate()
        parser.buffer_text = True
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._text.append
        parser.CommentHandler = lambda text: self._add("comment", *_lines(text))
        parser.ProcessingInstructionHandler = lambda target, data: self._add("instruction", target, data)
        parser.StartDoctypeDeclHandler = lambda *names: self._add("doctype", *names)
        parser.EntityDeclHandler = lambda *facts: self._add("entity", *facts)
        parser.XmlDeclHandler = lambda *facts: self._add("xml", *facts)
        parser.ExternalEntityRefHandler = lambda *_: 1
        try:
            parser.Parse(data, True)
        finally:
            parser.StartElementHandler = parser.EndElementHandler = parser.CharacterDataHandler = parser.CommentHandler = None
            parser.ProcessingInstructionHandler = parser.StartDoctypeDeclHandler = parser.EntityDeclHandler = None
            parser.XmlDeclHandler = parser.ExternalEntityRefHandler = None

    def _add(self, *event: object) -> None:
        if self._text:
            text = "".join(self._text)
            self._text.clear()
            if not self._exact:
                text = _SPACE.sub("", text)
            elif event == ("end", "rosparam") and self.found[-1][:2] == ("start", "rosparam"):
                text = unindented(text)
            if text:
                self.found.append(("text", text))
        self.found.append(event)

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self._add("start", name, attributes)
        if self._exact or name.lower() == "rosparam" or attributes.get("xml:space") == "preserve":
            self._exact += 1

    def _end(self, name: str) -> None:
        self._add("end", name)
        if self._exact:
            self._exact -= 1


def _lines(comment: str) -> tuple[str, ...]:
    return tuple(line.strip(" \t\r") for line in comment.split("\n"))

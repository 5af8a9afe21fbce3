"""Bytes to a positioned tree, by the same parser and with the same verdict as roslaunch.

roslaunch reads a file with ``xml.dom.minidom.parse`` (``roslaunch.xmlloader.XmlLoader._parse_launch``), which is expat with
namespaces. Here expat is set up in the same way; the places come from scanning the decoded text where expat says that something starts.
"""

from __future__ import annotations

import pyexpat as expat
import re

from launchlint.source import Origin, Place, Source, Span
from launchlint.syntax.decode import Decoded, decode
from launchlint.syntax.entities import MAX_EXPANSION, expansion
from launchlint.syntax.problems import RootNotLaunch, UnreadableFile
from launchlint.syntax.tree import Attribute, Comment, Document, Element, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    pass

MAX_BYTES = 32 * 1024 * 1024
"""Files larger than this are not read: the largest launch file met in the wild has 0.2 MB."""

MAX_PIECES = 250_000
"""Elements, attributes, texts and comments that one file may have: keeps a hostile file within some 100 MB of memory."""

MAX_DEPTH = 988
"""Elements that may stand inside each other, the document element included.

roslaunch walks the tree by recursion (``xml.dom.minidom``'s ``getElementsByTagName``) within Python's limit of 1,000 frames. Tried
with roslaunch 1.15.15 and Python 3.11: as the file that is started, 988 nested groups load and 989 overflow; tags it ignores may be
992 deep; in a file that the started one includes it is 988 again, and four fewer for each further include.
"""

# One step inside a start tag: either an attribute (name, value in double or single quotes) or the end of the tag.
_STEP = re.compile(r"""[ \t\r\n]*(?:([^ \t\r\n=/>"'<]+)[ \t\r\n]*=[ \t\r\n]*(?:"([^"]*)"|'([^']*)')|(/?)>)""")


class _TooMuch(Exception):
    """Raised inside a handler to end the parsing of a file with more than MAX_PIECES pieces."""


class _SpaceInNamespace(Exception):
    """A namespace name with a blank in it, which minidom refuses with a ValueError (newer versions of expat do so themselves)."""


def parse(data: bytes, path: str, file: str | None = None) -> Document:
    """Parse the content of a launch file.

    ``path`` is the name shown to people, ``file`` the one it was opened under. Never raises: what is wrong with the file is in
    ``Document.problems``, with these kinds:

    * ``malformed-xml`` (refused): ``message`` in plain words, ``code`` the name of expat's error, ``hint`` what was probably meant (may be
      empty), ``opened`` and ``closed`` the tag names where tags do not match;
    * ``root-not-launch`` (refused, unless there is one ``<launch>`` inside another root): ``tag`` the document element, ``count`` the
      number of ``<launch>`` elements;
    * ``unreadable-file``: ``reason``. The file is larger than launchlint is willing to read; roslaunch might do so.
    """
    if len(data) > MAX_BYTES:
        document = Document(Source(path, "", file))
        return _unreadable(document, f"the file has more than {MAX_BYTES // (1024 * 1024)} MiB")
    decoded = decode(data)
    document = Document(Source(path, decoded.text, file), decoded.encoding, decoded.bom)
    if "<!ENTITY" in decoded.text:
        worst = expansion(decoded.text)
        if worst.too_deep:
            return _unreadable(document, "its entities refer to each other more than 50 deep")
        if worst.size > MAX_EXPANSION and worst.size < 100 * len(data):
            return _unreadable(document, f"its entities expand to more than {MAX_EXPANSION // (1024 * 1024)} MiB")
        if worst.size > MAX_EXPANSION:
            # What expat 2.4 and later say by themselves; older versions try to expand them, so they do not get to see the file.
            return _malformed(document, decoded, "XML_ERROR_AMPLIFICATION_LIMIT_BREACH", worst.first)
    reader = _Reader(document, decoded)
    try:
        reader.read(data)
    except expat.ExpatError as error:
        return _malformed(document, decoded, error.code, decoded.offset(reader.error_index()), reader)
    except _TooMuch:
        return _unreadable(document, f"it has more than {MAX_PIECES:,} elements, attributes and comments")
    except _SpaceInNamespace:
        return _malformed(document, decoded, "XML_ERROR_SYNTAX", reader.at, reader)
    except (LookupError, ValueError, TypeError, Warning):
        # pyexpat asks Python for an encoding that expat does not know: LookupError where Python does not know it either, ValueError or
        # TypeError where it is no encoding of single bytes.
        return _malformed(document, decoded, "XML_ERROR_UNKNOWN_ENCODING", 0, reader)
    _find_launch(document, decoded)
    return document


class _Reader:
    """The handlers of one expat parser, building ``document``."""

    __slots__ = (
        "_cdata",
        "_decoded",
        "_direct",
        "_document",
        "_elements",
        "_namespaces",
        "_parser",
        "_pending",
        "_pieces",
        "_text",
        "at",
        "current",
        "last_end",
    )

    def __init__(self, document: Document, decoded: Decoded) -> None:
        self._document = document
        self._elements = document.elements
        self._decoded = decoded
        self._direct = decoded.direct
        self._text = decoded.text
        self._pending: list[str] = []
        self._namespaces: list[tuple[str | None, str | None]] = []
        self._pieces = 0
        self._cdata = False
        self.current: Element | None = None
        self.at = 0  # start of the event that is being handled
        self.last_end = 0  # end of the last one: where text after it begins
        parser = expat.ParserCreate(namespace_separator=" ")
        parser.namespace_prefixes = True
        parser.ordered_attributes = True
        parser.specified_attributes = True
        parser.buffer_text = True
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._pending.append
        parser.CommentHandler = self._comment
        parser.ProcessingInstructionHandler = self._instruction
        parser.StartCdataSectionHandler = self._start_cdata
        parser.EndCdataSectionHandler = self._end_cdata
        parser.StartNamespaceDeclHandler = self._namespace
        # An external entity is never opened: the reference stands for nothing, as in xml.dom.expatbuilder.
        parser.ExternalEntityRefHandler = lambda *_: 1
        self._parser = parser

    def read(self, data: bytes) -> None:
        try:
            self._parser.Parse(data, True)
        finally:
            # The handlers are bound methods and the parser is an attribute: without this the cycle waits for the garbage collector.
            parser = self._parser
            parser.StartElementHandler = parser.EndElementHandler = parser.CharacterDataHandler = parser.CommentHandler = None
            parser.ProcessingInstructionHandler = parser.StartCdataSectionHandler = parser.EndCdataSectionHandler = None
            parser.StartNamespaceDeclHandler = parser.ExternalEntityRefHandler = None

    def error_index(self) -> int:
        """The byte at which expat stopped."""
        return self._parser.ErrorByteIndex

    def open_elements(self) -> list[Element]:
        """The elements that are still open, outermost first."""
        chain: list[Element] = []
        element = self.current
        while element is not None:
            chain.append(element)
            element = element.parent
        chain.reverse()
        return chain

    def _event(self) -> int:
        """The offset of the present event; stores the text that ended there."""
        index = self._parser.CurrentByteIndex
        at = index if self._direct else self._decoded.offset(index)
        self.at = at
        if self._pending:
            value = "".join(self._pending)
            self._pending.clear()
            current = self.current
            if current is not None:
                start = min(at, self.last_end)
                current.texts.append(Text(value, self._text[start:at], start, at, self._cdata))
                self._pieces += 1
        return at

    def _count(self, pieces: int) -> None:
        self._pieces += pieces
        if self._pieces > MAX_PIECES:
            raise _TooMuch

    def _reference_end(self, at: int) -> int:
        """The end of the entity reference at ``at``, for what comes out of an entity."""
        return self._text.find(";", at) + 1

    def _start(self, name: str, attributes: list[str]) -> None:
        at = self._event()
        elements = self._elements
        parent = self.current
        pieces = self._pieces = self._pieces + 1 + len(attributes) // 2
        if pieces > MAX_PIECES:
            raise _TooMuch
        if " " in name:
            name = _qualified(name)
        if parent is None:
            element = Element(name, None, len(elements), 0, at)
            self._document.root = element
        else:
            depth = parent.depth + 1
            element = Element(name, parent, len(elements), depth, at)
            parent.children.append(element)
            if depth > self._document.max_depth:
                self._document.max_depth = depth
        elements.append(element)
        self.current = element
        text = self._text
        if text[at] == "<":
            position = element._name_end = at + 1 + len(name)
            if attributes or self._namespaces:
                position = self._attributes(element, attributes, position)
            step = _STEP.match(text, position)
            if step is not None and (slash := step.start(4)) >= 0:
                end = step.end()
                if step.end(4) > slash:
                    element.self_closed = True
                    element._end_start = end
                element._end = element._start_end = self.last_end = end
                return
        # Out of an entity: everything has the place of the reference.
        end = self._reference_end(at)
        element._name_end = element._start_end = element._end_start = element._end = self.last_end = end
        element.attributes = {}
        declared = [(_xmlns(prefix), uri or "") for prefix, uri in self._namespaces]
        self._namespaces.clear()
        raw = text[at:end]
        for key, value in [*declared, *zip(attributes[::2], attributes[1::2], strict=True)]:
            key = _qualified(key) if " " in key else key
            element.attributes[key] = Attribute(key, value, raw, at, end, at, end)

    def _attributes(self, element: Element, values: list[str], position: int) -> int:
        """Scan the attributes of a start tag from ``position``, the end of the tag name; returns the end of the last one."""
        text = self._text
        match = _STEP.match
        found = element.attributes
        namespaces = self._namespaces
        declared: dict[str, str] = {}
        if namespaces:
            declared = {_xmlns(prefix): uri or "" for prefix, uri in namespaces}
            namespaces.clear()
        index = 0
        total = len(values)
        while index < total or declared:
            step = match(text, position)
            if step is None:
                break
            group = step.lastindex
            if group != 2 and group != 3:
                break
            name_start, name_end = step.span(1)
            start, end = step.span(group)
            position = end + 1
            if declared and (written := text[name_start:name_end]) in declared:
                name, value = written, declared.pop(written)
            elif index < total:
                name, value = values[index], values[index + 1]
                index += 2
                if " " in name:
                    name = _qualified(name)
            else:
                break
            found[name] = Attribute(name, value, text[start:end], name_start, name_end, start, end)
        if not declared:
            return position
        for name, value in declared.items():
            # A namespace that only a DTD declares, as the default of an attribute: minidom makes it an attribute too.
            span = (element._start + 1, element._name_end)
            found[name] = Attribute(name, value, text[slice(*span)], *span, *span)
        return position

    def _end(self, name: str) -> None:
        at = self._event()
        element = self.current
        if element is None:
            return
        if not element.self_closed:
            text = self._text
            element._end_start = at
            if text.startswith("</", at):
                element._end = self.last_end = text.find(">", at) + 1
            else:
                element._end = self.last_end = self._reference_end(at)
                element._end_start = element._end
        self.current = element.parent

    def _comment(self, text: str) -> None:
        at = self._event()
        self._count(1)
        end = self._text.find("-->", at + 4) + 3 if self._text.startswith("<!--", at) else self._reference_end(at)
        self._document.comments.append(Comment(text, at, end, self.current))
        self.last_end = end

    def _instruction(self, target: str, data: str) -> None:
        at = self._event()
        self._count(1)
        self.last_end = self._text.find("?>", at) + 2 if self._text.startswith("<?", at) else self._reference_end(at)

    def _start_cdata(self) -> None:
        at = self._event()
        self._count(1)
        self._cdata = True
        self.last_end = at + len("<![CDATA[") if self._text.startswith("<![CDATA[", at) else at

    def _end_cdata(self) -> None:
        at = self._event()
        self._cdata = False
        self.last_end = at + len("]]>") if self._text.startswith("]]>", at) else at

    def _namespace(self, prefix: str | None, uri: str | None) -> None:
        self._namespaces.append((prefix, uri))


def _qualified(name: str) -> str:
    """``prefix:local`` of the ``uri local prefix`` that expat gives with namespaces on."""
    parts = name.split(" ")
    if len(parts) == 2:
        return parts[1]
    if len(parts) == 3:
        return f"{parts[2]}:{parts[1]}"
    raise _SpaceInNamespace


def _xmlns(prefix: str | None) -> str:
    return f"xmlns:{prefix}" if prefix else "xmlns"


def _unreadable(document: Document, reason: str) -> Document:
    document.problems.append(UnreadableFile(origin=Origin(document.place(Span(0, 0))), reason=reason))
    return document


def _malformed(document: Document, decoded: Decoded, code: str | int, offset: int, reader: _Reader | None = None) -> Document:
    from launchlint.syntax.malformed import diagnose  # only a broken file pays for it

    if reader is None:
        document.problems.append(diagnose(document, decoded, code, offset, [], 0))
    else:
        document.problems.append(diagnose(document, decoded, code, offset, reader.open_elements(), reader.last_end))
    return document


def _find_launch(document: Document, decoded: Decoded) -> None:
    """Set ``document.launch`` (``roslaunch.xmlloader.XmlLoader._parse_launch``: there must be exactly one)."""
    if document.max_depth >= MAX_DEPTH:
        deepest = next(element for element in document.elements if element.depth >= MAX_DEPTH)
        _malformed(document, decoded, "RecursionError", deepest.start_span.start)
        return
    found = [element for element in document.elements if element.tag == "launch"]
    root = document.root
    if root is None:  # expat refuses a document without an element
        return
    tag, count = root.tag, len(found)
    if len(found) == 1:
        document.launch = found[0]
        if found[0] is not root:
            inside = ((document.place(found[0].name_span), "what roslaunch looks at"),)
            document.problems.append(RootNotLaunch(origin=Origin(document.place(root.name_span)), related=inside, tag=tag, count=count))
        return
    if found:
        related: tuple[tuple[Place, str], ...] = ((document.place(found[0].name_span), "the first <launch>"),)
        where = found[1].name_span
    else:
        related = ()
        where = root.name_span
    origin = Origin(document.place(where))
    document.problems.append(RootNotLaunch(origin=origin, refused=True, related=related, tag=tag, count=count))

"""YAML text to a tree of nodes with places, as PyYAML's pure Python parser reads it: that is the one roslaunch uses.

libyaml is some ten times faster and agrees with it on all but a few signs; where one of them is in the text, or libyaml refuses the text,
the pure Python parser decides. The tree is built from the parser's events, without recursion.
"""

from __future__ import annotations

import re
from typing import Any, NoReturn

from launchlint.evaluate.ros1.values import UnknownValue

LONGEST_TEXT = 8_000_000
LONGEST_PURE = 1_000_000
DEEPEST = 100
#: Scalars of the document with every alias written out; a long text counts for several.
LARGEST_WRITTEN_OUT = 2_000_000

SCALAR, SEQUENCE, MAPPING = range(3)

STR, SEQ, MAP = "tag:yaml.org,2002:str", "tag:yaml.org,2002:seq", "tag:yaml.org,2002:map"
DEGREES, RADIANS = "!degrees", "!radians"

# Where the two parsers differ: line ends other than LF and CR, a byte order mark, characters that are not printable, directives, a
# comment right behind "|" or ">"; and outside comments tabs, tags, and "?" in brackets.
_DIFFERENT = re.compile(r"[\0-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff\ufeff\ufffe\uffff]|^%|[|>][-+\w]*#", re.MULTILINE)
_DIFFERENT_OUTSIDE_COMMENTS = re.compile(r"[\t!?]")
_COMMENT = re.compile(r"^((?:[^\n\"'#]*[ \t])?)#[^\n]*", re.MULTILINE)
_COLON = re.compile(r"[A-Za-z_][\w./~-]*:(?![:/\\])\S")
_ANGLES = ((DEGREES, re.compile(r"^deg\([^\)]*\)$")), (RADIANS, re.compile(r"^rad\([^\)]*\)$")))


class YamlError(Exception):
    """What roslaunch refuses: ``message`` in plain words, ``offset`` in the text, and a ``kind``.

    Kinds: ``syntax``, ``colon`` (a ``key:value`` without the blank; to the end of its line), ``character`` (one that YAML does not
    allow), ``documents`` (more than one), ``anchor`` (unknown alias, anchor used twice), ``tag`` (unknown), ``value`` (does not fit its
    tag), ``key`` (not a text, or not usable as a key), ``merge``.
    """

    def __init__(self, message: str, offset: int, kind: str) -> None:
        super().__init__(message)
        self.message = message
        self.offset = offset
        self.kind = kind


class YamlUnknown(UnknownValue):
    """The text is beyond our bounds: nothing can be said about it, and it is no error."""


def shown(text: str) -> str:
    """``text`` in quotes, for a message: without control characters, and not too long."""
    return repr(text if len(text) <= 60 else text[:57] + "...")


class Node:
    """One node: ``value`` is a str, a list of nodes or a list of pairs of nodes; ``made`` tells whether ``data`` holds its Python value.

    ``size`` counts the scalars in it with every alias written out; ``final`` are the pairs that count, once ``data`` is made.
    """

    __slots__ = ("data", "end", "final", "flat", "kind", "made", "size", "start", "tag", "value")

    def __init__(self, kind: int, tag: str, value: Any, start: int, end: int) -> None:
        self.kind = kind
        self.tag = tag
        self.value = value
        self.start = start
        self.end = end
        self.size = 1
        self.made = False
        self.flat = False
        self.data: Any = None
        self.final: dict[Any, tuple[Node, Node]] | None = None


class Tree:
    """The root of a document (None where it is empty), and the plain scalars that look like ``key:value``."""

    __slots__ = ("root", "scalar_colon")

    def __init__(self, root: Node | None, scalar_colon: list[tuple[int, int]]) -> None:
        self.root = root
        self.scalar_colon = scalar_colon


def parse(text: str, angles: bool = True) -> Tree:
    """The tree of a YAML text with a single document. Raises YamlError and YamlUnknown.

    With ``angles``, plain ``deg(…)`` and ``rad(…)`` carry the tags of rosparam.
    """
    import yaml

    if len(text) > LONGEST_TEXT:
        raise YamlUnknown(f"the YAML text is longer than {LONGEST_TEXT} characters")
    if getattr(yaml, "__with_libyaml__", False) and _agreed(text):
        try:
            return _Builder(yaml, yaml.CSafeLoader(text), text, angles).build()
        except (YamlError, yaml.YAMLError):
            pass  # the pure Python parser has the last word, and the better place
    if len(text) > LONGEST_PURE:
        raise YamlUnknown(f"the YAML text is longer than {LONGEST_PURE} characters")
    try:
        return _Builder(yaml, yaml.SafeLoader(text), text, angles).build()
    except yaml.YAMLError as error:
        _explain(error, text)


def _agreed(text: str) -> bool:
    """Whether both parsers read ``text`` alike, if both read it at all."""
    if _DIFFERENT.search(text) is not None:
        return False
    return _DIFFERENT_OUTSIDE_COMMENTS.search(text) is None or _DIFFERENT_OUTSIDE_COMMENTS.search(_COMMENT.sub(r"\1", text)) is None


class _Builder:
    """Turns the events of one parser into nodes."""

    __slots__ = ("anchors", "angles", "colons", "events", "parser", "resolvers", "tags", "text")

    def __init__(self, yaml: Any, parser: Any, text: str, angles: bool) -> None:
        self.events = yaml.events
        self.parser = parser
        self.text = text
        self.angles = angles
        self.resolvers = yaml.resolver.Resolver.yaml_implicit_resolvers
        self.tags: dict[str, str] = {}
        self.anchors: dict[str, Node | None] = {}
        self.colons: list[tuple[int, int]] = []

    def build(self) -> Tree:
        """Read all events."""
        try:
            return self._build()
        finally:
            self.parser.dispose()

    def _build(self) -> Tree:
        events, get = self.events, self.parser.get_event
        get()  # the start of the stream
        event = get()
        if isinstance(event, events.StreamEndEvent):
            return Tree(None, self.colons)
        root: Node | None = None
        scalar, alias = events.ScalarEvent, events.AliasEvent
        opening, closing = events.CollectionStartEvent, events.CollectionEndEvent
        # Open collections: the node, its children so far, its anchor, and whether it is in brackets.
        stack: list[tuple[Node, list[Node], str | None, bool]] = []
        while True:
            event = get()
            kind = type(event)
            if kind is scalar:
                node = self._scalar(event)
            elif kind is alias:
                node = self._alias(event)
            elif isinstance(event, opening):
                if len(stack) >= DEEPEST:
                    raise YamlUnknown(f"the YAML text is nested more than {DEEPEST} deep")
                sequence = kind is events.SequenceStartEvent
                default = SEQ if sequence else MAP
                tag = default if event.tag is None or event.tag == "!" else event.tag
                opened = Node(SEQUENCE if sequence else MAPPING, tag, None, event.start_mark.index, event.end_mark.index)
                if event.anchor is not None:
                    self._new_anchor(event)
                stack.append((opened, [], event.anchor, bool(event.flow_style)))
                continue
            elif isinstance(event, closing):
                node, children, anchor, brackets = stack.pop()
                self._close(node, children, event.end_mark.index if brackets else None)
                if anchor is not None:
                    self.anchors[anchor] = node
            else:
                break  # the end of the document
            if stack:
                stack[-1][1].append(node)
            else:
                root = node
        event = get()
        if not isinstance(event, events.StreamEndEvent):
            raise YamlError(
                "a second YAML document starts here; rosparam loads files with one document only", event.start_mark.index, "documents"
            )
        return Tree(root, self.colons)

    def _scalar(self, event: Any) -> Node:
        value, tag = event.value, event.tag
        start, end = event.start_mark.index, event.end_mark.index
        if tag is None or tag == "!":
            if event.implicit[0]:
                tag = self.tags.get(value)
                if tag is None:
                    tag = self.tags[value] = self._resolve(value)
                if tag is STR and ":" in value and _COLON.match(value):
                    self.colons.append((start, end))
            else:
                tag = STR
        if event.style in ("|", ">"):
            end = start + len(self.text[start:end].rstrip())
        node = Node(SCALAR, tag, value, start, end)
        node.size = 1 + len(value) // 100
        if event.anchor is not None:
            self._new_anchor(event)
            self.anchors[event.anchor] = node
        return node

    def _resolve(self, value: str) -> str:
        """The tag of a plain scalar (yaml.resolver.Resolver, with rosparam's two additions)."""
        for tag, pattern in self.resolvers.get(value[:1], ()):
            if pattern.match(value):
                return str(tag)
        if self.angles and value[:1] in ("d", "r", "e", "g", "(", "a"):
            for tag, pattern in _ANGLES:
                if pattern.match(value):
                    return str(tag)
        return STR

    def _alias(self, event: Any) -> Node:
        if event.anchor not in self.anchors:
            raise YamlError(
                f"the alias *{event.anchor[:60]} refers to an anchor that is not set above it", event.start_mark.index, "anchor"
            )
        node = self.anchors[event.anchor]
        if node is None:
            raise YamlUnknown("a YAML value that contains itself is not looked into")
        return node

    def _new_anchor(self, event: Any) -> None:
        if event.anchor in self.anchors:
            raise YamlError(f"the anchor &{event.anchor[:60]} is set a second time", event.start_mark.index, "anchor")
        self.anchors[event.anchor] = None

    def _close(self, node: Node, children: list[Node], end: int | None) -> None:
        for child in children:
            node.size += child.size
        if node.size > LARGEST_WRITTEN_OUT:
            raise YamlUnknown("the YAML text becomes too large when its aliases are written out")
        if node.kind == SEQUENCE:
            node.value = children
        else:
            node.value = list(zip(children[::2], children[1::2], strict=True))
            for key, value in node.value:
                if value.start == value.end:  # a value left out stands right behind the colon
                    value.start = value.end = max(self.text.find(":", key.end), key.end - 1) + 1
        node.end = end if end is not None else max((child.end for child in children[-2:]), default=node.end)


_PLAIN_WORDS = (
    (
        "expected alphabetic or numeric character, but found ':'",
        "this line is no YAML directive; files that OpenCV writes start with %YAML:1.0, and rosparam cannot load them",
    ),
    ("found character '\\t' that cannot start", "a tab stands here, and YAML wants blanks; replace the tab by blanks"),
    ("that cannot start any token", "a value cannot start with this character; put the value in quotes"),
    (
        "mapping values are not allowed here",
        "a second colon stands where no key can be; the indentation differs from the lines above, or the value needs quotes",
    ),
    ("could not find expected ':'", "a line before this place lacks its colon, or the blank behind it"),
    ("expected <block end>", "this line does not line up with the lines above it; give entries of one level the same indentation"),
    ("expected ',' or ']'", "a list that starts with [ lacks a comma or its ] here"),
    ("expected ',' or '}'", "a mapping that starts with { lacks a comma or its } here"),
    ("found unexpected end of stream", "a text in quotes is never closed"),
    ("found unexpected document separator", "a text in quotes is never closed before the next document starts"),
    ("found unknown escape character", "this backslash sequence is not known; in double quotes, write a backslash as two"),
    ("expected the node content", "a value is missing here"),
    ("sequence entries are not allowed here", 'a "- " cannot stand here; start the list on a line of its own'),
)


def _explain(error: Any, text: str) -> NoReturn:
    """Raise the YamlError for what the pure Python parser refused."""
    position = getattr(error, "position", None)
    if isinstance(position, int):
        raise YamlError(
            f"YAML does not allow the character U+{ord(text[position]):04X}, which stands here" if position < len(text) else "bad text",
            min(position, len(text)),
            "character",
        ) from None
    mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
    offset = min(mark.index if mark is not None else 0, len(text))
    problem = str(getattr(error, "problem", None) or error)[:200]
    start = _missing_blank(text, offset) if "could not find expected ':'" in problem else None
    if start is not None:
        raise YamlError(f"a blank lacks behind this colon (YAML says: {problem})", start, "colon") from None
    for sign, words in _PLAIN_WORDS:
        if sign in problem:
            raise YamlError(f"{words} (YAML says: {problem})", offset, "syntax") from None
    raise YamlError(f"this is not valid YAML (YAML says: {problem})", offset, "syntax") from None


def _missing_blank(text: str, offset: int) -> int | None:
    """Where ``key:value`` stands in the line of ``offset`` or the last one before it with anything in it: YAML notices it only there."""
    before = text[:offset].rstrip()
    for end in (offset, len(before)):
        start = text.rfind("\n", 0, end) + 1
        line = text[start : text.find("\n", end) + 1 or len(text)]
        if _COLON.match(line.strip()) is not None:
            return start + len(line) - len(line.lstrip())
    return None

"""YAML text to a tree of nodes with places, as PyYAML's pure Python parser reads it: that is the one roslaunch and launch use.

libyaml is some ten times faster and agrees with it on all but a few signs; where one of them is in the text, or libyaml refuses the text,
the pure Python parser decides. The tree is built from the parser's events, without recursion and within bounds; what a plain scalar is (a
number, a text …) the caller decides.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.yaml.refusals import COLON, YamlError, explain, too_deep

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

SCALAR, SEQUENCE, MAPPING = range(3)

STR, SEQ, MAP = "tag:yaml.org,2002:str", "tag:yaml.org,2002:seq", "tag:yaml.org,2002:map"

# Where the two parsers differ: line ends other than LF and CR, a byte order mark, characters that are not printable, directives, a
# comment right behind "|" or ">"; and outside comments tabs, tags, and "?" in brackets.
_DIFFERENT = late(r"[\0-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff\ufeff\ufffe\uffff]|^%|[|>][-+\w]*#", re.MULTILINE)
_DIFFERENT_OUTSIDE_COMMENTS = late(r"[\t!?]")
_COMMENT = late(r"^((?:[^\n\"'#]*[ \t])?)#[^\n]*", re.MULTILINE)


class YamlBeyond(Exception):
    """The text is beyond the bounds of its reader: nothing can be said about it. ``offset`` is where that shows."""

    def __init__(self, message: str, offset: int = 0) -> None:
        super().__init__(message)
        self.message = message
        self.offset = offset


Scalars = Callable[[str], str]
"""Tells the tag of a plain scalar."""


def yaml_1_1() -> Scalars:
    """The rules of YAML 1.1, as PyYAML has them (yaml.resolver.Resolver)."""
    from yaml.resolver import Resolver

    resolvers = Resolver.yaml_implicit_resolvers

    def tag_of(text: str) -> str:
        for tag, pattern in resolvers.get(text[:1], ()):
            if pattern.match(text):
                return str(tag)
        return STR

    return tag_of


class Reader(NamedTuple):
    """Who reads: ``name`` for messages, how plain ``scalars`` are tagged, and the bounds.

    ``pure``: PyYAML's pure Python parser has the last word, and reads a text of up to ``longest_pure`` characters; else libyaml has it.
    ``longest`` counts characters, ``deepest`` levels; ``written_out`` the scalars of the document with every alias written out, where a
    long text counts for several. ``tags`` are those that may be written; None: whatever is written stands in the tree.
    """

    name: str
    scalars: Callable[[], Scalars] = yaml_1_1
    pure: bool = True
    longest: int = 8_000_000
    longest_pure: int = 1_000_000
    deepest: int = 100
    written_out: int = 2_000_000
    tags: Collection[str] | None = None


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


def parse(text: str, reader: Reader) -> Tree:
    """The tree of a YAML text with a single document. Raises YamlError for what is no such thing, and YamlBeyond."""
    import yaml

    if len(text) > reader.longest:
        raise YamlBeyond(f"the YAML text is longer than {reader.longest} characters")
    fast = getattr(yaml, "__with_libyaml__", False)
    if fast and reader.pure and _agreed(text):
        try:
            return _Builder(yaml, yaml.CSafeLoader(text), text, reader).build()
        except (YamlError, yaml.YAMLError):
            pass  # the pure Python parser has the last word, and the better place
    if reader.pure and len(text) > reader.longest_pure:
        raise YamlBeyond(f"the YAML text is longer than {reader.longest_pure} characters")
    try:
        return _Builder(yaml, (yaml.SafeLoader if reader.pure or not fast else yaml.CSafeLoader)(text), text, reader).build()
    except yaml.YAMLError as error:
        if too_deep(error) is not None:
            return _Builder(yaml, yaml.SafeLoader(text), text, reader).build()  # says where it comes to be too deep
        raise explain(error, text, reader.name) from None


def _agreed(text: str) -> bool:
    """Whether both parsers read ``text`` alike, if both read it at all."""
    if _DIFFERENT.search(text) is not None:
        return False
    return _DIFFERENT_OUTSIDE_COMMENTS.search(text) is None or _DIFFERENT_OUTSIDE_COMMENTS.search(_COMMENT.sub(r"\1", text)) is None


class _Builder:
    """Turns the events of one parser into nodes."""

    __slots__ = ("anchors", "colons", "events", "parser", "reader", "scalars", "tags", "text")

    def __init__(self, yaml: Any, parser: Any, text: str, reader: Reader) -> None:
        self.events = yaml.events
        self.parser = parser
        self.text = text
        self.reader = reader
        self.scalars = reader.scalars()
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
                if len(stack) >= self.reader.deepest:
                    raise YamlBeyond(f"the YAML text is nested more than {self.reader.deepest} deep", event.start_mark.index)
                sequence = kind is events.SequenceStartEvent
                default = SEQ if sequence else MAP
                tag = default if event.tag is None or event.tag == "!" else self._written(event)
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
                f"a second YAML document starts here; {self.reader.name} loads files with one document only",
                event.start_mark.index,
                "documents",
            )
        return Tree(root, self.colons)

    def _scalar(self, event: Any) -> Node:
        value, tag = event.value, event.tag
        start, end = event.start_mark.index, event.end_mark.index
        if tag is None or tag == "!":
            if event.implicit[0]:
                tag = self.tags.get(value)
                if tag is None:
                    tag = self.tags[value] = self.scalars(value)
                if tag is STR and ":" in value and COLON.match(value):
                    self.colons.append((start, end))
            else:
                tag = STR
        else:
            tag = self._written(event)
        if event.style in ("|", ">"):
            end = start + len(self.text[start:end].rstrip())
        node = Node(SCALAR, tag, value, start, end)
        node.size = 1 + len(value) // 100
        if event.anchor is not None:
            self._new_anchor(event)
            self.anchors[event.anchor] = node
        return node

    def _written(self, event: Any) -> str:
        """A tag that is written, if it may be."""
        tags = self.reader.tags
        if tags is not None and event.tag not in tags:
            tag = event.tag[:60]  # %1b in it stands for a control character
            raise YamlError(f"the tag {tag if tag.isprintable() else repr(tag)} has no meaning here", event.start_mark.index, "tag")
        return str(event.tag)

    def _alias(self, event: Any) -> Node:
        if event.anchor not in self.anchors:
            raise YamlError(
                f"the alias *{event.anchor[:60]} refers to an anchor that is not set above it", event.start_mark.index, "anchor"
            )
        node = self.anchors[event.anchor]
        if node is None:
            raise YamlBeyond("a YAML value that contains itself is not looked into", event.start_mark.index)
        return node

    def _new_anchor(self, event: Any) -> None:
        if event.anchor in self.anchors:
            raise YamlError(f"the anchor &{event.anchor[:60]} is set a second time", event.start_mark.index, "anchor")
        self.anchors[event.anchor] = None

    def _close(self, node: Node, children: list[Node], end: int | None) -> None:
        for child in children:
            node.size += child.size
        if node.size > self.reader.written_out:
            raise YamlBeyond("the YAML text becomes too large when its aliases are written out", node.start)
        if node.kind == SEQUENCE:
            node.value = children
        else:
            node.value = list(zip(children[::2], children[1::2], strict=True))
            for key, value in node.value:
                if value.start == value.end:  # a value left out stands right behind the colon
                    value.start = value.end = max(self.text.find(":", key.end), key.end - 1) + 1
        node.end = end if end is not None else max((child.end for child in children[-2:]), default=node.end)

"""YAML with the line and column of everything, for files that a person writes and may get wrong.

A scalar keeps the text it was written as.
"""

from __future__ import annotations

import re
from bisect import bisect_right

from launchlint.errors import ConfigurationError
from launchlint.workspace.reading import read_bytes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import NoReturn

    from launchlint.yaml.refusals import YamlError
    from launchlint.yaml.tree import Node as Written
    from launchlint.yaml.tree import YamlBeyond

LARGEST_CONFIGURATION = 1 << 20
_DEEPEST = 32
_MOST_WRITTEN_OUT = 1_000_000
_LONGEST_SHOWN = 80

_TAG = "tag:yaml.org,2002:"
_TAGS = frozenset(_TAG + each for each in ("str", "int", "float", "bool", "null", "seq", "map"))

SCALAR, SEQUENCE, MAPPING = _KINDS = ("scalar", "sequence", "mapping")


class Node:
    """A scalar, sequence or mapping and where it starts (line and column from 1).

    ``text`` is a scalar's text as written (quotes and escapes resolved), ``type`` one of str, bool, int, float, null by the rules of
    YAML 1.1, and ``None`` for what is no scalar. ``items`` are a sequence's; ``pairs`` a mapping's keys, each with its value.
    """

    __slots__ = ("column", "items", "kind", "line", "pairs", "text", "type")

    def __init__(self, kind: str, line: int, column: int) -> None:
        self.kind = kind
        self.line = line
        self.column = column
        self.text = ""
        self.type: str | None = None
        self.items: list[Node] = []
        self.pairs: list[tuple[Node, Node]] = []

    def describe(self) -> str:
        """What it is, in a word or two."""
        if self.kind == SCALAR:
            words = {"str": "a text", "bool": "true or false", "int": "a number", "float": "a number", "null": "empty"}
            return words.get(self.type or "", "a text")
        return "a list" if self.kind == SEQUENCE else "a mapping"


class Document:
    """One YAML file: its path as people see it, and the root node (``None`` where the file is empty)."""

    __slots__ = ("path", "root")

    def __init__(self, path: str, root: Node | None) -> None:
        self.path = path
        self.root = root

    def fail(self, node: Node, message: str) -> NoReturn:
        """Raise a ConfigurationError for ``node``: path, line and column, then ``message``."""
        raise ConfigurationError(f"{self.path}:{node.line}:{node.column}: {message}")

    def pairs(self, node: Node, what: str) -> list[tuple[str, Node, Node]]:
        """Keys and values of a mapping: each key as text and as node; ``what`` names the thing in the error if it is no mapping.

        Raises:
            ConfigurationError: it is no mapping, or a key is no plain text, or occurs twice.
        """
        if node.kind != MAPPING:
            self.fail(node, f"{what} must be a mapping (name: value), not {node.describe()}")
        first: dict[str, Node] = {}
        found: list[tuple[str, Node, Node]] = []
        for key, value in node.pairs:
            if key.kind != SCALAR or key.type == "null":
                self.fail(key, f"a key of {what} must be a plain text, not {key.describe()}")
            before = first.setdefault(key.text, key)
            if before is not key:
                self.fail(key, f"{shown(key.text)} is given twice, so one of the two would be lost; the first stands in line {before.line}")
            found.append((key.text, key, value))
        return found

    def text(self, node: Node, what: str) -> str:
        """The text of a scalar as the user wrote it, ``true`` and ``1.0`` included.

        Raises:
            ConfigurationError: it is no scalar, or empty.
        """
        if node.kind != SCALAR:
            self.fail(node, f"{what} must be a text, not {node.describe()}")
        if node.type == "null":
            self.fail(node, f"{what} has no value; write one, or '' for an empty text")
        return node.text

    def texts(self, node: Node, what: str) -> list[tuple[str, Node]]:
        """The texts of a list; a single text stands for a list of one."""
        if node.kind == MAPPING:
            self.fail(node, f"{what} must be a list of texts, not a mapping")
        if node.kind == SCALAR:
            return [] if node.type == "null" else [(node.text, node)]
        return [(self.text(each, f"each item of {what}"), each) for each in node.items]

    def unknown(self, key: Node, known: Mapping[str, object] | frozenset[str], what: str) -> NoReturn:
        """Raise the error for a key that does not exist, with the nearest one that does."""
        from launchlint.spelling import did_you_mean

        hint = did_you_mean(key.text, known) or f"it has: {', '.join(sorted(known))}"
        self.fail(key, f"{what} has no key {shown(key.text)}, and one that is misspelled would have no effect; {hint}")


def shown(text: str) -> str:
    """``text`` for a message: short, and with whatever is not printable escaped, so that it cannot play tricks on a terminal."""
    short = text if len(text) <= _LONGEST_SHOWN else text[: _LONGEST_SHOWN - 1] + "…"
    return short if short.isprintable() and short.strip() else repr(short)


def read_document(path: str, largest: int = LARGEST_CONFIGURATION) -> Document:
    """Read a YAML file of at most ``largest`` bytes with at most one document.

    Raises:
        ConfigurationError: it cannot be read, is no YAML, or is nested or aliased beyond what a person writes.
    """
    try:
        data = read_bytes(path, largest)
    except OSError as error:
        raise ConfigurationError(f"{path}: it cannot be read: {error.strerror or error}") from error
    return parse_document(data, path)


def parse_document(data: bytes, path: str) -> Document:
    """As :func:`read_document`, for content that has been read already."""
    from launchlint.yaml.refusals import YamlError
    from launchlint.yaml.tree import Reader, YamlBeyond, parse

    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        before = data[: error.start]
        line, column = before.count(b"\n") + 1, len(before) - before.rfind(b"\n")
        raise ConfigurationError(f"{path}:{line}:{column}: this is not UTF-8 text; save the file in UTF-8") from error
    try:
        tree = parse(text, Reader("launchlint", pure=False, deepest=_DEEPEST, written_out=_MOST_WRITTEN_OUT, tags=_TAGS))
    except (YamlError, YamlBeyond) as error:
        line, column = _position(text, error.offset)
        raise ConfigurationError(f"{path}:{line}:{column}: {_refused(error)}") from error
    root = None if tree.root is None else _Nodes(text).of(tree.root)
    return Document(path, None if root is None or (root.kind == SCALAR and root.type == "null") else root)


def _refused(error: YamlError | YamlBeyond) -> str:
    """What a person who wrote the file is told."""
    kind = getattr(error, "kind", "bounds")
    if kind == "documents":
        return "a second document starts here, and only one is read; remove the --- line"
    if kind == "tag":
        return f"{error.message}; remove it"
    if kind in ("bounds", "anchor"):
        return error.message
    return f"this is not valid YAML: {getattr(error, 'problem', '') or error.message}"


def _position(text: str, offset: int) -> tuple[int, int]:
    return text.count("\n", 0, offset) + 1, offset - text.rfind("\n", 0, offset)


class _Nodes:
    """The nodes of a tree with their lines; what an alias stands for is one node."""

    def __init__(self, text: str) -> None:
        self._starts = [0, *(match.end() for match in re.finditer("\n", text))]
        self._made: dict[int, Node] = {}

    def of(self, written: Written) -> Node:
        """``written`` and all that is in it; a tree is no deeper than :data:`_DEEPEST`."""
        known = self._made.get(id(written))
        if known is not None:
            return known
        line = bisect_right(self._starts, written.start)
        node = Node(_KINDS[written.kind], line, written.start - self._starts[line - 1] + 1)
        if node.kind == SCALAR:
            node.text, node.type = written.value, written.tag.rpartition(":")[2]
        elif node.kind == SEQUENCE:
            node.items = [self.of(each) for each in written.value]
        else:
            node.pairs = [(self.of(key), self.of(value)) for key, value in written.value]
        self._made[id(written)] = node
        return node

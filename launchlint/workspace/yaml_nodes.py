"""YAML with the line and column of everything, for files that a person writes and may get wrong.

Built from the parser's events, not from its loader: so depth, size and aliases are bounded before anything grows, and a scalar keeps the
text it was written as.
"""

from __future__ import annotations

from launchlint.errors import ConfigurationError
from launchlint.workspace.reading import read_bytes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any, NoReturn

LARGEST_CONFIGURATION = 1 << 20
_DEEPEST = 32
_MOST_ALIASES = 100
_MOST_NODES = 1_000_000
_LONGEST_SHOWN = 80

_TAG = "tag:yaml.org,2002:"
_TAGS = frozenset((None, "!", *(_TAG + each for each in ("str", "int", "float", "bool", "null", "seq", "map"))))

SCALAR, SEQUENCE, MAPPING = "scalar", "sequence", "mapping"


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
    import yaml

    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        before = data[: error.start]
        line, column = before.count(b"\n") + 1, len(before) - before.rfind(b"\n")
        raise ConfigurationError(f"{path}:{line}:{column}: this is not UTF-8 text; save the file in UTF-8") from error
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)(text)
    try:
        return Document(path, _Builder(loader, path).document())
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = f"{path}:{mark.line + 1}:{mark.column + 1}" if mark is not None else path
        problem = getattr(error, "problem", None) or getattr(error, "reason", None) or "it cannot be parsed"
        raise ConfigurationError(f"{where}: this is not valid YAML: {problem}") from error
    finally:
        loader.dispose()


class _Builder:
    """Events → nodes, within bounds."""

    __slots__ = ("_aliases", "_anchors", "_count", "_loader", "_path", "_yaml")

    def __init__(self, loader: Any, path: str) -> None:
        import yaml

        self._yaml = yaml
        self._loader = loader
        self._path = path
        self._anchors: dict[str, tuple[Node, int]] = {}
        self._aliases = 0
        self._count = 0

    def document(self) -> Node | None:
        yaml, loader = self._yaml, self._loader
        loader.get_event()  # the start of the stream
        event = loader.get_event()
        if isinstance(event, yaml.StreamEndEvent):
            return None
        root = self._node(loader.get_event(), 0)
        loader.get_event()  # the end of the document
        event = loader.get_event()
        if not isinstance(event, yaml.StreamEndEvent):
            self._refuse(event, "a second document starts here, and only one is read; remove the --- line")
        return None if root.kind == SCALAR and root.type == "null" else root

    def _node(self, event: Any, depth: int) -> Node:
        yaml, loader = self._yaml, self._loader
        self._count += 1
        if depth > _DEEPEST:
            self._refuse(event, f"this is nested more than {_DEEPEST} levels deep")
        if self._count > _MOST_NODES:
            self._refuse(event, f"there are more than {_MOST_NODES} values")
        if isinstance(event, yaml.AliasEvent):
            return self._alias(event)
        before = self._count
        if event.tag not in _TAGS:
            self._refuse(event, f"the tag {shown(event.tag)} has no meaning here; remove it")
        kind = SCALAR if isinstance(event, yaml.ScalarEvent) else SEQUENCE if isinstance(event, yaml.SequenceStartEvent) else MAPPING
        mark = event.start_mark
        node = Node(kind, mark.line + 1, mark.column + 1)
        if isinstance(event, yaml.ScalarEvent):
            node.text = event.value
            tag = event.tag
            if tag is None or tag == "!":
                tag = loader.resolve(yaml.ScalarNode, event.value, event.implicit)
            node.type = tag.rpartition(":")[2]
        elif isinstance(event, yaml.SequenceStartEvent):
            while not isinstance(inner := loader.get_event(), yaml.SequenceEndEvent):
                node.items.append(self._node(inner, depth + 1))
        else:
            while not isinstance(inner := loader.get_event(), yaml.MappingEndEvent):
                key = self._node(inner, depth + 1)
                node.pairs.append((key, self._node(loader.get_event(), depth + 1)))
        anchor = event.anchor
        if anchor is not None:
            self._anchors[anchor] = (node, self._count - before + 1)
        return node

    def _alias(self, event: Any) -> Node:
        """The anchored node again; it counts as large as it is, so that aliases of aliases cannot grow without bound."""
        self._aliases += 1
        node, size = self._anchors.get(event.anchor, (Node(SCALAR, 0, 0), 0))
        if size == 0:
            self._refuse(event, f"there is no anchor &{event.anchor} before this")
        self._count += size
        if self._aliases > _MOST_ALIASES or self._count > _MOST_NODES:
            self._refuse(event, f"there are too many aliases (more than {_MOST_ALIASES}, or of too large parts)")
        return node

    def _refuse(self, event: Any, message: str) -> NoReturn:
        mark = event.start_mark
        raise ConfigurationError(f"{self._path}:{mark.line + 1}:{mark.column + 1}: {message}")

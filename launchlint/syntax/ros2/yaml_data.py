"""YAML text to Python values with places, as PyYAML's ``safe_load`` makes them: mappings keep the last of equal keys.

Only what a launch file is made of gets a value of its own; dates, binary data and the like are :class:`Other`.
"""

from __future__ import annotations

from launchlint.named_tuple import NamedTuple
from launchlint.source import Span
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import MAP, MAPPING, SCALAR, SEQ, SEQUENCE, STR, Node, Reader, YamlBeyond, parse

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    from launchlint.syntax.ros2.values import Scalar

_PREFIX = "tag:yaml.org,2002:"
_MERGE, _VALUE = _PREFIX + "merge", _PREFIX + "value"
_OTHER = {
    _PREFIX + name: words
    for name, words in (("timestamp", "a date"), ("binary", "binary data"), ("set", "a set"), ("omap", "pairs"), ("pairs", "pairs"))
}
_BOOLEANS = {"yes": True, "no": False, "true": True, "false": False, "on": True, "off": False}
_MOST_PAIRS = 200_000


class Other(NamedTuple):
    """A value that launch takes nowhere; ``words`` say what it is."""

    words: str


class Item(NamedTuple):
    """One value: ``data`` is a scalar, None, an :class:`Other`, a list of items or the entries of a mapping."""

    data: Scalar | Other | list[Item] | dict[str, Entry] | None
    span: Span

    @property
    def words(self) -> str:
        """What it is, in words."""
        data = self.data
        if isinstance(data, Other):
            return data.words
        return next((words for kind, words in _KINDS if isinstance(data, kind)), "nothing")


class Entry(NamedTuple):
    """One key of a mapping, and its value."""

    key: Span
    value: Item


Data: TypeAlias = "Item | None"

_KINDS: tuple[tuple[type, str], ...] = (
    (str, "a text"),
    (bool, "a boolean"),
    (int, "an integer"),
    (float, "a number"),
    (list, "a list"),
    (dict, "a mapping"),
)


class Twice(NamedTuple):
    """A key that stands twice in one mapping: where the ``last`` is, which counts, and the one before it; ``same``: with the same value."""

    key: str
    last: Span
    first: Span
    same: bool


def load(text: str, twice: list[Twice]) -> Data:
    """What stands in ``text``; None for nothing. ``twice`` is filled.

    Raises:
        YamlError: launch cannot load it. YamlBeyond: it is beyond the bounds of the reader.
    """
    root = parse(text, Reader("ros2 launch")).root
    return None if root is None else _Maker(twice).item(root)


class _Maker:
    __slots__ = ("_made", "_pairs", "_twice")

    def __init__(self, twice: list[Twice]) -> None:
        self._twice = twice
        self._made: dict[int, Item] = {}
        self._pairs = 0

    def item(self, node: Node) -> Item:
        known = self._made.get(id(node))
        if known is None:
            known = self._made[id(node)] = self._item(node)
        return known

    def _item(self, node: Node) -> Item:
        span = Span(node.start, node.end)
        if node.kind == SCALAR:
            return Item(_scalar(node), span)
        if node.kind == SEQUENCE and node.tag == SEQ:
            return Item([self.item(each) for each in node.value], span)
        if node.kind == MAPPING and node.tag == MAP:
            return Item(self._mapping(node), span)
        return Item(_other(node), span)

    def _mapping(self, node: Node) -> dict[str, Entry]:
        found: dict[str, Entry] = {}
        for key, value in self._flattened(node):
            if key.kind != SCALAR:
                raise YamlError("a list or mapping cannot be used as a key", key.start, "key")
            _scalar(key)
            # A key that is no text is none that launch reads; what it looks like is enough to tell of it.
            found.pop(key.value, None)
            found[key.value if key.tag == STR or key.tag == _VALUE else f"{key.value}"] = Entry(Span(key.start, key.end), self.item(value))
        return found

    def _note(self, before: tuple[Node, Node] | None, key: Node, value: Node) -> None:
        if before is not None:
            first, lost = before
            same = lost.kind == value.kind == SCALAR and lost.value == value.value
            self._twice.append(Twice(key.value, Span(key.start, key.end), Span(first.start, first.end), same))

    def _flattened(self, node: Node) -> list[tuple[Node, Node]]:
        """The pairs of a mapping, those of merge keys first."""
        if node.flat:
            return list(node.value)
        node.flat = True
        merged: list[tuple[Node, Node]] = []
        own: list[tuple[Node, Node]] = []
        known: dict[str, tuple[Node, Node]] = {}
        for key, value in node.value:
            if key.tag != _MERGE:
                own.append((key, value))
                if key.kind == SCALAR:
                    self._note(known.get(key.value), key, value)
                    known[key.value] = (key, value)
                continue
            for source in _sources(value):
                pairs = self._flattened(source)
                self._pairs += len(pairs)
                if self._pairs > _MOST_PAIRS:
                    raise YamlBeyond(f"the YAML text merges more than {_MOST_PAIRS} entries", key.start)
                merged.extend(pairs)
        node.value = merged + own
        return merged + own


def _sources(value: Node) -> list[Node]:
    """The mappings behind ``<<``, the one that wins last."""
    sources = list(reversed(value.value)) if value.kind == SEQUENCE else [value]
    for source in sources:
        if source.kind != MAPPING:
            raise YamlError("<< takes a mapping or a list of mappings, and this is none", source.start, "merge")
    return sources


def _scalar(node: Node) -> Scalar | Other | None:
    tag, text = node.tag, node.value
    if tag == STR:
        return str(text)
    if tag == _PREFIX + "null":
        return None
    if tag == _PREFIX + "bool" and text.lower() in _BOOLEANS:
        return _BOOLEANS[text.lower()]
    if tag == _PREFIX + "int" and text.isdecimal() and text.isascii() and len(text) < 4_000 and (text[0] != "0" or text == "0"):
        return int(text)
    if tag == _PREFIX + "float" or tag == _PREFIX + "int":
        return _number(node)
    return _other(node)


def _number(node: Node) -> Scalar:
    import yaml

    maker = yaml.constructor.SafeConstructor()
    scalar = yaml.ScalarNode(node.tag, node.value)
    try:
        number: Scalar = maker.construct_yaml_int(scalar) if node.tag.endswith("int") else maker.construct_yaml_float(scalar)
    except (ValueError, IndexError) as error:
        raise YamlError(f"this is no number (Python says: {str(error)[:200]})", node.start, "value") from None
    return number


def _other(node: Node) -> Other:
    words = _OTHER.get(node.tag)
    if words is None:
        shown = node.tag[:60] if node.tag.isprintable() else "that is written here"
        raise YamlError(f"the YAML tag {shown} is not one that launch knows", node.start, "tag")
    return Other(words)

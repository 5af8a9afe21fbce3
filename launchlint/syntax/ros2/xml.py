"""Entities of a launch file in XML."""

from __future__ import annotations

from launchlint.source import Origin, Place
from launchlint.syntax.ros2.entity import Entity, Value
from launchlint.syntax.ros2.problems import WrongValue
from launchlint.syntax.ros2.values import Misfit, converted, list_converted
from launchlint.syntax.ros2.words import EXPECTED
from launchlint.syntax.ros2.written import InXml, Written

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.problem import Problem
    from launchlint.syntax.tree import Attribute, Document, Element

_SEPARATOR = "-sep"


class XmlEntity(Entity):
    """An element. ``space`` is the default namespace around it (``xmlns``): names in one are none that launch knows."""

    __slots__ = ("_digits_are_flags", "_document", "_read", "_read_tags", "_space", "element")

    def __init__(self, element: Element, document: Document, digits_are_flags: bool, space: str = "") -> None:
        self.element = element
        self._document = document
        self._digits_are_flags = digits_are_flags
        self._space = element.attributes["xmlns"].value if "xmlns" in element.attributes else space
        self.tag = f"{{{self._space}}}{element.tag}" if self._space and ":" not in element.tag else element.tag
        self._read: set[str] = set()
        self._read_tags: set[str] | None = set()

    def _place(self, attribute: Attribute) -> Place:
        return attribute.place(self._document.source)

    @property
    def name_place(self) -> Place:
        """The name in the start tag."""
        return self._document.place(self.element.name_span)

    @property
    def place(self) -> Place:
        """The start tag."""
        return self._document.place(self.element.start_span)

    @property
    def given(self) -> tuple[str, ...]:
        """The attributes that are no declarations of namespaces."""
        return tuple(name for name in self.element.attributes if name != "xmlns" and not name.startswith("xmlns:"))

    def attribute_place(self, name: str) -> Place:
        """The name of the attribute."""
        return self._document.place(self.element.attributes[name].name_span)

    def has(self, name: str) -> bool:
        """Whether it is written."""
        return name in self.element.attributes

    def value(self, name: str, wanted: str, problems: list[Problem]) -> Value | None:
        """The attribute, converted."""
        attribute = self.element.attributes.get(name)
        if attribute is None:
            return None
        self._read.add(name)
        separator = self.element.attributes.get(name + _SEPARATOR)
        written = InXml(attribute, self._document.source)
        try:
            if separator is not None:
                self._read.add(separator.name)
                return self._split(written, separator.value, wanted)
            plain = converted(attribute.value, wanted, digits_are_flags=self._digits_are_flags)
        except Misfit:
            problems.append(
                WrongValue(
                    origin=Origin(written.place),
                    refused=True,
                    tag=self.tag,
                    attribute=name,
                    value=attribute.value,
                    expected=EXPECTED[wanted],
                )
            )
            return None
        if isinstance(plain, list):
            return Value(plain, written.place, None, _items(written, plain))
        if isinstance(plain, str):
            return Value(plain, written.place, written if plain == written.text else written.part(plain, written.text.find(plain)))
        return Value(plain, written.place)

    def _split(self, written: Written, separator: str, wanted: str) -> Value:
        if not separator:
            raise Misfit(separator)
        texts = written.text.split(separator)
        plain = list_converted(texts, wanted, digits_are_flags=self._digits_are_flags)
        items: list[Written | None] = []
        start = 0
        for text, each in zip(texts, plain, strict=True):
            items.append(written.part(each, start + max(text.find(each), 0)) if isinstance(each, str) else None)
            start += len(text) + len(separator)
        return Value(list(plain), written.place, None, tuple(items))

    def named(self, name: str, problems: list[Problem]) -> list[Entity] | None:
        """The inner elements with this name."""
        found: list[Entity] = [self._child(each) for each in self.element.children if each.tag == name]
        found = [each for each in found if each.tag == name]
        if not found:
            return None
        if self._read_tags is not None:
            self._read_tags.add(name)
        return found

    def _child(self, element: Element) -> Entity:
        return XmlEntity(element, self._document, self._digits_are_flags, self._space)

    def children(self, problems: list[Problem]) -> list[Entity]:
        """All inner elements."""
        self._read_tags = None
        return [self._child(each) for each in self.element.children]

    def unread(self) -> tuple[list[Entity], list[str]]:
        """What nobody asked for."""
        tags = self._read_tags
        children = [] if tags is None else [child for each in self.element.children if (child := self._child(each)).tag not in tags]
        return children, [name for name in self.given if name not in self._read]


def _items(written: Written, plain: list[bool | int | float | str]) -> tuple[Written | None, ...]:
    """The texts of a list that stands in one value, where they are found in it, one after the other."""
    items: list[Written | None] = []
    position = 0
    for each in plain:
        if not isinstance(each, str):
            items.append(None)
            continue
        start = written.text.find(each, position)
        items.append(written.part(each, start))
        position = max(position, start + len(each))
    return tuple(items)

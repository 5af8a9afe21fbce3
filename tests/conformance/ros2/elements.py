"""Where the tags and attributes of a launch file stand, XML or YAML: for a mutator, which must not ask launchlint that."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple
from xml.parsers import expat
from xml.sax.saxutils import escape

import yaml

_ATTRIBUTE = re.compile(r"""\s+([\w:.-]+)\s*=\s*("[^"]*"|'[^']*')""")


class Attribute(NamedTuple):
    """``value`` as the file means it; ``name_at``, ``value_at`` and ``at`` (both, with the blanks or the comma around) as offsets."""

    value: str
    name_at: tuple[int, int]
    value_at: tuple[int, int]
    at: tuple[int, int]


@dataclass
class Element:
    """One tag with its attributes. ``at``: all of it; ``name_at``: the name of its tag; ``end_name_at``: that of its end tag."""

    tag: str
    parent: Element | None
    name_at: tuple[int, int]
    at: tuple[int, int]
    attributes: dict[str, Attribute] = field(default_factory=dict)
    children: list[Element] = field(default_factory=list)
    head_end: int = 0
    end_name_at: tuple[int, int] | None = None

    @property
    def always(self) -> bool:
        """Whether neither it nor anything around has a condition."""
        around = True if self.parent is None else self.parent.always
        return around and not {"if", "unless"} & self.attributes.keys()


class Document(NamedTuple):
    """A launch file with all its elements; the first is the root."""

    text: str
    elements: list[Element]
    yaml: bool

    def quoted(self, value: str) -> str:
        """``value`` as it is written between attributes of this file, quotes and all."""
        return json.dumps(value, ensure_ascii=False) if self.yaml else '"' + escape(value, {'"': "&quot;"}) + '"'

    def line(self, offset: int) -> int:
        """The line of an offset, the first being 1."""
        return self.text.count("\n", 0, offset) + 1


def read(text: str, name: str) -> Document:
    """The elements of a file that launch can read. Raises ValueError for others."""
    try:
        return _yaml(text) if name.endswith((".yaml", ".yml")) else _xml(text)
    except (expat.ExpatError, yaml.YAMLError, AttributeError, TypeError) as error:
        raise ValueError(str(error)) from error


def _xml(text: str) -> Document:
    parser = expat.ParserCreate("utf-8")
    data = text.encode("utf-8")
    stack: list[Element] = []
    found: list[Element] = []

    def here() -> int:
        return len(data[: parser.CurrentByteIndex].decode("utf-8"))

    def start(tag: str, _: dict[str, str]) -> None:
        at = here()
        element = Element(tag, stack[-1] if stack else None, (at + 1, at + 1 + len(tag)), (at, at))
        cursor = at + 1 + len(tag)
        while match := _ATTRIBUTE.match(text, cursor):
            value = (
                match[2][1:-1].replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", '"').replace("&apos;", "'").replace("&amp;", "&")
            )
            element.attributes[match[1]] = Attribute(value, match.span(1), match.span(2), match.span())
            cursor = match.end()
        element.head_end = cursor
        if stack:
            stack[-1].children.append(element)
        stack.append(element)
        found.append(element)

    def end(tag: str) -> None:
        element, at = stack.pop(), here()
        if text.startswith("</", at):
            element.end_name_at = (at + 2, at + 2 + len(tag))
            element.at = (element.at[0], text.index(">", at) + 1)
        else:
            element.at = (element.at[0], text.index("/>", element.head_end) + 2)

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.Parse(data, True)
    return Document(text, found, yaml=False)


def _yaml(text: str) -> Document:
    root = yaml.compose(text)
    found: list[Element] = []
    (key, value), *_ = root.value
    top = Element("launch", None, _span(key), (key.start_mark.index, len(text.rstrip()) + 1))
    found.append(top)
    found += _actions(text, value, top)
    return Document(text, found, yaml=True)


def _span(node: yaml.Node) -> tuple[int, int]:
    return node.start_mark.index, node.end_mark.index


def _actions(text: str, node: yaml.Node, parent: Element) -> Iterator[Element]:
    for item in node.value:
        (key, value), *_ = item.value
        yield from _element(text, key.value, item, key, value, parent)


def _element(text: str, tag: str, item: yaml.Node, key: yaml.Node, value: yaml.Node, parent: Element) -> Iterator[Element]:
    last = len(text[: item.end_mark.index].rstrip())
    dash = text.rindex("-", 0, item.start_mark.index + 1)
    element = Element(tag, parent, _span(key), (dash, last))
    parent.children.append(element)
    yield element
    if isinstance(value, yaml.SequenceNode):
        yield from _actions(text, value, element)
        return
    for name, inner in value.value:
        if isinstance(inner, yaml.ScalarNode):
            element.attributes[name.value] = Attribute(inner.value, _span(name), _span(inner), _pair(text, name, inner))
        elif name.value == "children":
            yield from _actions(text, inner, element)
        elif isinstance(inner, yaml.SequenceNode) and inner.value and isinstance(inner.value[0], yaml.ScalarNode):
            written = text[slice(*_span(inner))]
            element.attributes[name.value] = Attribute(written, _span(name), _span(inner), _pair(text, name, inner))
        elif isinstance(inner, yaml.SequenceNode):
            for each in inner.value:
                yield from _element(text, name.value, each, each.value[0][0], each, element)


def _pair(text: str, name: yaml.Node, value: yaml.Node) -> tuple[int, int]:
    """A key with its value: with the rest of its line, or in ``{…}`` with one comma."""
    start, end = name.start_mark.index, value.end_mark.index
    line = text.rfind("\n", 0, start) + 1
    if text[line:start].isspace() or line == start:
        after = text.find("\n", max(end - 1, start))
        return (line, len(text) if after < 0 else after + 1)
    if match := re.match(r"\s*,\s*", text[end:]):
        return start, end + match.end()
    before = len(text[:start].rstrip(" ,"))
    return before, end

"""Launch files as trees, written as XML or YAML: for the generator of workspaces, which makes them, and the shrinker, which cuts them."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any
from xml.sax.saxutils import escape

LISTED = ("param", "remap", "env", "composable_node", "extra_arg", "keep", "choice")
"""Children that are lists of mappings under their name in YAML; ``arg`` is one in an include."""


@dataclass(frozen=True)
class Tag:
    """One tag; a value of an attribute that is no text is written as it is in YAML, and as its text in XML."""

    name: str
    attributes: dict[str, Any] = field(default_factory=dict)
    children: tuple[Tag, ...] = ()

    def smaller(self) -> Iterator[Tag]:
        """This tag with one thing less, the largest cuts first."""
        for index, child in enumerate(self.children):
            yield replace(self, children=(*self.children[:index], *self.children[index + 1 :]))
            if child.name == "group":
                yield replace(self, children=(*self.children[:index], *child.children, *self.children[index + 1 :]))
        for name in self.attributes:
            yield replace(self, attributes={key: value for key, value in self.attributes.items() if key != name})
        for index, child in enumerate(self.children):
            for less in child.smaller():
                yield replace(self, children=(*self.children[:index], less, *self.children[index + 1 :]))
        for name, value in self.attributes.items():
            for shorter in _shorter(value):
                yield replace(self, attributes={**self.attributes, name: shorter})


def _shorter(value: Any) -> Iterator[str]:
    if isinstance(value, str) and len(value) > 1:
        yield "x"
        if value.startswith("$(") and value.endswith(")"):
            yield value[value.find(" ") + 1 : -1]
        half = len(value) // 2
        for cut in (value[:half], value[half:]):
            if cut.count("(") == cut.count(")"):
                yield cut


def as_xml(tag: Tag, depth: int = 0) -> str:
    """The tag as XML."""
    blanks = "  " * depth
    attributes = "".join(f" {name}={_quoted(value)}" for name, value in tag.attributes.items())
    if not tag.children:
        return f"{blanks}<{tag.name}{attributes}/>\n"
    inner = "".join(as_xml(child, depth + 1) for child in tag.children)
    return f"{blanks}<{tag.name}{attributes}>\n{inner}{blanks}</{tag.name}>\n"


def _quoted(value: Any) -> str:
    text = value if isinstance(value, str) else json.dumps(value)
    return '"' + escape(text, {'"': "&quot;", "\n": "&#10;", "\t": "&#9;"}) + '"'


def as_yaml(tag: Tag) -> str:
    """A whole ``launch`` as YAML: one line for each action, which is JSON."""
    if not tag.children:
        return "launch: []\n"
    return "launch:\n" + "".join(f"- {child.name}: {json.dumps(_mapping(child), ensure_ascii=False)}\n" for child in tag.children)


def _mapping(tag: Tag) -> Any:
    found: dict[str, Any] = dict(tag.attributes)
    for child in tag.children:
        if child.name in LISTED or (child.name == "arg" and tag.name == "include"):
            found.setdefault(child.name, []).append(_mapping(child))
        else:
            found.setdefault("children", []).append({child.name: _mapping(child)})
    if tag.name == "group" and set(found) == {"children"}:
        return found["children"]
    return found

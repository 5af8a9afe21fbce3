"""A library as text: keys in the order of the format, names sorted, one interface entry on a line, so that it reads and diffs well."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping

from launchlint.library.format import INTERFACES, INTERFACES_2, shape_of
from launchlint.library.shapes import Choice, Entries, Items, Keys, Rule, Shape

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


_ENTRIES = (*INTERFACES.values(), *INTERFACES_2.values())
"""The shapes that get one line."""


def canonical(document: Mapping[str, Any]) -> str:
    """The text of a (validated) library: the same text for the same library, with a newline at its end."""
    return "\n".join(_readable(line) for line in "".join(_lines(shape_of(document), document, 0)).split("\n")) + "\n"


def _readable(line: str) -> str:
    """A line of JSON with every character that nobody can see as an escape: no terminal obeys it, no reviewer overlooks it."""
    if line.isprintable():
        return line
    return "".join(character if character.isprintable() else json.dumps(character)[1:-1] for character in line)


def _lines(shape: Shape, value: Any, depth: int) -> Iterator[str]:
    if isinstance(shape, Choice):
        shape = shape.of(value)
    if isinstance(shape, Keys) and _is_broad(shape):
        items = [(key, shape.keys[key], value[key]) for key in shape.keys if key in value]
    elif isinstance(shape, Entries) and isinstance(shape.each, (Keys, Choice)):
        items = [(key, shape.each, value[key]) for key in sorted(value)]
    elif isinstance(shape, Items) and isinstance(shape.each, Keys):
        yield from _bracketed("[", "]", [_compact(shape.each, item) for item in _ordered(shape.each, value)], depth)
        return
    else:
        yield _compact(shape, value)
        return
    parts = [f"{json.dumps(key, ensure_ascii=False)}: {''.join(_lines(inner, item, depth + 1))}" for key, inner, item in items]
    yield from _bracketed("{", "}", parts, depth)


def _is_broad(shape: Keys) -> bool:
    """Whether each of its keys gets a line of its own: those that hold something larger than a word."""
    return any(isinstance(inner, (Items, Entries)) for inner in shape.keys.values()) and shape not in _ENTRIES


def _bracketed(opening: str, closing: str, parts: list[str], depth: int) -> Iterator[str]:
    if not parts:
        yield opening + closing
        return
    yield f"{opening}\n"
    blanks = " " * (depth + 1)
    yield ",\n".join(blanks + part for part in parts)
    yield f"\n{' ' * depth}{closing}"


def _ordered(shape: Keys, items: list[Any]) -> list[Any]:
    if shape in _ENTRIES:
        return sorted(items, key=lambda item: (item["name"], item.get("role", ""), item.get("node", ""), json.dumps(item, sort_keys=True)))
    return sorted(items, key=lambda item: json.dumps(item, sort_keys=True))


def _compact(shape: Shape, value: Any) -> str:
    return json.dumps(_in_order(shape, value), ensure_ascii=False)


def _in_order(shape: Shape, value: Any) -> Any:
    if isinstance(shape, Keys):
        return {key: _in_order(shape.keys[key], value[key]) for key in shape.keys if key in value}
    if isinstance(shape, Items):
        return [_in_order(shape.each, item) for item in value]
    if isinstance(shape, Entries):
        return {key: _in_order(shape.each, value[key]) for key in sorted(value)}
    return _sorted(value, _GRAMMAR if isinstance(shape, Rule) else ())


_GRAMMAR = ("not", "all", "any", "text", "args", "words", "param", "arg", "option", "remap", "is", "in", "set", "default")
"""The keys of conditions and of ``each``, in the order in which they are read."""


def _sorted(value: Any, first: tuple[str, ...]) -> Any:
    """A plain JSON value with the keys of its mappings sorted, those of ``first`` first."""
    if isinstance(value, dict):
        return {
            key: _sorted(value[key], first)
            for key in sorted(value, key=lambda key: (first.index(key) if key in first else len(first), key))
        }
    return [_sorted(item, first) for item in value] if isinstance(value, list) else value

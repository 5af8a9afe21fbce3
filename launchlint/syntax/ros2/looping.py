"""``ForLoop`` and ``ForEach``: how often they go round, and with which values.

Source: ``launch.actions.for_loop`` of launch 3.8, which came with Kilted.
"""

from __future__ import annotations

from typing import Any

from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import Reader, YamlBeyond
from launchlint.yaml.values import load

FOR_LOOP, FOR_EACH = "ForLoop", "ForEach"
FOR_VARIABLE, INDEX_OF_LOOP = "for-var", "index"
"""The substitutions that have the values of a turn."""
INDEX = "i"
"""What a ForLoop calls its number."""
MOST_TURNS = 10_000
"""Turns of one loop that are followed; no robot has so many parts."""
_SEPARATOR = ";"
_LONGEST = 100_000
_YAML = Reader("launch", longest=_LONGEST)


class Refused(Exception):
    """Launch stops at the text, with an exception of the class ``error`` that says ``what``."""

    def __init__(self, error: str, what: str) -> None:
        super().__init__(error, what)
        self.error = error
        self.what = what


class TooMany(Exception):
    """It is too much to be followed."""


def turns(kind: str, text: str) -> list[dict[str, Any]]:
    """The values of each turn by their names, in order, for what the length of a ForLoop or the values of a ForEach were performed to.

    Raises Refused, TooMany.
    """
    return _numbers(text) if kind == FOR_LOOP else _sets(text)


def _numbers(text: str) -> list[dict[str, Any]]:
    try:
        length = int(text)
    except ValueError as error:
        raise Refused("ValueError", str(error)) from None
    if length > MOST_TURNS:
        raise TooMany
    return [{INDEX: number} for number in range(length)]


def _sets(text: str) -> list[dict[str, Any]]:
    """Mappings of YAML with semicolons between them: those are looked for first, wherever they stand; an empty set is left out."""
    words = [each.strip() for each in text.strip().split(_SEPARATOR) if each]
    if len(words) > MOST_TURNS or len(text) > _LONGEST:
        raise TooMany
    try:
        loaded = [load(each, _YAML) for each in words]
    except YamlError as error:
        raise Refused("YAMLError", error.message) from None
    except YamlBeyond:
        raise TooMany from None
    found: list[dict[str, Any]] = []
    for each in loaded:
        if each is None:
            continue
        if not isinstance(each, dict):
            raise Refused("TypeError", f"a set of values is no mapping, but a {type(each).__name__}")
        if not all(isinstance(key, str) for key in each):
            raise Refused("TypeError", "keywords must be strings")
        found.append(each)
    return found

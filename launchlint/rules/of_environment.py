"""Whether a text in a launch file is made from an environment variable, be it by way of args: then it is another one on another machine."""

from __future__ import annotations

from launchlint.evaluate.ros1.expression import arguments_read
from launchlint.rules.edits import spot
from launchlint.rules.view import LaunchView
from launchlint.source import Origin
from launchlint.syntax.parts import Expression, Substitution
from launchlint.syntax.ros1.substitutions import opens, parse
from launchlint.syntax.tree import Document

_ENVIRONMENT = ("env", "optenv")


def hangs_on_environment(text: str, origin: Origin, view: LaunchView) -> bool:
    """Whether ``text``, as written at ``origin``, asks for an environment variable, or reads an arg that was made from one.

    Args are followed through the file and the includes that lead to it; all values that are written for one count.
    """
    texts, names = [text], set[str]()
    for place in (origin.place, *reversed(origin.chain)):
        document = view.documents.get(place.source.path)
        if place is not origin.place:  # an include on the way: what it passes to the file below
            at = spot(view, place)
            children = () if at is None else at.element.children
            texts = [
                child.get("value") or child.get("default") or "" for child in children if child.tag == "arg" and child.get("name") in names
            ]
        names = _read(texts)
        if document is not None:
            texts += _behind(names, document)
        if any(map(_asks_environment, texts)):
            return True
    return False


def _asks_environment(text: str) -> bool:
    for part in parse(text).parts if opens(text) else ():
        if isinstance(part, Substitution) and part.command in _ENVIRONMENT:
            return True
        if isinstance(part, Expression) and any(f"{each}(" in part.code for each in _ENVIRONMENT):
            return True
    return False


def _read(texts: list[str]) -> set[str]:
    found: set[str] = set()
    for text in texts:
        if opens(text):
            parts = parse(text)
            found.update(parts.names("arg") if parts.expression is None else arguments_read(parts.expression.code))
    return found


def _behind(names: set[str], document: Document) -> list[str]:
    """What the args ``names`` are given in this file, and the args that these read, which are added to ``names``."""
    given: dict[str, list[str]] = {}
    for element in document.elements:
        if element.tag == "arg" and element.parent is not None and element.parent.tag != "include":
            given.setdefault(element.get("name") or "", []).append(element.get("value") or element.get("default") or "")
    found: list[str] = []
    waiting = [*names]
    while waiting:
        texts = given.get(waiting.pop(), [])
        found += texts
        further = _read(texts) - names
        names |= further
        waiting += further
    return found

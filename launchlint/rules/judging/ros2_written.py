"""What is said of texts in launch files of ROS 2 as they are written: secrets, paths of one machine, remaps that do nothing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from launchlint.evaluate.names import canonical
from launchlint.finding import Location
from launchlint.named_tuple import NamedTuple
from launchlint.rules.view import FileView
from launchlint.source import Place
from launchlint.syntax.ros2.description import (
    Argument,
    Component,
    Include,
    Let,
    Node,
    Pair,
    Parameter,
    ParameterFile,
    Substitution,
    Text,
    TypedValue,
)
from launchlint.syntax.ros2.everything import everything

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_LOOKED_AT = (Argument, Component, Include, Let, Node, Pair, Parameter, ParameterFile, Substitution)


class Written(NamedTuple):
    """A text of the file. ``kind`` is the tag that it stands in, ``name`` what it is the value of, where that is written out."""

    kind: str
    name: str
    text: Text


def values(view: FileView) -> Iterator[Written]:
    """The values of args, configurations, params and variables; those of lists one by one."""
    for each in _everything(view):
        if isinstance(each, Argument) and each.default is not None:
            yield Written("arg", each.name, each.default)
        elif isinstance(each, Let):
            yield Written("let", each.name.literal or "", each.value)
        elif isinstance(each, Pair):
            yield Written("value", each.name.literal or "", each.value)
        elif isinstance(each, Parameter) and isinstance(each.value, TypedValue):
            held = each.value.value
            yield from (Written("param", each.name.literal or "", text) for text in ((held,) if isinstance(held, Text) else held))


def file_names(view: FileView) -> Iterator[Written]:
    """What names a file: of includes, and of parameter files."""
    for each in _everything(view):
        if isinstance(each, Include) and each.description is None:
            yield Written("include", "", each.file)
        elif isinstance(each, ParameterFile):
            yield Written("param", "", each.file)


def command_lines(view: FileView) -> Iterator[Written]:
    """The words of the command lines of nodes."""
    for each in _everything(view):
        if isinstance(each, Node):
            yield from (Written("node", "", word) for word in each.arguments)


def remapped_to_themselves(view: FileView) -> Iterator[tuple[str, Place]]:
    """The remaps of nodes that leave a name as it is, and take no other remap of that name out of effect: rcl takes the first that fits."""
    for each in _everything(view):
        if isinstance(each, (Node, Component)):
            names = Counter(_name(remap.source) for remap in each.remaps)
            for remap in each.remaps:
                source = _name(remap.source)
                if source and source == _name(remap.target) and names[source] == 1:
                    yield source, remap.place


def packages_used(view: FileView) -> Iterator[tuple[str, Place, str]]:
    """Each package that the file names, where, and what for."""
    included: set[int] = set()
    for each in _everything(view):
        if isinstance(each, Include):
            included.update(id(piece) for piece in each.file.pieces)
        package = each.package if isinstance(each, (Node, Component)) else None
        if package is not None and package.literal:
            yield package.literal, package.place, "starts a node of" if isinstance(each, Node) else "loads a component of"
        elif isinstance(each, Substitution) and each.name == "find-pkg-share" and len(each.arguments) == 1:
            name = each.arguments[0].literal
            if name:
                yield name, each.place, "includes a file of" if id(each) in included else "uses files of"


def beside(text: Text) -> str:
    """The text with a ``$`` in the place of each substitution."""
    return "".join(piece if isinstance(piece, str) else "$" for piece in text.pieces)


def masked(place: Place) -> Location:
    """``place`` with asterisks for what stands there in the line that is shown."""
    at = Location.of(place)
    start = at.column - 1
    end = min(len(at.text), start + (place.span.end - place.span.start))
    return at._replace(text=at.text[:start] + "*" * (end - start) + at.text[end:])


def _everything(view: FileView) -> tuple[tuple[Any, ...], ...]:
    """What stands in the file itself: of one in Python a function of another file may have made some of what it describes."""
    return view.once(_own)


def _own(view: FileView) -> tuple[tuple[Any, ...], ...]:
    document = view.document
    path = document.source.path
    parts = () if document.description is None else everything(document.description)
    return tuple(each for each in parts if isinstance(each, _LOOKED_AT) and _is_in(each, path))


def _is_in(part: object, path: str) -> bool:
    place = getattr(part, "place", None)
    return not isinstance(place, Place) or place.source.path == path


def _name(text: Text) -> str:
    return canonical((text.literal or "").strip())

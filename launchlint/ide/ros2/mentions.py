"""The words of a launch file of ROS 2 that mean something, from what it describes: the same for XML, YAML and Python."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.ide.mention import Mention
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Substitution, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.ide.mention import Kind
    from launchlint.source import Place, Source
    from launchlint.syntax.ros2.description import Description

DEEPEST = 200
_COMMANDS: dict[str, Kind] = {
    "var": "arg",
    "find-pkg-share": "package",
    "find-pkg-prefix": "package",
    "find-pkg": "package",
    "exec-in-pkg": "executable",
    "env": "variable",
}


def mentions(description: Description, source: Source) -> tuple[Mention, ...]:
    """All of them that stand in ``source``, in order."""
    found = dict.fromkeys(_of(description.actions, source, 0, 0))
    return tuple(sorted(found, key=lambda each: (each.span.start, each.span.end)))


def _of(thing: Any, source: Source, item: int, depth: int) -> Iterator[Mention]:
    if depth > DEEPEST or thing is None or isinstance(thing, (str, int, float, bool)):
        return
    if isinstance(thing, Text):
        yield from _text(thing, source, item, depth)
    elif isinstance(thing, Substitution):
        yield from _substitution(thing, source, item, depth)
    elif isinstance(thing, tuple):
        if isinstance(place := getattr(thing, "place", None), tuple) and _is_action(thing):
            item = place[1].start
            yield from _action(thing, source, item)
        for each in thing:
            if isinstance(each, tuple) and not _is_place(each):
                yield from _of(each, source, item, depth + 1)


def _is_action(thing: object) -> bool:
    return isinstance(thing, (described.Argument, described.Let, described.Include, described.Node, described.Remap, described.Parameter))


def _is_place(thing: object) -> bool:
    from launchlint.source import Place, Span

    return isinstance(thing, (Place, Span))


def _action(action: Any, source: Source, item: int) -> Iterator[Mention]:
    if isinstance(action, described.Argument):
        yield from _named("arg", action.name, action.place, source, item)
    elif isinstance(action, described.Let) and action.name.literal:
        yield from _named("arg", action.name.literal, action.name.place, source, item)
    elif isinstance(action, described.Include):
        if action.description is None:
            yield from _whole("file", action.file, source, item)
        for pair in action.arguments:
            if pair.name.literal is not None:
                yield from _named("arg", pair.name.literal, pair.name.place, source, item, passes=True)
    elif isinstance(action, described.Node):
        package = action.package.literal if action.package is not None and action.package.literal else ""
        if action.package is not None:
            yield from _whole("package", action.package, source, item)
        yield from _whole("executable", action.executable, source, item, package)
        if action.name is not None:
            yield from _whole("node", action.name, source, item, declares=True)
    elif isinstance(action, described.Remap):
        yield from _whole("topic", action.source, source, item)
        yield from _whole("topic", action.target, source, item, declares=True)
    elif isinstance(action, described.Parameter):
        yield from _whole("param", action.name, source, item)


def _named(kind: Kind, name: str, place: Place, source: Source, item: int, *, passes: bool = False) -> Iterator[Mention]:
    """A literal name somewhere at ``place``: the word itself."""
    if place.source is not source or not name:
        return
    text = place.text
    behind = text.find("name")
    at = text.find(name, max(behind + 4, 0)) if behind >= 0 and text != name else text.find(name)
    if at < 0:
        at = text.find(name)
    if at < 0:
        line = source.text.find("\n", place.span.start)
        found = source.text.find(name, place.span.start, len(source.text) if line < 0 else source.text.find("\n", line + 1))
        if found < 0:
            return
        start = found
    else:
        start = place.span.start + at
    span = place.span._replace(start=start, end=start + len(name))
    yield Mention(kind, name, span, "passes" if passes else "declares", item, span)


def _whole(kind: Kind, text: Text, source: Source, item: int, package: str = "", *, declares: bool = False) -> Iterator[Mention]:
    if text.place.source is source:
        name = text.literal if text.literal is not None else text.written
        span = text.place.span
        quoted = [at for quote in "'\"" if (at := text.place.text.find(f"{quote}{name}{quote}")) >= 0]
        if quoted and text.literal:  # in Python the place may be that of what the text stands in
            span = span._replace(start=span.start + quoted[0] + 1, end=span.start + quoted[0] + 1 + len(name))
        yield Mention(kind, name, span, "declares" if declares else "reads", item, span, package)


def _text(text: Text, source: Source, item: int, depth: int) -> Iterator[Mention]:
    for piece in text.pieces:
        if isinstance(piece, Substitution):
            yield from _substitution(piece, source, item, depth + 1)


def _substitution(each: Substitution, source: Source, item: int, depth: int) -> Iterator[Mention]:
    kind = _COMMANDS.get(each.name)
    if kind is not None and each.arguments and each.arguments[0].literal and each.place.source is source:
        word = each.arguments[0]
        name = word.literal or ""
        text = word.place.text
        at = text.find(name)
        if at >= 0:
            span = word.place.span._replace(start=word.place.span.start + at, end=word.place.span.start + at + len(name))
            yield Mention(kind, name, span, "reads", item, each.place.span)
    for argument in each.arguments:
        yield from _text(argument, source, item, depth + 1)


def declared(description: Description) -> Iterator[tuple[str, bool, str]]:
    """The args that a launch file takes, in order: name, whether it must be given, and what is said of it."""
    for action in description.actions:
        if isinstance(action, described.Argument):
            said = "" if action.default is None else f"default: {action.default.written}"
            yield action.name, action.default is None, " — ".join(filter(None, (said, action.description)))


def lets(description: Description) -> Iterator[tuple[str, str]]:
    """What launch files set with ``<let>`` as it is written: name and value, in order."""
    waiting: list[Any] = list(reversed(description.actions))
    while waiting:
        action = waiting.pop()
        if isinstance(action, described.Let) and action.name.literal:
            yield action.name.literal, action.value.written
        if isinstance(action, tuple) and not isinstance(action, (Text, Substitution)) and not _is_place(action):
            waiting.extend(each for each in reversed(action) if isinstance(each, tuple))

"""An arg in all the files that share it: where it is declared, read and passed; found by what includes what, not by its name alone."""

from __future__ import annotations

import os

from launchlint.evaluate.session import Read
from launchlint.ide.view import Target, View, mentions_in
from launchlint.model import ROS1
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from launchlint.ide.mention import Mention
    from launchlint.ide.view import Snapshot


class Use(NamedTuple):
    """A place of an arg, and whether it is declared there."""

    target: Target
    declares: bool


class _Edges(NamedTuple):
    """What passes args to what, as it was evaluated: (file, where the include begins) → file, all absolute; and what passes all of them."""

    to: dict[tuple[str, int], set[str]]
    all_args: set[tuple[str, str]]


def _edges(snapshot: Snapshot) -> _Edges:
    to: dict[tuple[str, int], set[str]] = {}
    all_args: set[tuple[str, str]] = set()
    for entry in snapshot.entries:
        for configuration in entry.configurations:
            for include in configuration.evaluation.launch.includes:
                if include.source is not None:
                    place = include.origin.place
                    file, target = os.path.abspath(place.source.file), os.path.abspath(include.source.file)
                    to.setdefault((file, place.span.start), set()).add(target)
                    if include.pass_all_args or configuration.evaluation.launch.dialect != ROS1:
                        all_args.add((file, target))
    return _Edges(to, all_args)


def owner(view: View, mention: Mention) -> set[tuple[str, str]]:
    """The args, each by file (absolute) and name, that a word means: the file's own, or those of the files that it is passed to."""
    if mention.role != "passes":
        return {(view.file, mention.name)}
    targets = _edges(view.snapshot).to.get((view.file, mention.item), set())
    return {(file, mention.name) for file in targets} or {(view.file, mention.name)}


def uses(view: View, mention: Mention) -> list[Use]:
    """All places of the arg that a word means, in order of files."""
    snapshot = view.snapshot
    edges = _edges(snapshot)
    name = mention.name
    files = {file for file, _ in owner(view, mention)}
    while True:  # an arg that is passed with all others is one and the same in both files
        more = {a for a, b in edges.all_args if b in files and _has(view, a, name)} | {
            b for a, b in edges.all_args if a in files and _has(view, b, name)
        }
        if more <= files:
            break
        files |= more
    found: dict[Target, Use] = {}
    for file in sorted({*files, *(source for (source, _), targets in edges.to.items() if targets & files)}):
        for each in mentions_of(view, file):
            if each.kind != "arg" or each.name != name:
                continue
            passed = each.role == "passes" and bool(edges.to.get((file, each.item), set()) & files)
            if passed or (each.role != "passes" and file in files):
                target = _target(view, file, each)
                found[target] = Use(target, each.role == "declares")
    return list(found.values())


def _target(view: View, file: str, mention: Mention) -> Target:
    if file == view.file:
        return Target(file, view.seen(mention.span))
    shown = view.session.shown(file)
    start, end = (view.snapshot.back(shown, offset) for offset in mention.span)
    return Target(file, mention.span._replace(start=start, end=end))


def mentions_of(view: View, file: str) -> tuple[Mention, ...]:
    """The words of a file, this one or another."""
    if file == view.file:
        return view.mentions
    document = view.dialect.parse(view.session, file)
    return () if isinstance(document, Read) else mentions_in(document, view.dialect.name == ROS1)


def _has(view: View, file: str, name: str) -> bool:
    return any(each.kind == "arg" and each.name == name and each.role == "declares" for each in mentions_of(view, file))


def declared(view: View, file: str) -> Iterator[tuple[str, bool, str]]:
    """The args that a launch file takes, in order: name, whether it must be given, and what is said of it (default, documentation)."""
    document = view.dialect.parse(view.session, file)
    if isinstance(document, Read):
        return
    if document.description is not None:
        from launchlint.ide.ros2.mentions import declared as declared_in_ros2

        yield from declared_in_ros2(document.description)
    elif document.launch is not None:
        from launchlint.ide.ros1.mentions import declared as declared_in_ros1

        yield from declared_in_ros1(document)

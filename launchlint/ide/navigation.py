"""Where things are: definitions, references, highlights, links, renaming."""

from __future__ import annotations

import os
import re

from launchlint.graph.connections import OFFERS
from launchlint.ide.args import Use, mentions_of, owner, uses
from launchlint.ide.files import file_named, package_of, program_file
from launchlint.ide.view import Target, View, is_made_by
from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.source import Place, Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from launchlint.ide.mention import Mention
    from launchlint.ide.view import Snapshot

_ARG = late(r"[A-Za-z_][\w]*")
_NODE = late(r"[A-Za-z][\w]*")
START = Span(0, 0)


class Link(NamedTuple):
    """A stretch of the text that names a file."""

    span: Span
    file: str


class Change(NamedTuple):
    """A stretch of a file, and what is to stand there."""

    target: Target
    text: str


def target_of_place(snapshot: Snapshot, place: Place) -> Target:
    """Where a place of the model is in the text that people see."""
    start, end = (snapshot.back(place.source.path, offset) for offset in place.span)
    return Target(os.path.abspath(place.source.file), Span(start, end))


def definition(view: View, offset: int) -> list[Target]:
    """Where what is named at ``offset`` comes from: the declaration of an arg, a file, a package, a source, the other ends of a topic."""
    mention = view.mention_at(offset)
    if mention is None:
        return []
    kind = mention.kind
    if kind == "arg":
        if mention.role == "declares":
            return [use.target for use in uses(view, mention) if not use.declares]
        files = {file for file, _ in owner(view, mention)}
        return [use.target for use in uses(view, mention) if use.declares and use.target.file in files]
    if kind == "package":
        home = package_of(view, mention.name)
        return [] if home is None else [Target(home.manifest_path, START)]
    if kind == "executable":
        path = program_file(view, mention.package, mention.name)
        return [] if path is None else [Target(path, START)]
    if kind == "file":
        path = file_named(view, mention)
        return [] if path is None else [Target(path, START)]
    if kind == "machine":
        places = [launch.machines[mention.name].origin.place for launch in view.launches if mention.name in launch.machines]
        return _distinct(target_of_place(view.snapshot, place) for place in places)
    if kind == "topic":
        return _distinct(_other_ends(view, mention))
    return []


def _distinct(targets: Iterator[Target]) -> list[Target]:
    return list(dict.fromkeys(targets))


def _other_ends(view: View, mention: Mention) -> Iterator[Target]:
    """The nodes that are connected by what a remap renames."""
    for configuration, node, remap in view.remaps_of(mention.item):
        graph = configuration.graph
        instance = None if graph is None else graph.instance(node.full_name)
        if graph is None or instance is None:
            continue
        for endpoint in instance.endpoints:
            if not is_made_by(endpoint, remap):
                continue
            channel = graph.channels.get((endpoint.kind, endpoint.name))
            for other in () if channel is None else channel.uses if endpoint.role in OFFERS else channel.offers:
                partner = graph.instance(other.node)
                if partner is not None and other.node != endpoint.node:
                    places = partner.node.places
                    yield target_of_place(view.snapshot, places.get("name", partner.node.origin.place))


def references(view: View, offset: int, *, declaration: bool = True) -> list[Target]:
    """All places of what is named at ``offset``."""
    mention = view.mention_at(offset)
    if mention is None:
        return []
    if mention.kind == "arg":
        return [use.target for use in uses(view, mention) if declaration or not use.declares]
    if mention.kind == "topic":
        return _distinct(_remaps_to_the_same(view, mention))
    return [Target(view.file, view.seen(each.span)) for each in view.mentions if (each.kind, each.name) == (mention.kind, mention.name)]


def _remaps_to_the_same(view: View, mention: Mention) -> Iterator[Target]:
    """The remaps and nodes that make the name that a remap makes."""
    yield Target(view.file, view.seen(mention.span))
    names: set[tuple[str, str]] = set()
    for configuration, node, remap in view.remaps_of(mention.item):
        instance = None if configuration.graph is None else configuration.graph.instance(node.full_name)
        for endpoint in () if instance is None else instance.endpoints:
            if is_made_by(endpoint, remap):
                names.add((endpoint.kind, endpoint.name))
    for configuration in view.configurations:
        graph = configuration.graph
        for name in sorted(names):
            channel = None if graph is None else graph.channels.get(name)
            for endpoint in () if channel is None else (*channel.offers, *channel.uses):
                assert graph is not None
                for applied in endpoint.applied:
                    if applied.rule.remap is not None:
                        yield target_of_place(view.snapshot, applied.rule.remap.origin.place)
                partner = graph.instance(endpoint.node)
                if partner is not None:
                    yield target_of_place(view.snapshot, partner.node.places.get("name", partner.node.origin.place))


def highlights(view: View, offset: int) -> list[Use]:
    """The places of the same thing in this file."""
    mention = view.mention_at(offset)
    if mention is None:
        return []
    same = [each for each in view.mentions if (each.kind, each.name) == (mention.kind, mention.name)]
    return [Use(Target(view.file, view.seen(each.span)), each.role == "declares") for each in same]


def renamable(view: View, offset: int) -> Span | None:
    """The word at ``offset`` that can be renamed: an arg, a machine, the name of a node."""
    mention = view.mention_at(offset)
    if mention is None or mention.kind not in ("arg", "machine", "node") or "$" in mention.name or not mention.name:
        return None
    return view.seen(mention.span)


def rename(view: View, offset: int, name: str) -> list[Change]:
    """What is to be changed so that what is named at ``offset`` is called ``name`` everywhere. Raises ValueError, with the reason."""
    mention = view.mention_at(offset)
    if mention is None or renamable(view, offset) is None:
        raise ValueError("what stands here has no name of its own that could be changed")
    if re.fullmatch((_ARG if mention.kind == "arg" else _NODE).pattern, name) is None:
        raise ValueError(f"{name!r} cannot be a name")
    if mention.kind == "arg":
        found = uses(view, mention)
        files = {use.target.file for use in found if use.declares}
        for file in files:
            if any(each.kind == "arg" and each.name == name and each.role == "declares" for each in mentions_of(view, file)):
                raise ValueError(f"{view.session.shown(file)} has an arg {name} already")
        for file in {use.target.file for use in found}:
            if not file.startswith(view.session.root):
                raise ValueError(f"{file} belongs to it too, and is not in this workspace")
        return [Change(use.target, name) for use in found]
    return [Change(target, name) for target in references(view, offset)]


def links(view: View) -> list[Link]:
    """The files that are named in the text."""
    found = []
    for mention in view.mentions:
        if mention.kind == "file":
            path = file_named(view, mention)
            if path is not None:
                found.append(Link(view.seen(mention.whole), path))
    return found

"""The shape of a file: symbols, folding, selections, pairs of tag names."""

from __future__ import annotations

import os

from launchlint.ide.navigation import START, target_of_place
from launchlint.ide.view import Target, View
from launchlint.named_tuple import NamedTuple
from launchlint.source import Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Literal

    from launchlint.ide.view import Snapshot
    from launchlint.syntax.tree import Element

    What = Literal["node", "arg", "include", "group", "param", "remap", "machine", "file", "topic", "other"]

_KINDS: dict[str, What] = {
    "node": "node", "test": "node", "arg": "arg", "include": "include", "group": "group", "param": "param", "rosparam": "param",
    "remap": "remap", "machine": "machine", "let": "arg", "node_container": "node", "composable_node": "node", "executable": "node",
    "topic": "remap", "file": "include",
}  # fmt: skip


class Symbol(NamedTuple):
    """One line of the outline: all of it (``whole``), and the word that names it (``name_span``)."""

    name: str
    what: What
    detail: str
    whole: Span
    name_span: Span
    children: tuple[Symbol, ...] = ()


class Found(NamedTuple):
    """Something of the workspace that has a name."""

    name: str
    what: What
    container: str
    target: Target


def symbols(view: View) -> list[Symbol]:
    """The outline of the file."""
    root = view.document.root
    if root is None:
        return [
            Symbol(each.name or each.kind, _KINDS.get(each.kind, "other"), "", view.seen(each.whole), view.seen(each.span))
            for each in view.mentions
            if each.role == "declares" or (each.kind == "file" and view.includes_of(each.item))
        ]
    return [_symbol(view, child) for child in root.children]


def _symbol(view: View, element: Element) -> Symbol:
    attributes = element.attributes
    named = next((attributes[each] for each in ("name", "file", "ns", "from", "test-name", "if", "unless") if each in attributes), None)
    detail = " ".join(filter(None, (element.get("pkg"), element.get("type") or element.get("exec"))))
    if element.tag in ("arg", "param", "let"):
        detail = element.get("default") or element.get("value") or ""
    if element.tag == "remap":
        detail = f"→ {element.get('to') or ''}"
    name = element.tag if named is None or not named.value else named.value
    whole = view.seen(element.span)
    at = view.seen(element.name_span if named is None else named.value_or_name_span)
    inside = Span(min(max(at.start, whole.start), whole.end), min(max(at.end, whole.start), whole.end))
    children = tuple(_symbol(view, child) for child in element.children)
    return Symbol(name, _KINDS.get(element.tag, "other"), f"{element.tag} {detail}".strip(), whole, inside, children)


def workspace_symbols(snapshot: Snapshot, query: str, most: int = 400) -> list[Found]:
    """Nodes, topics, args and launch files whose names hold the letters of ``query`` in order."""
    found: dict[tuple[str, What, Target], Found] = {}
    for each in _all(snapshot):
        if _matches(query, each.name):
            found.setdefault((each.name, each.what, each.target), each)
        if len(found) >= most:
            break
    return sorted(found.values(), key=lambda each: (each.name.casefold() != query.casefold(), each.name, each.target))


def _all(snapshot: Snapshot) -> Iterator[Found]:
    for file in sorted(snapshot.including):
        yield Found(file, "file", "", Target(snapshot.session.named(file), START))
    for entry in snapshot.entries:
        for configuration in entry.configurations:
            launch = configuration.evaluation.launch
            for node in (*launch.nodes, *launch.tests):
                place = node.places.get("name", node.origin.place)
                yield Found(node.full_name, "node", os.path.basename(node.file), target_of_place(snapshot, place))
            for argument in launch.declared:
                if not argument.passed:
                    place = argument.origin.place
                    yield Found(argument.name, "arg", place.source.path, target_of_place(snapshot, place))
            graph = configuration.graph
            for channel in () if graph is None else graph.channels.values():
                for endpoint in (*channel.offers, *channel.uses):
                    instance = None if graph is None else graph.instance(endpoint.node)
                    if instance is not None and not channel.is_plumbing:
                        place = instance.node.places.get("name", instance.node.origin.place)
                        yield Found(channel.name, "topic", endpoint.node, target_of_place(snapshot, place))
                        break


def _matches(query: str, name: str) -> bool:
    rest = iter(name.casefold())
    return all(letter in rest for letter in query.casefold())


def folding(view: View) -> list[tuple[Span, bool]]:
    """The stretches that can be folded, each with whether it is a comment."""
    found = [(view.seen(element.span), False) for element in view.document.elements]
    found += [(view.seen(comment.span), True) for comment in view.document.comments]
    text = view.text
    if view.document.root is None:
        found += [(span, False) for span in _blocks(text)]
    return [(span, comment) for span, comment in found if "\n" in text[span.start : span.end]]


def _blocks(text: str) -> list[Span]:
    """The lines of a text without tags that others below them are indented under, each with these."""
    found: list[Span] = []
    open_: list[tuple[int, int]] = []  # indentation, where the line begins
    start = end = 0
    for line in text.splitlines(keepends=True):
        bare = line.strip()
        if bare:
            indentation = len(line) - len(line.lstrip())
            while open_ and open_[-1][0] >= indentation:
                found.append(Span(open_.pop()[1], end))
            end = start + len(line.rstrip("\r\n"))
            open_.append((indentation, start))
        start += len(line)
    found += [Span(begin, end) for _, begin in open_]
    return sorted(span for span in found if "\n" in text[span.start : span.end])


def selections(view: View, offset: int) -> list[Span]:
    """What is around ``offset``, each stretch inside the next one: word, value, attribute, start tag, element, and the elements around."""
    found: list[Span] = []
    mention = view.mention_at(offset)
    if mention is not None:
        found += [view.seen(mention.span), view.seen(mention.whole)]
    attribute = view.attribute_at(offset)
    if attribute is not None:
        found += [view.seen(attribute[1].value_span), view.seen(attribute[1].span)]
    element = view.element_at(offset)
    while element is not None:
        found += [view.seen(element.start_span), view.seen(element.span)]
        element = element.parent
    if view.document.root is None:
        around = [span for span in _blocks(view.text) if span.start <= offset <= span.end]
        found += sorted(around, key=lambda span: span.end - span.start)
    found.append(Span(0, len(view.text)))
    nested: list[Span] = []
    for span in found:
        if span.start <= offset <= span.end and (not nested or (span != nested[-1] and _holds(span, nested[-1]))):
            nested.append(span)
    return nested


def _holds(outer: Span, inner: Span) -> bool:
    return outer.start <= inner.start and inner.end <= outer.end


def tag_names(view: View, offset: int) -> tuple[Span, Span] | None:
    """The name of the tag at ``offset``, where it is opened and where it is closed."""
    element = view.element_at(offset)
    if element is None or element.self_closed or view.recovery.edits:
        return None
    opening, end = element.name_span, element.end_span
    closing = Span(end.start + 2, end.start + 2 + len(element.tag))
    if view.document.source.text[closing.start : closing.end] != element.tag:
        return None
    return (opening, closing) if any(span.start <= offset <= span.end for span in (opening, closing)) else None

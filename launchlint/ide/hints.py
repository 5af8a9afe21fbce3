"""What is shown between the words: values of substitutions, names that remaps make, and over a file or node what it amounts to."""

from __future__ import annotations

from launchlint.graph.connections import OFFERS
from launchlint.ide.files import arg_values
from launchlint.ide.hover import instance_of, partners
from launchlint.ide.view import View, is_made_by
from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted
from launchlint.source import Span

LONGEST = 40


class Hint(NamedTuple):
    """A text shown behind ``offset``."""

    offset: int
    text: str


class Lens(NamedTuple):
    """A line shown over ``span``; ``command`` is what a click on it does: ``topology``, or ``references``."""

    span: Span
    text: str
    command: str


def hints(view: View, start: int, end: int) -> list[Hint]:
    """The hints between two offsets of the text."""
    found: list[Hint] = []
    for mention in view.mentions:
        span = view.seen(mention.whole)
        if not start <= span.end <= end:
            continue
        if mention.kind == "arg" and mention.role == "reads":
            values = list(arg_values(view, mention.name))
            if values and not values[0].startswith("not known") and ("$(" in view.text[span.start : span.end] or view.file.endswith(".py")):
                more = " …" if len(values) > 1 else ""
                behind = span.end if view.file.endswith(".py") else view.seen(mention.span).end
                found.append(Hint(behind, f" = {_short(values[0])}{more}"))
        elif mention.kind == "topic" and mention.role == "declares":
            said = _of_remap(view, mention.item)
            if said:
                found.append(Hint(span.end + (view.text[span.end : span.end + 1] in ("'", '"')), f" {said}"))
    return list(dict.fromkeys(found))


def _of_remap(view: View, item: int) -> str:
    for configuration, node, remap in view.remaps_of(item):
        graph = configuration.graph
        instance = None if graph is None else graph.instance(node.full_name)
        for endpoint in () if graph is None or instance is None else instance.endpoints:
            if is_made_by(endpoint, remap):
                assert graph is not None
                others = len(partners(graph, endpoint))
                arrow, what = ("→", "subscriber") if endpoint.role in OFFERS else ("←", "publisher")
                return f"{endpoint.name} {arrow} {counted(others, what if endpoint.kind == 'topic' else 'node')}"
    return ""


def lenses(view: View) -> list[Lens]:
    """The lines over the file and its nodes."""
    root = view.document.root
    top = Span(0, 0) if root is None else view.seen(root.name_span)
    found: list[Lens] = []
    own = next((each for each in view.entries if each.result.request.at == view.file), None)
    if own is not None and own.configurations:
        first = own.configurations[0]
        launch = first.evaluation.launch
        graph = first.graph
        channels = 0 if graph is None else sum(1 for each in graph.channels.values() if each.offers and each.uses and not each.is_plumbing)
        nodes = len(launch.nodes) + len(launch.tests)
        found.append(Lens(top, f"{counted(nodes, 'node')}, {counted(channels, 'connection')}", "topology"))
    including = sum(1 for files in view.snapshot.including.values() if view.shown in files)
    if including:
        found.append(Lens(top, f"included by {counted(including, 'file')}", "references"))
    for node in {node.origin.place.span.start: node for node in reversed(view.nodes)}.values():
        pair = instance_of(view, node)
        if pair is not None and not pair[1].is_unknown:
            ends = [each for each in pair[1].endpoints if not each.is_plumbing and each.kind == "topic"]
            gives = sum(1 for each in ends if each.role in OFFERS)
            start = node.origin.place.span.start
            span = view.seen(Span(start, start + 1))
            found.append(Lens(span, f"{counted(gives, 'topic')} out, {counted(len(ends) - gives, 'topic')} in", "topology"))
    return found


def _short(text: str) -> str:
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"

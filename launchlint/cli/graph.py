"""``launchlint graph`` and ``launchlint graph diff``."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator, Mapping
from typing import Any, TypeVar

import click

from launchlint.cli.entries import EntryOptions, leave_ros2_out, tell
from launchlint.cli.options import entry_options
from launchlint.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.check.entry import EntryChecker
    from launchlint.check.options import EntryRequest
    from launchlint.graph.difference import Difference
    from launchlint.graph.selection import Selection
    from launchlint.graph.topology import Topology

F = TypeVar("F", bound=Callable[..., Any])

GRAPH_FORMATS = ("text", "mermaid", "dot", "graphml", "json")
DIFF_FORMATS = ("text", "mermaid", "dot", "json")


class GraphGroup(click.Group):
    """``graph diff`` is a command; whatever else follows ``graph`` is for ``graph`` itself."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put the name of the hidden command that shows a graph before args that name none."""
        if not args or args[0] not in (*self.commands, "-h", "--help"):
            args = ["show", *args]
        return super().parse_args(ctx, args)


def selection_options(function: F) -> F:
    """The options that narrow what is shown."""
    for decorate in (
        click.option("--namespace", "namespaces", multiple=True, metavar="NS", help="Only nodes in this namespace, and what they talk to."),
        click.option("--node", "nodes", multiple=True, metavar="NAME", help="Only this node (or *pattern*), and what it talks to."),
        click.option("--topic", "channels", multiple=True, metavar="NAME", help="Only this topic, service or action (or *pattern*)."),
        click.option(
            "--kind", "kinds", multiple=True, type=click.Choice(["topic", "service", "action"]), help="Only channels of this kind."
        ),
        click.option("--hubs/--no-hubs", default=None, help="Show /tf, /clock, /diagnostics …; default: in graphml and json only."),
        click.option(
            "--plumbing/--no-plumbing", default=None, help="Show bonds, dynamic_reconfigure …; default: in graphml and json only."
        ),
    ):
        function = decorate(function)
    return function


@click.group("graph", cls=GraphGroup, context_settings={"help_option_names": ["-h", "--help"]})
def command() -> None:
    """Show who talks to whom: `launchlint graph FILE`.

    `launchlint graph show --help` lists its options; `launchlint graph diff BASE [HEAD]` compares two git revisions or two files.
    """


@command.command("show")
@entry_options
@selection_options
@click.option("--format", "format_", type=click.Choice(GRAPH_FORMATS), default="text", show_default=True, help="How to print it.")
@click.option("--every-configuration", is_flag=True, help="Join all configurations, and mark what is in some only.")
@click.option("--dangling", is_flag=True, help="In pictures, show what nobody else uses, too.")
def show(entry: EntryOptions, format_: str, every_configuration: bool, dangling: bool, **narrowed: Any) -> int:
    """Print the connection graph of FILE: nodes, and the topics, services and actions on which they meet.

    The libraries say what each node does: the one that launchlint ships, and those of --library and of the configuration.
    """
    from launchlint.check.entry import EntryChecker
    from launchlint.check.graphs import graphs_of
    from launchlint.check.run import default_directory
    from launchlint.graph.selection import select
    from launchlint.graph.topology import topology

    requests, overlay = entry.requests()
    checker = EntryChecker(entry.options(everything=True, cache=default_directory()), overlay)
    requests, notices = leave_ros2_out(entry, requests, checker.session)
    for notice in notices:
        tell(notice)
    if not requests:
        raise UsageError("there is no launch file to show; give one")
    selection = _selection(format_, **narrowed)
    shown = (
        select(topology(graphs_of(checker, request, every_configuration=every_configuration)), selection) for request in requests
    )  # fmt: skip
    _print(shown, format_, len(requests), dangling=dangling)
    return 0


def _selection(format_: str, namespaces: tuple[str, ...], nodes: tuple[str, ...], channels: tuple[str, ...], kinds: tuple[str, ...],
               hubs: bool | None, plumbing: bool | None) -> Selection:  # fmt: skip
    from launchlint.graph.selection import KINDS, Selection

    full = format_ in ("graphml", "json")
    return Selection(
        namespaces, nodes, channels, kinds or KINDS, full if hubs is None else hubs, full if plumbing is None else plumbing, full
    )  # fmt: skip


def _print(shown: Iterator[Topology], format_: str, count: int, *, dangling: bool) -> None:
    from launchlint.report.formats import emit

    if format_ == "json":
        from launchlint.report.graph.json import as_object, text

        objects = [as_object(each) for each in shown]
        emit(text(objects[0] if count == 1 else objects), sys.stdout)
        return
    if format_ == "graphml" and count > 1:
        raise UsageError("--format graphml makes one document: give one launch file")
    for number, each in enumerate(shown):
        emit(("\n" if number else "") + _rendered(each, format_, dangling=dangling), sys.stdout)


def _rendered(topology: Topology, format_: str, *, dangling: bool) -> str:
    if format_ == "text":
        from launchlint.report.graph import text

        return text.render(topology)
    if format_ == "mermaid":
        from launchlint.report.graph import mermaid

        return mermaid.render(topology, dangling=dangling)
    if format_ == "dot":
        from launchlint.report.graph import dot

        return dot.render(topology, dangling=dangling)
    from launchlint.graph.multigraph import graphml

    return graphml(topology)


@command.command("diff")
@click.argument("base")
@click.argument("head", required=False)
@entry_options
@selection_options
@click.option("--format", "format_", type=click.Choice(DIFF_FORMATS), default="text", show_default=True, help="How to print it.")
@click.option("--exit-code", is_flag=True, help="Exit with 1 where something changed.")
def diff(base: str, head: str | None, entry: EntryOptions, format_: str, exit_code: bool, **narrowed: Any) -> int:
    """Print which nodes, topics and connections appear and disappear from BASE to HEAD, and who loses whom.

    BASE and HEAD are two launch files, or two git revisions; without HEAD the working tree is compared with BASE. Of revisions, all launch
    files below PATHS that no other one includes are compared, in every configuration.
    """
    from launchlint.report.formats import emit
    from launchlint.workspace.repository import repository_root
    from launchlint.workspace.revision import is_revision

    selection = _selection(format_, **narrowed)
    if head is not None and os.path.isfile(base) and os.path.isfile(head):
        changes = _of_files(entry, base, head, selection)
    else:
        if head is not None and os.path.exists(head) and not is_revision(repository_root(os.curdir), head):
            entry.paths, head = (head, *(path for path in entry.paths if path != os.curdir)), None
        changes = _of_revisions(entry, base, head, selection)
    emit(_rendered_changes(changes, format_), sys.stdout)
    return int(exit_code and bool(changes))


def _of_files(entry: EntryOptions, base: str, head: str, selection: Selection) -> list[Difference]:
    from launchlint.check.entry import EntryChecker
    from launchlint.check.options import EntryRequest
    from launchlint.check.run import default_directory

    checker = EntryChecker(entry.options(everything=True, cache=default_directory()))
    before, after = (_topologies(checker, {"": EntryRequest(file, file, entry.arguments)}, frozenset()) for file in (base, head))
    return _changes(before, after, selection)


def _of_revisions(entry: EntryOptions, base: str, head: str | None, selection: Selection) -> list[Difference]:
    from contextlib import ExitStack

    from launchlint.check.entry import EntryChecker
    from launchlint.check.graphs import revision
    from launchlint.check.run import default_directory

    options = entry.options(everything=True, cache=default_directory())
    with ExitStack() as stack:
        old = stack.enter_context(revision(options, base))
        before = _topologies(old.checker, entry.requests_below(old.place, old.back), entry.named)
        if head is None:
            after = _topologies(EntryChecker(options), entry.requests_below(os.path.abspath, os.path.relpath), entry.named)
        else:
            new = stack.enter_context(revision(options, head))
            after = _topologies(new.checker, entry.requests_below(new.place, new.back), entry.named)
        return _changes(before, after, selection)


def _topologies(checker: EntryChecker, requests: Mapping[str, EntryRequest], named: frozenset[str]) -> dict[str, Topology]:
    """The topology of each launch file that no other one includes, or that is asked for by name."""
    from launchlint.check.graphs import graphs_of
    from launchlint.graph.topology import topology

    found: dict[str, Topology] = {}
    included: set[str] = set()
    for path, request in requests.items():
        graphs = graphs_of(checker, request, every_configuration=True)
        found[path] = topology(graphs)
        included.update(each.source.path for graph in graphs for each in graph.launch.includes if each.source is not None)
    return {path: each for path, each in found.items() if each.entry not in included or os.path.abspath(path) in named}


def _changes(before: Mapping[str, Topology], after: Mapping[str, Topology], selection: Selection) -> list[Difference]:
    """The changes of each launch file that has some; one that is not there has an empty graph."""
    from launchlint.graph.difference import difference
    from launchlint.graph.selection import select
    from launchlint.graph.topology import EMPTY

    changes = []
    for path in sorted({*before, *after}):
        old, new = (select(side[path], selection) if path in side else None for side in (before, after))
        entry = (new or old or EMPTY).entry
        found = difference(old or EMPTY._replace(entry=entry), new or EMPTY._replace(entry=entry))
        if not found.is_empty:
            changes.append(found)
    return changes


def _rendered_changes(changes: list[Difference], format_: str) -> str:
    if format_ == "json":
        from launchlint.report.graph.json import difference_as_object, text

        return text([difference_as_object(each) for each in changes])
    if format_ == "text":
        from launchlint.report.graph.text import render_difference

        return "\n".join(render_difference(each) for each in changes) or "no connection changed\n"
    if format_ == "dot":
        from launchlint.report.graph import dot

        return "".join(dot.render(each.after, each) for each in changes)
    from launchlint.report.graph import mermaid

    return "\n".join(mermaid.render(each.after, each) for each in changes)

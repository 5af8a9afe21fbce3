"""``launchlint graph`` and ``launchlint graph diff``."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any, TypeVar

import click

from launchlint.cli.entries import tell
from launchlint.cli.options import entry_options
from launchlint.errors import UsageError
from launchlint.project.asked import EntryOptions, leave_others_out

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.graph.selection import Selection
    from launchlint.graph.topology import Topology

F = TypeVar("F", bound=Callable[..., Any])

GRAPH_FORMATS = ("text", "mermaid", "dot", "graphml", "json")
DIFF_FORMATS = ("text", "mermaid", "dot", "json")


class GraphGroup(click.Group):
    """``graph diff`` is a command; whatever else follows ``graph`` is for ``graph`` itself (the command ``show``, which nobody types)."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put the name of the hidden command before args that name none."""
        if args[:1] not in (["diff"], ["-h"], ["--help"]):
            args = ["show", *args]
        return super().parse_args(ctx, args)

    def format_help(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """The help of ``show``, and how to get to ``diff``."""
        formatter.write_usage(ctx.command_path, "[OPTIONS] [PATHS]...")
        formatter.write_usage(ctx.command_path, "diff [OPTIONS] BASE [HEAD] [PATHS]...", "       ")
        show.format_help_text(ctx, formatter)
        show.format_options(ctx, formatter)


def selection_options(function: F) -> F:
    """The options that narrow what is shown."""
    kinds = click.Choice(["topic", "service", "action", "param"])
    for decorate in (
        click.option(
            "--plumbing/--no-plumbing", default=None, help="Show bonds, dynamic_reconfigure …; default: in graphml and json only."
        ),
        click.option("--hubs/--no-hubs", default=None, help="Show /tf, /clock, /diagnostics …; default: in graphml and json only."),
        click.option("--kind", "kinds", multiple=True, type=kinds, help="Only these; repeatable."),
        click.option(
            "--topic", "channels", multiple=True, metavar="NAME", help="Only this topic, service or action (or *pattern*); repeatable."
        ),
        click.option(
            "--node", "nodes", multiple=True, metavar="NAME", help="Only this node (or *pattern*), and what it talks to; repeatable."
        ),
        click.option(
            "--namespace",
            "namespaces",
            multiple=True,
            metavar="NS",
            help="Only nodes in or below this namespace (or *pattern*), and what they talk to; repeatable.",
        ),
    ):
        function = decorate(function)
    return function


@click.group("graph", cls=GraphGroup, context_settings={"help_option_names": ["-h", "--help"]})
def command() -> None:
    """Show who talks to whom: `launchlint graph FILE`."""


@command.command("show", hidden=True)
@entry_options
@selection_options
@click.option("--dangling", is_flag=True, help="Show what nobody else uses, too: in pictures, and in text what nodes may have.")
@click.option("--every-configuration", is_flag=True, help="Join all configurations, and mark what is in some only.")
@click.option("--format", "format_", type=click.Choice(GRAPH_FORMATS), default="text", show_default=True, help="How to print it.")
def show(entry: EntryOptions, format_: str, every_configuration: bool, dangling: bool, **narrowed: Any) -> int:
    """Print the connection graph of launch files: nodes, and the topics, services and actions on which they meet.

    What nodes do is known from libraries: the one that launchlint ships, those of --library and those of the configuration. `launchlint
    graph diff --help` tells how to compare two revisions or two files.
    """
    from launchlint.check.ahead import read_ahead
    from launchlint.check.entry import EntryChecker
    from launchlint.check.graphs import topology_of
    from launchlint.check.run import default_directory
    from launchlint.cli.progress import LateBar

    requests, overlay = entry.requests()
    checker = EntryChecker(entry.options(everything=True, cache=default_directory()), overlay)
    requests, notices = leave_others_out(entry, requests, checker.session)
    for notice in notices:
        tell(notice)
    if not requests:
        raise UsageError("there is no launch file to show; give one")
    if format_ == "graphml" and len(requests) > 1:
        raise UsageError(f"--format graphml makes one document, and here are {len(requests)} launch files; give one")
    reading = LateBar("programs read") if sys.stderr.isatty() else None
    read_ahead(requests, checker, 0, None if reading is None else reading.show)
    _print(
        [topology_of(checker, request, every_configuration=every_configuration) for request in requests],
        selection(format_, **narrowed),
        format_,
        dangling=dangling,
    )
    return 0


def selection(format_: str, namespaces: tuple[str, ...], nodes: tuple[str, ...], channels: tuple[str, ...], kinds: tuple[str, ...],
              hubs: bool | None, plumbing: bool | None) -> Selection:  # fmt: skip
    """What the options keep; formats for programs keep all that nobody takes away."""
    from launchlint.graph.selection import KINDS, Selection

    full = format_ in ("graphml", "json")
    hubs, plumbing = (full if each is None else each for each in (hubs, plumbing))
    return Selection(namespaces, nodes, channels, kinds or KINDS, hubs, plumbing, action_topics=full)


def _print(complete: list[Topology], chosen: Selection, format_: str, *, dangling: bool) -> None:
    from launchlint.graph.selection import select
    from launchlint.report.formats import emit

    _check_matches(complete, chosen)
    shown = [select(each, chosen) for each in complete]
    if format_ == "json":
        from launchlint.report.graph.json import as_object, text

        objects = [as_object(each) for each in shown]
        emit(text(objects[0] if len(objects) == 1 else objects), sys.stdout)
    elif format_ == "text":
        from launchlint.report.graph.text import render

        narrowed = bool(chosen.namespaces or chosen.nodes or chosen.channels)
        texts = (render(each, None if narrowed else all_, dangling=dangling) for each, all_ in zip(shown, complete, strict=True))
        emit("\n".join(texts), sys.stdout)
    elif format_ == "mermaid":
        from launchlint.report.graph.mermaid import Picture, render_all

        emit(render_all([Picture(each.entry, each) for each in shown], dangling=dangling), sys.stdout)
    elif format_ == "dot":
        from launchlint.report.graph import dot

        emit("".join(dot.render(each, title=each.entry, dangling=dangling) for each in shown), sys.stdout)
    else:
        from launchlint.report.graph import graphml

        emit(graphml.render(shown[0]), sys.stdout)


def _check_matches(complete: list[Topology], chosen: Selection) -> None:
    """Whether what was asked for by name is there. Raises UsageError."""
    from launchlint.graph.selection import unmatched
    from launchlint.spelling import did_you_mean

    for what, pattern, names in unmatched(complete, chosen):
        near = did_you_mean(f"/{pattern.lstrip('/')}", names)
        raise UsageError(f"--{what} {pattern}: there is no such {what} here{f'; {near}' if near else ''}")


@command.command("diff")
@click.argument("base")
@click.argument("head", required=False)
@entry_options
@selection_options
@click.option("--exit-code", is_flag=True, help="Exit with 1 where something changed.")
@click.option("--format", "format_", type=click.Choice(DIFF_FORMATS), default="text", show_default=True, help="How to print it.")
def diff(base: str, head: str | None, entry: EntryOptions, format_: str, exit_code: bool, **narrowed: Any) -> int:
    """Print who loses whom from BASE to HEAD, and which nodes, topics and connections appear, disappear and change.

    BASE and HEAD are two launch files, or two git revisions; without HEAD the working tree is compared with BASE. Of revisions, all launch
    files below PATHS that no other one includes are compared, each in every configuration.
    """
    from launchlint.cli.comparing import compared
    from launchlint.report.formats import emit

    changes = compared(entry, base, head, selection(format_, **narrowed))
    if format_ == "json":
        from launchlint.report.graph.json import difference_as_object, text

        output = text([difference_as_object(each) for each in changes])
    elif format_ == "text":
        from launchlint.report.graph import changes as told

        output = told.render(changes) or "no connection changed\n"
    elif format_ == "dot":
        from launchlint.report.graph import dot
        from launchlint.report.graph.changes import title

        output = "".join(dot.render(each.after, each, title=title(each)) for each in changes)
    else:
        from launchlint.report.graph.changes import title
        from launchlint.report.graph.mermaid import Picture, render_all

        output = render_all([Picture(title(each), each.after, each) for each in changes])
    emit(output, sys.stdout)
    return int(exit_code and bool(changes))

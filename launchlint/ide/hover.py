"""What is said of the word under the pointer, in Markdown."""

from __future__ import annotations

from launchlint.graph.connections import OFFERS
from launchlint.ide.args import declared, owner
from launchlint.ide.files import arg_values, file_named, package_of, program_file
from launchlint.ide.view import View, is_made_by
from launchlint.model import Command, Unknown
from launchlint.named_tuple import NamedTuple
from launchlint.source import Span

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from launchlint.graph.connections import ConnectionGraph, Endpoint, Instance
    from launchlint.ide.mention import Mention
    from launchlint.model import Node

MOST = 12
"""Lines of one list; the rest is counted."""


class Hover(NamedTuple):
    """What is said, in Markdown, of a stretch of the text."""

    markdown: str
    span: Span


def hover(view: View, offset: int) -> Hover | None:
    """What is known of the word at ``offset``; None where nothing is."""
    mention = view.mention_at(offset)
    lines: list[str] = []
    span = None if mention is None else view.seen(mention.span)
    if mention is not None:
        lines = list(_of_mention(view, mention))
    if not lines:
        for item in view.items_at(offset)[:1]:
            lines = list(_of_item(view, item))
            element = view.element_at(offset)
            span = view.seen(element.name_span) if element is not None else span or Span(offset, offset)
    return None if not lines or span is None else Hover("\n".join(lines), span)


def _of_mention(view: View, mention: Mention) -> Iterator[str]:
    kind = mention.kind
    if kind == "arg":
        yield from _arg(view, mention)
    elif kind == "package":
        home = package_of(view, mention.name)
        yield f"**package** `{mention.name}`" if home is not None else f"**package** `{mention.name}`: not on this machine"
        if home is not None:
            yield f"\n`{home.directory}`"
    elif kind == "executable":
        yield from _program(view, mention)
    elif kind == "file":
        yield from _file(view, mention)
    elif kind == "topic":
        yield from _remap(view, mention.item)
    elif kind == "param":
        yield from _param(view, mention)
    elif kind in ("node", "namespace"):
        for node in _distinct(view.nodes_of(mention.item)):
            yield from _node(view, node)
    elif kind == "machine":
        for launch in view.launches:
            machine = launch.machines.get(mention.name)
            if machine is not None:
                yield f"**machine** `{machine.name}`: {machine.user + '@' if machine.user else ''}{machine.address}"
                return


def _of_item(view: View, item: int) -> Iterator[str]:
    for node in _distinct(view.nodes_of(item)):
        yield from _node(view, node)
    yield from _remap(view, item)
    for include in view.includes_of(item)[:1]:
        if include.source is not None:
            yield from taken(view, include.file)
    for setting in view.settings_of(item)[:MOST]:
        yield f"`{setting.name}` = `{_value(setting.value)}`\n"


def _arg(view: View, mention: Mention) -> Iterator[str]:
    yield f"**arg** `{mention.name}`"
    if mention.role == "passes":
        for file, name in sorted(owner(view, mention)):
            for known, required, said in declared(view, file):
                if known == name:
                    yield f"\nof `{view.session.shown(file)}`, {'required' if required else said}"
        for include in view.includes_of(mention.item)[:1]:
            value = include.arguments.get(mention.name)
            if value is not None:
                yield f"\npassed: `{_value(value)}`"
        return
    document = next((said for name, _, said in declared(view, view.file) if name == mention.name and said), "")
    if document:
        yield f"\n{document}"
    description = view.document.description
    if description is not None:
        from launchlint.ide.ros2.mentions import lets

        for written in dict.fromkeys(value for name, value in lets(description) if name == mention.name):
            yield f"\n- set to `{written}`"
    values = arg_values(view, mention.name)
    for value, ways in list(values.items())[:MOST]:
        told = ", ".join(f"`{way}`" if way else "by default" for way in ways[:3])
        yield f"\n- `{value}`" + (f" ({told})" if len(values) > 1 or ways != [""] else "")


def _program(view: View, mention: Mention) -> Iterator[str]:
    program = f"{mention.package}/{mention.name}"
    yield f"**program** `{program}`"
    path = program_file(view, mention.package, mention.name)
    if path is not None:
        yield f"\n`{path}`"
    for node in _distinct(view.nodes_of(mention.item)):
        yield from _node(view, node)
        return


def _file(view: View, mention: Mention) -> Iterator[str]:
    path = file_named(view, mention)
    yield f"`{path}`" if path is not None else f"**file** `{mention.name}`"
    if path is not None and view.includes_of(mention.item):
        yield from taken(view, path)


def taken(view: View, file: str) -> Iterator[str]:
    """The args that a launch file (absolute) takes, the required ones first."""
    args = list(declared(view, file))
    yield f"\n`{view.session.shown(file)}` takes " + ("these args:" if args else "no args")
    for name, required, said in sorted(args, key=lambda each: not each[1])[: 2 * MOST]:
        yield f"- `{name}`: {'**required**' if required else said}"


def _distinct(nodes: list[Node]) -> list[Node]:
    """Nodes of different full names."""
    return list({node.full_name: node for node in reversed(nodes)}.values())[::-1]


def instance_of(view: View, node: Node) -> tuple[ConnectionGraph, Instance] | None:
    """The node in the first graph that has it."""
    for configuration in view.configurations:
        graph = configuration.graph
        found = None if graph is None else graph.instance(node.full_name)
        if graph is not None and found is not None and found.node.origin.place.key == node.origin.place.key:
            return graph, found
    return None


def _node(view: View, node: Node) -> Iterator[str]:
    program = f"{node.package}/{node.executable}" if node.plugin is None else f"{node.package}/{node.plugin}"
    yield f"\n**node** `{node.full_name}` — `{program}`\n"
    found = instance_of(view, node)
    if found is None:
        return
    graph, instance = found
    if instance.is_unknown:
        yield f"What it does is not known: {instance.reason}"
    told = [each for each in instance.endpoints if not each.is_plumbing]
    for endpoint in told[:MOST]:
        yield "- " + _endpoint(graph, endpoint)
    if len(told) > MOST:
        yield f"- … and {len(told) - MOST} more"
    if instance.readings:
        yield "\nreads " + ", ".join(f"`{each.name}`" for each in instance.readings[:MOST])


def partners(graph: ConnectionGraph, endpoint: Endpoint) -> list[str]:
    """The nodes at the other end."""
    channel = graph.channels.get((endpoint.kind, endpoint.name))
    if channel is None:
        return []
    others = channel.uses if endpoint.role in OFFERS else channel.offers
    return sorted({each.node for each in others if each.node != endpoint.node})


def _endpoint(graph: ConnectionGraph, endpoint: Endpoint) -> str:
    others = partners(graph, endpoint)
    arrow = "→" if endpoint.role in OFFERS else "←"
    at = f" {arrow} {', '.join(f'`{each}`' for each in others[:4])}" + (" …" if len(others) > 4 else "") if others else ""
    type_ = f" ({endpoint.type})" if endpoint.type not in ("", "*") else ""
    return f"{endpoint.role} `{endpoint.name}`{type_}{at}"


def _remap(view: View, item: int) -> Iterator[str]:
    told: dict[str, None] = {}
    remaps = view.remaps_of(item)
    for configuration, node, remap in remaps:
        graph = configuration.graph
        instance = None if graph is None else graph.instance(node.full_name)
        if graph is None or instance is None:
            continue
        for endpoint in instance.endpoints:
            if is_made_by(endpoint, remap):
                told[f"- `{node.full_name}`: {endpoint.declared} → {_endpoint(graph, endpoint)}"] = None
    if told:
        yield "**remap**\n"
        yield from list(told)[:MOST]
    elif remaps:
        names = sorted({node.full_name for _, node, _ in remaps})
        yield f"**remap** `{remaps[0][2].source}` → `{remaps[0][2].target}` of {', '.join(f'`{name}`' for name in names[:MOST])}"


def _param(view: View, mention: Mention) -> Iterator[str]:
    if view.document.description is not None:
        yield from _param_of_node(view, mention)
        return
    for setting in view.settings_of(mention.item)[:1]:
        yield f"**param** `{setting.name}` = `{_value(setting.value)}`"
        for configuration in view.configurations:
            graph = configuration.graph
            readers = () if graph is None else graph.readers.get(setting.name, ())
            for reading in readers[:MOST]:
                declaration = reading.declaration
                default = "" if declaration.default is None else f", default `{declaration.default}`"
                yield f"\n- read by `{reading.node}`{f' as {declaration.type}' if declaration.type else ''}{default}"
            if readers:
                return


def _param_of_node(view: View, mention: Mention) -> Iterator[str]:
    """What the node of ROS 2 around a param makes of it."""
    yield f"**param** `{mention.name}`"
    start = max((node.origin.place.span.start for node in view.nodes if node.origin.place.span.start < mention.item), default=-1)
    for node in _distinct(view.nodes_of(start)):
        found = instance_of(view, node)
        for reading in () if found is None else found[1].readings:
            declaration = reading.declaration
            if declaration.name.lstrip("~/") == mention.name:
                default = "" if declaration.default is None else f", default `{declaration.default}`"
                yield f"\n- read by `{reading.node}`{f' as {declaration.type}' if declaration.type else ''}{default}"


def _value(value: object) -> str:
    if isinstance(value, Unknown):
        return f"{value.text} (not known: {value.reason})"
    text = value.line if isinstance(value, Command) else str(value)
    return text if len(text) <= 200 else text[:199] + "…"

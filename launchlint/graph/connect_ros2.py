"""The nodes of a ROS 2 launch with what libraries say of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from launchlint.graph.command_line import CommandLine
from launchlint.graph.connections import Instance
from launchlint.graph.instantiate import Interface, instantiate
from launchlint.graph.names_rcl import RclNamer
from launchlint.graph.parameters import NodeParameters
from launchlint.graph.situation import Start
from launchlint.library.lookup import Library
from launchlint.library.program import Program, Variant
from launchlint.library.template import fill, parse
from launchlint.model import Launch, Node, Role
from launchlint.rcl.names import is_node_name

_KINDS = {"container": "container", "composable": "component"}


class _Known(NamedTuple):
    """What is known of what a node runs; ``reason``: why nothing is, for people. ``name`` and ``namespace`` are those that it ends up with.

    A name that nobody knows is empty.
    """

    program: Program | None
    reason: str
    name: str
    namespace: str


def instances_of(launch: Launch, library: Library) -> tuple[tuple[Instance, ...], NodeParameters]:
    """The nodes in the order in which they are started, and the params of each."""
    known = [_called(node, *_program(node, library)) for node in launch.nodes]
    names = _names(launch.nodes, known)
    nodes = [_with_params(*each) for each in zip(launch.nodes, known, names, strict=True)]
    parameters = NodeParameters(zip(names, nodes, strict=True))
    containers = {name: name for name, node in zip(names, nodes, strict=True) if node.kind == "container"}
    made = (_instance(node, name, containers, parameters, each) for node, name, each in zip(nodes, names, known, strict=True))
    return tuple(made), parameters


def program_of(node: Node) -> str:
    """What a node runs, for people: ``package/executable``, or the class of a component."""
    return node.plugin if node.plugin is not None else f"{node.package}/{node.executable}"


def _program(node: Node, library: Library) -> tuple[Program | None, str]:
    """What a node runs, if that is known; else why it is not, for people."""
    roles: tuple[Role, ...] = ("package", "executable")
    for role in roles:
        if not node.knows(role):
            return None, f"its {role} depends on something that is not here"
    if node.plugin is not None:
        found, table, name = library.component(node.package, node.plugin), "components", node.plugin
    else:
        found, table, name = library.executable(node.package, node.executable), "executables", node.executable
    if found is not None:
        return found, ""
    return None, library.why_unknown(table, name, node.package) or f"no library knows {program_of(node)}"


def _called(node: Node, program: Program | None, reason: str) -> _Known:
    """With the name and namespace that launch gives it, or else those that it gives itself."""
    name, namespace = node.name, node.namespace
    if program is not None and not (name and node.has_namespace):
        provisional = f"{namespace}{name or '?'}"
        start = _start(node, RclNamer(namespace, provisional), NodeParameters([(provisional, node)]), program)
        variants = program.variant(start)
        if not name:
            name = _said(variants, "node", start)
        if not node.has_namespace and (own := _said(variants, "namespace", start)).startswith("/"):
            namespace = f"{own.rstrip('/')}/"
    return _Known(program, reason, name if name == node.name or is_node_name(name) else "", namespace)


def _said(variants: Sequence[Variant], key: str, start: Start) -> str:
    """What all variants that it may be in say; empty where they do not agree, or it cannot be known."""
    texts = {getattr(each, key) for each in variants}
    text = texts.pop() if len(texts) == 1 else ""
    found = fill(parse(text), start) if text else ""
    return found if isinstance(found, str) else ""


def _names(nodes: Sequence[Node], known: Sequence[_Known]) -> list[str]:
    """The full names. A node whose name nobody knows is called by its program: ``/(talker)``."""
    seen: Counter[str] = Counter()
    names: list[str] = []
    for node, its in zip(nodes, known, strict=True):
        name = f"{its.namespace}{its.name}"
        if not its.name:
            program = node.plugin or node.executable or "?"
            name = f"{its.namespace}({program})"
            seen[name] += 1
            if seen[name] > 1:
                name = f"{its.namespace}({program} {seen[name]})"
        names.append(name)
    return names


def _with_params(node: Node, known: _Known, name: str) -> Node:
    """The node with the params that it ends up with under the name that it gives itself, where launch gives none."""
    if node.own_as is None or not known.name:
        return node
    return node._replace(**node.own_as(name)._asdict())


def _instance(node: Node, name: str, containers: Mapping[str, str], parameters: NodeParameters, known: _Known) -> Instance:
    certain = node.knows("namespace") and not node.fatal and not any(condition.assumed for condition in node.conditions)
    unknown_remaps = [each.patterns for each in node.open_remaps if each.patterns is not None]
    namer = RclNamer(known.namespace, name, node.remaps, unknown_remaps, node.own, is_named=bool(node.name))
    part = Interface([], [], {}, [], has_template=False)
    program, variants = known.program, tuple[Variant, ...]()
    if program is not None:
        start = _start(node, namer, parameters, program)
        variants = program.variant(start)
        part = instantiate(program, start, namer, name, certain=certain)
    host = name
    if node.kind == "composable":
        target = node.container or ""
        host = containers.get(target if target.startswith("/") else f"/{target}", "")
    return Instance(
        node=node,
        name=name,
        program=program_of(node),
        kind=_KINDS.get(node.kind, "node"),
        knowledge="unknown" if known.reason else "template" if part.has_template else "known",
        reason=known.reason,
        host=host,
        open=part.open,
        doubts=tuple(dict.fromkeys(part.doubts)),
        endpoints=tuple(sorted(part.endpoints, key=lambda each: (each.role, each.name))),
        readings=tuple(part.readings),
        looked_up={},
        namer=namer,
        certain=certain,
        client="" if program is None else program.client,
        literals=part.literals,
        lifecycle=node.kind == "lifecycle" or (bool(variants) and all(each.lifecycle for each in variants)),
        undeclared=not variants or any(each.undeclared for each in variants),
    )


def _start(node: Node, namer: RclNamer, parameters: NodeParameters, program: Program) -> Start:
    words = () if node.process is None else node.process.arguments
    line = CommandLine(tuple(words), (), {}, node.knows("arguments"))
    return Start(namer, line, parameters, program.options)

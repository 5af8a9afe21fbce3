"""The nodes of a ROS 2 launch with what libraries say of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import partial

from launchlint.graph.command_line import CommandLine
from launchlint.graph.connections import Instance
from launchlint.graph.earlier import Earlier
from launchlint.graph.instantiate import Interface, instantiate
from launchlint.graph.names_rcl import RclNamer
from launchlint.graph.parameters import NodeParameters
from launchlint.graph.situation import Start
from launchlint.library.lookup import Library
from launchlint.library.program import Program, Variant
from launchlint.library.template import fill, parse
from launchlint.model import Launch, Node, Role
from launchlint.named_tuple import NamedTuple
from launchlint.rcl.names import is_node_name
from launchlint.source import Place

_KINDS = {"container": "container", "composable": "component"}


class _Known(NamedTuple):
    """What is known of what a node runs; ``reason``: why nothing is, for people. ``name`` and ``namespace`` are those that it ends up with.

    A name that nobody knows is empty. ``node`` has the params that it ends up with, too.
    """

    node: Node
    program: Program | None
    reason: str
    name: str
    namespace: str


def instances_of(launch: Launch, library: Library, earlier: Earlier) -> tuple[tuple[Instance, ...], NodeParameters]:
    """The nodes in the order in which they are started, and the params of each; ``earlier`` are other configurations of the entry file."""
    known = [earlier.process(node, partial(_known, library)) for node in launch.nodes]
    names = _names(known)
    parameters = NodeParameters((name, its.node) for name, its in zip(names, known, strict=True))
    containers = {name: name for name, its in zip(names, known, strict=True) if its.node.kind == "container"}
    found: list[Instance] = []
    before: Counter[tuple[str, Place]] = Counter()
    for name, its in zip(names, known, strict=True):
        host, key = name, (its.node.full_name, its.node.origin.place)
        if its.node.kind == "composable":
            target = its.node.container or ""
            host = containers.get(target if target.startswith("/") else f"/{target}", "")
        make = partial(_instance, its, name, host, parameters)
        found.append(earlier.instance(its.node, (its, name, host), parameters, make, before[key]))
        before[key] += 1
    return tuple(found), parameters


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


def _known(library: Library, node: Node) -> _Known:
    """With the name and namespace that launch gives it, or else those that it gives itself."""
    program, reason = _program(node, library)
    name, namespace = node.name, node.namespace
    if program is not None and not (name and node.has_namespace):
        provisional = f"{namespace}{name or '?'}"
        start = _start(node, RclNamer(namespace, provisional), NodeParameters([(provisional, node)]), program)
        variants = program.variant(start)
        if not name:
            name = _said(variants, "node", start)
        if not node.has_namespace and (own := _said(variants, "namespace", start).strip("/")):
            namespace = f"/{own}/"  # rcl_node_init puts the slash before it where there is none
    name = name if name == node.name or is_node_name(name) else ""
    if node.own_as is not None and name:  # what its params are under the name that it gives itself
        node = node._replace(**node.own_as(f"{namespace}{name}")._asdict())
    return _Known(node, program, reason, name, namespace)


def _said(variants: Sequence[Variant], key: str, start: Start) -> str:
    """What all variants that it may be in say; empty where they do not agree, or it cannot be known."""
    texts = {getattr(each, key) for each in variants}
    text = texts.pop() if len(texts) == 1 else ""
    found = fill(parse(text), start) if text else ""
    return found if isinstance(found, str) else ""


def _names(known: Sequence[_Known]) -> list[str]:
    """The full names. A node whose name nobody knows is called by its program: ``/(talker)``."""
    seen: Counter[str] = Counter()
    names: list[str] = []
    for its in known:
        name = f"{its.namespace}{its.name}"
        if not its.name:
            program = its.node.plugin or its.node.executable or "?"
            name = f"{its.namespace}({program})"
            seen[name] += 1
            if seen[name] > 1:
                name = f"{its.namespace}({program} {seen[name]})"
        names.append(name)
    return names


def _instance(known: _Known, name: str, host: str, parameters: NodeParameters) -> Instance:
    node = known.node
    certain = node.knows("namespace") and not node.fatal and not any(condition.assumed for condition in node.conditions)
    unknown_remaps = [each.patterns for each in node.open_remaps if each.patterns is not None]
    namer = RclNamer(known.namespace, name, node.remaps, unknown_remaps, node.own, is_named=bool(node.name))
    part = Interface([], [], {}, [], has_template=False)
    program, variants = known.program, tuple[Variant, ...]()
    if program is not None:
        start = _start(node, namer, parameters, program)
        variants = program.variant(start)
        part = instantiate(program, start, namer, name, certain=certain)
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
        managed=not variants or any(each.managed for each in variants),
        undeclared=not variants or any(each.undeclared for each in variants),
    )


def _start(node: Node, namer: RclNamer, parameters: NodeParameters, program: Program) -> Start:
    words = () if node.process is None else node.process.arguments
    line = CommandLine(tuple(words), (), {}, node.knows("arguments"))
    return Start(namer, line, parameters, program.options)

"""The nodes of a ROS 2 launch with what libraries say of them.

What launchlint ships, and what it reads from sources, is of ROS 1: a node of the same package and name says other things there. So only
what a user's library says of a node counts.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from launchlint.graph.command_line import CommandLine
from launchlint.graph.connections import Instance
from launchlint.graph.instantiate import Interface, instantiate
from launchlint.graph.names_rcl import RclNamer
from launchlint.graph.parameters import NodeParameters
from launchlint.graph.situation import Start
from launchlint.library.lookup import Library
from launchlint.model import Launch, Node, Role

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.library.program import Program

_KINDS = {"container": "container", "composable": "component"}


def instances_of(launch: Launch, library: Library) -> tuple[tuple[Instance, ...], NodeParameters]:
    """The nodes in the order in which they are started, and the params of each."""
    names = _names(launch.nodes)
    parameters = NodeParameters(zip(names, launch.nodes, strict=True))
    containers = {name: name for name, node in zip(names, launch.nodes, strict=True) if node.kind == "container"}
    made = (_instance(node, name, containers, parameters, library) for node, name in zip(launch.nodes, names, strict=True))
    return tuple(made), parameters


def _names(nodes: tuple[Node, ...]) -> list[str]:
    """The full names. A node that launch gives none has one that only its program knows, and is called by the program: ``/(talker)``."""
    seen: Counter[str] = Counter()
    names: list[str] = []
    for node in nodes:
        name = node.full_name
        if not node.name:
            program = node.plugin or node.executable or "?"
            name = f"{node.namespace}({program})"
            seen[name] += 1
            if seen[name] > 1:
                name = f"{node.namespace}({program} {seen[name]})"
        names.append(name)
    return names


def _instance(node: Node, name: str, containers: Mapping[str, str], parameters: NodeParameters, library: Library) -> Instance:
    certain = node.knows("namespace") and not any(condition.assumed for condition in node.conditions)
    what = node.plugin if node.plugin is not None else node.executable
    program = node.plugin if node.plugin is not None else f"{node.package}/{node.executable}"
    namer = RclNamer(node.namespace, name, node.remaps, [each.patterns for each in node.open_remaps if each.patterns is not None])
    reason = _unknown_start(node)
    known = None if reason else library.component(node.package, what) if node.plugin is not None else library.executable(node.package, what)
    part = Interface([], [], {}, [], has_template=False)
    client = ""
    if known is not None:
        client = known.client
        part = instantiate(known, _start(node, namer, parameters, known), namer, name, certain=certain)
    elif not reason:
        reason = f"no library knows {program}"
    host = name
    if node.kind == "composable":
        target = node.container or ""
        host = containers.get(target if target.startswith("/") else f"/{target}", "")
    return Instance(
        node=node,
        name=name,
        program=program,
        kind=_KINDS.get(node.kind, "node"),
        knowledge="unknown" if reason else "template" if part.has_template else "known",
        reason=reason,
        host=host,
        open=part.open,
        doubts=tuple(dict.fromkeys(part.doubts)),
        endpoints=tuple(sorted(part.endpoints, key=lambda each: (each.role, each.name))),
        readings=tuple(part.readings),
        looked_up={},
        namer=namer,
        certain=certain,
        client=client,
        literals=part.literals,
    )


def _unknown_start(node: Node) -> str:
    """Why it cannot be known what is started, for people."""
    roles: tuple[Role, ...] = ("package", "executable")
    return next((f"its {role} depends on something that is not here" for role in roles if not node.knows(role)), "")


def _start(node: Node, namer: RclNamer, parameters: NodeParameters, program: Program) -> Start:
    words = () if node.process is None else node.process.arguments
    line = CommandLine(tuple(words), (), {}, node.knows("arguments"))
    return Start(namer, line, parameters, program.options)

"""Joining a launch with a library: the paper's Make Connections.

Each node becomes an :class:`~launchlint.graph.connections.Instance`; what all of them say under one name meets in a channel. Linear in
nodes, endpoints and connections: publishers and subscribers of a topic are listed, never paired.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from launchlint.evaluate.names import UNKNOWN_NAMESPACE
from launchlint.graph.command_line import CommandLine, command_line
from launchlint.graph.connections import CATEGORY, OFFERS, Channel, ConnectionGraph, Doubt, Endpoint, Instance, Missing, Reading
from launchlint.graph.frames import Frame, frames
from launchlint.graph.instantiate import Interface, instantiate
from launchlint.graph.names import Namer, NodeletNamer, absolute
from launchlint.graph.parameters import Parameters
from launchlint.graph.situation import Start
from launchlint.library.lookup import Library
from launchlint.library.program import Program
from launchlint.library.terms import CATEGORIES
from launchlint.model import Launch, Node

MOST_DOUBTS = 50
"""Names that are not known but of which something is; with more of them any name may be one: looking at each would take too long."""
NODELET = ("nodelet", "nodelet")
"""The executable that runs, loads and manages nodelets."""
LOAD = "~load_nodelet"
"""The service of a nodelet manager; who loads a nodelet calls it by the name of the manager, which nothing else ties to it."""


class _Process(NamedTuple):
    """What a node is as a process. ``mode`` is the first argument of the nodelet executable: manager, load, standalone, unload."""

    node: Node
    name: str
    line: CommandLine
    program: Program | None
    namer: Namer
    mode: str


def connect(launch: Launch, library: Library) -> ConnectionGraph:
    """The connection graph of ``launch``, tests included."""
    parameters = Parameters(launch.parameters, launch.more_parameters)
    processes = [_process(node, library) for node in (*launch.nodes, *launch.tests)]
    managers = {process.namer.resolve(LOAD).name: process for process in processes if _is_manager(process)}
    instances = tuple(_instance(process, managers, parameters, library) for process in processes)
    channels: dict[tuple[str, str], Channel] = {}
    readers: dict[str, list[Reading]] = {}
    for instance in instances:
        for endpoint in instance.endpoints:
            key = (endpoint.kind, endpoint.name)
            channel = channels.get(key)
            if channel is None:
                channel = channels[key] = Channel(*key, [], [])
            (channel.offers if endpoint.role in OFFERS else channel.uses).append(endpoint)
        for reading in instance.readings:
            readers.setdefault(reading.name, []).append(reading)
    missing = {category: _missing(launch, instances, category) for category in CATEGORIES}
    ordered = {key: channels[key] for key in sorted(channels)}
    return ConnectionGraph(launch, instances, ordered, parameters, {name: tuple(readers[name]) for name in sorted(readers)}, missing)


def _missing(launch: Launch, instances: tuple[Instance, ...], category: str) -> Missing:
    """What of a category may be there although the graph does not show it."""
    doubts: list[tuple[Doubt, str]] = []
    reason = "" if launch.complete else "an include could not be followed"
    for instance in instances:
        if reason:
            break
        if instance.is_unknown:
            reason = f"it is not known what {instance.name} does: {instance.reason}"
        elif UNKNOWN_NAMESPACE in instance.node.namespace:
            reason = f"the namespace of {instance.node.name} is not known"
        elif category in instance.open:
            reason = f"{instance.name} may have more {category}: {instance.open[category]}"
        doubts.extend((doubt, instance.name) for doubt in instance.doubts if doubt.category == category)
        if len(doubts) > MOST_DOUBTS:
            reason = f"many nodes, {instance.name} among them, have {category} whose names cannot be known"
    return Missing(reason, tuple(doubts))


def _process(node: Node, library: Library) -> _Process:
    line = command_line(node)
    program = None if node.unknown & {"pkg", "type"} else library.executable(node.package, node.executable)
    client = program.client if program is not None else "rospy" if node.executable.endswith(".py") else ""
    namer = Namer(_namespace(node, line), node.full_name, line.rules, client)
    mode = line.words[0] if (node.package, node.executable) == NODELET and line.words else ""
    return _Process(node, node.full_name, line, program, namer, mode)


def _instance(process: _Process, managers: dict[str, _Process], parameters: Parameters, library: Library) -> Instance:
    node, name = process.node, process.name
    certain = UNKNOWN_NAMESPACE not in node.namespace and not any(condition.assumed for condition in node.conditions)
    unknown = _unknown_start(node)
    parts: list[Interface] = []
    looked_up: dict[str, str] = {}
    shown: list[Frame] = []
    reason = unknown
    kind, host, program, namer, client = "node", process.namer.graph_name, f"{node.package}/{node.executable}", process.namer, ""
    if process.program is not None and not unknown:
        client = process.program.client
        start = Start(namer, process.line, parameters, process.program.options, named="name" not in node.unknown)
        parts.append(instantiate(process.program, start, namer, namer.graph_name, certain=certain))
        looked_up.update(start.looked_up)
        shown.extend(frames(process.program, start, namer, certain=certain))
    elif not unknown:
        reason = f"no library knows {program}"
    if (node.package, node.executable) == NODELET and not unknown:
        if process.mode == "manager":
            kind = "manager"
        elif process.mode in ("load", "standalone") and len(process.line.words) > (2 if process.mode == "load" else 1):
            kind, program = "nodelet", process.line.words[1]
            if process.mode == "load":
                manager = managers.get(process.namer.resolve(f"{process.line.words[2]}/load_nodelet").name)
                host = "" if manager is None else manager.namer.graph_name
                namer = NodeletNamer(namer, None if manager is None else manager.namer)
            known = library.nodelet(program)
            if known is None:
                reason = f"no library knows the nodelet class {program}"
            else:
                skip = 3 if process.mode == "load" else 2
                start = Start(namer, process.line, parameters, known.options, skip, named="name" not in node.unknown)
                parts.append(instantiate(known, start, namer, host, certain=certain))
                looked_up.update(start.looked_up)
                shown.extend(frames(known, start, namer, certain=certain))
        elif process.mode != "unload":
            reason = "its args do not say what it loads"
    if "name" in node.unknown:
        parts = [_without_private(part, namer.graph_name) for part in parts]
    knowledge = "unknown" if reason else "template" if any(part.has_template for part in parts) and kind != "manager" else "known"
    opened: dict[str, str] = {}
    doubts = tuple(dict.fromkeys(doubt for part in parts for doubt in part.doubts))
    for part in parts:
        opened.update(part.open)
    endpoints = _unique(endpoint for part in parts for endpoint in part.endpoints)
    readings = tuple(reading for part in parts for reading in part.readings)
    return Instance(
        node=node,
        name=name,
        program=program,
        kind=kind,
        knowledge=knowledge,
        reason=reason,
        host=host,
        open=opened,
        doubts=doubts,
        endpoints=endpoints,
        readings=readings,
        looked_up=looked_up,
        namer=namer,
        certain=certain,
        client=client,
        frames=tuple(shown),
    )


def _unknown_start(node: Node) -> str:
    """Why it cannot be known how the node is started, for people."""
    for attribute, what in (("pkg", "package"), ("type", "executable"), ("ns", "namespace"), ("remap", "remapping")):
        if attribute in node.unknown:
            return f"its {what} depends on something that is not here"
    if not node.name:
        return "it has no name"
    return ""


def _without_private(part: Interface, own: str) -> Interface:
    """The interface of a node whose name is not known: what lies below its name may be anywhere beside it."""
    below, parent = f"{own}/", own.rpartition("/")[0]
    endpoints = [endpoint for endpoint in part.endpoints if not endpoint.name.startswith(below)]
    doubts = [
        Doubt(CATEGORY[endpoint.role], f"{parent}/*{endpoint.name[len(own) :]}", endpoint.declared)
        for endpoint in part.endpoints
        if endpoint.name.startswith(below)
    ]
    readings = [reading for reading in part.readings if not reading.name.startswith(below)]
    return part._replace(endpoints=endpoints, doubts=[*part.doubts, *doubts], readings=readings)


def _namespace(node: Node, line: CommandLine) -> str:
    """The namespace of the process: that of the node, unless its args or its environment say another (roslaunch.core.setup_env)."""
    given = [each.value for each in node.environment if each.name == "ROS_NAMESPACE"]
    if line.namespace is not None:
        given.append(line.namespace)
    return absolute(given[-1], "/", "") if given else node.namespace


def _is_manager(process: _Process) -> bool:
    """Whether nodelets can be loaded into it: a nodelet manager, or any program that serves what one serves."""
    if (process.node.package, process.node.executable) == NODELET or process.program is None:
        return process.mode == "manager"
    declarations = (declaration for variant in process.program.variants for declaration in variant.declarations)
    return any(declaration.category == "services" and declaration.name == LOAD for declaration in declarations)


def _unique(endpoints: Iterable[Endpoint]) -> tuple[Endpoint, ...]:
    """Each role and name once: what is certain before what is not."""
    found: dict[tuple[str, str, str], Endpoint] = {}
    for endpoint in endpoints:
        key = (endpoint.role, endpoint.name, endpoint.process)
        known = found.get(key)
        if known is None or (endpoint.certain, bool(endpoint.type)) > (known.certain, bool(known.type)):
            found[key] = endpoint
    return tuple(found[key] for key in sorted(found))

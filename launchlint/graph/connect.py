"""Joining a launch with a library: the paper's Make Connections.

Each node becomes an :class:`~launchlint.graph.connections.Instance`; what all of them say under one name meets in a channel. Linear in
nodes, endpoints and connections: publishers and subscribers of a topic are listed, never paired.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial

from launchlint.evaluate.names import UNKNOWN_NAMESPACE
from launchlint.graph.command_line import CommandLine, command_line
from launchlint.graph.connections import CATEGORY, KINDS, OFFERS, Channel, ConnectionGraph, Doubt, Endpoint, Instance, Reading
from launchlint.graph.earlier import Earlier
from launchlint.graph.frames import Frame, frames
from launchlint.graph.instantiate import Interface, instantiate
from launchlint.graph.names import Namer, NodeletNamer, absolute
from launchlint.graph.parameters import Parameters
from launchlint.graph.plausible import Unseen
from launchlint.graph.situation import Start
from launchlint.library.lookup import Library
from launchlint.library.program import Program
from launchlint.library.template import UNKNOWN
from launchlint.model import ROS1, Launch, Node, Role
from launchlint.named_tuple import NamedTuple

NODELET = ("nodelet", "nodelet")
"""The executable that runs, loads and manages nodelets."""
_PLACELESS = f"/{UNKNOWN_NAMESPACE}/"
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


def connect(launch: Launch, library: Library, earlier: Earlier | None = None) -> ConnectionGraph:
    """The connection graph of ``launch``, tests included. ``earlier`` are the other configurations of the same entry file, if any."""
    earlier = earlier or Earlier()
    if launch.dialect != ROS1:
        from launchlint.graph.connect_ros2 import instances_of

        nodes, own = instances_of(launch, library.of_launch(launch.dialect), earlier)
        return _graph(launch, nodes, own, earlier)
    parameters = Parameters(launch.parameters, launch.more_parameters)
    processes = [earlier.process(node, partial(_process, library)) for node in (*launch.nodes, *launch.tests)]
    managers = {process.namer.resolve(LOAD).name: process for process in processes if _is_manager(process)}
    found: list[Instance] = []
    for process in processes:
        manager = _manager(process, managers)
        make = partial(_instance, process, manager, parameters, library)
        found.append(earlier.instance(process.node, (process, manager), parameters, make))
    return _graph(launch, tuple(found), parameters, earlier)


def _graph(launch: Launch, instances: tuple[Instance, ...], parameters: Parameters, earlier: Earlier) -> ConnectionGraph:
    """What all nodes say under one name meets in a channel."""
    channels: dict[tuple[str, str], Channel] = {}
    readers: dict[str, list[Reading]] = {}
    for instance in instances:
        for endpoint in instance.endpoints:
            role = endpoint.role
            key = (KINDS[role], endpoint.name)
            channel = channels.get(key)
            if channel is None:
                channel = channels[key] = Channel(*key)
            (channel.offers if role in OFFERS else channel.uses).append(endpoint)
        for reading in instance.readings:
            readers.setdefault(reading.name, []).append(reading)
    unseen = Unseen(launch, instances, parameters, earlier)
    ordered = {key: channels[key] for key in sorted(channels)}
    return ConnectionGraph(launch, instances, ordered, parameters, {name: tuple(readers[name]) for name in sorted(readers)}, unseen)


def _process(library: Library, node: Node) -> _Process:
    line = command_line(node)
    program = library.executable(node.package, node.executable) if node.knows("package", "executable") else None
    client = program.client if program is not None else "rospy" if node.executable.endswith(".py") else ""
    namer = Namer(_namespace(node, line), node.full_name, line.rules, client, line.open)
    first = line.words[0] if (node.package, node.executable) == NODELET and line.words else ""
    return _Process(node, node.full_name, line, program, namer, first if isinstance(first, str) else "")


def _instance(process: _Process, manager: _Process | None, parameters: Parameters, library: Library) -> Instance:
    node, name = process.node, process.name
    certain = not any(condition.assumed for condition in node.conditions)
    unknown = _unknown_start(node)
    parts: list[Interface] = []
    looked_up: dict[str, str] = {}
    shown: list[Frame] = []
    reason = unknown
    kind, host, program, namer, client = "node", process.namer.graph_name, f"{node.package}/{node.executable}", process.namer, ""
    if process.program is not None and not unknown:
        client = process.program.client
        start = _start(process, namer, parameters, process.program)
        parts.append(instantiate(process.program, start, namer, namer.graph_name, certain=certain))
        looked_up.update(start.looked_up)
        shown.extend(frames(process.program, start, namer, certain=certain))
    elif not unknown:
        reason = library.why_unknown("executables", node.executable, node.package) or f"no library knows {program}"
    if (node.package, node.executable) == NODELET and not unknown:
        if process.mode == "manager":
            kind = "manager"
        elif process.mode in ("load", "standalone") and (class_ := _loaded(process.line, process.mode)):
            kind, program = "nodelet", class_
            if process.mode == "load":
                host = "" if manager is None else manager.namer.graph_name
                namer = NodeletNamer(namer, None if manager is None else manager.namer, _around_manager(process))
            known = library.nodelet(program)
            if known is None:
                reason = library.why_unknown("nodelets", program) or f"no library knows the nodelet class {program}"
            else:
                skip = 3 if process.mode == "load" else 2
                start = _start(process, namer, parameters, known, skip)
                parts.append(instantiate(known, start, namer, host, certain=certain))
                looked_up.update(start.looked_up)
                shown.extend(frames(known, start, namer, certain=certain))
        elif process.mode != "unload":
            reason = "its args do not say what it loads"
    if not node.knows("name"):
        parts = [_without_private(part, namer.graph_name, node.patterns.get("name", "*")) for part in parts]
    if UNKNOWN_NAMESPACE in namer.namespace:
        parts = [_anywhere(part) for part in parts]
    knowledge = "unknown" if reason else "template" if any(part.has_template for part in parts) and kind != "manager" else "known"
    opened: dict[str, str] = {}
    doubts = tuple(dict.fromkeys(doubt for part in parts for doubt in part.doubts))
    for part in parts:
        opened.update(part.open)
    endpoints = _unique(endpoint for part in parts for endpoint in part.endpoints)
    told = {endpoint.unremapped for endpoint in endpoints}
    for endpoint in (endpoint for part in parts for endpoint in part.endpoints):
        if endpoint.unremapped not in told:  # remapped to where another of its names is: the code says both
            looked_up.setdefault(endpoint.unremapped, endpoint.declared)
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
        certain=certain and UNKNOWN_NAMESPACE not in namer.namespace,
        client=client,
        frames=tuple(shown),
        literals=tuple(text for part in parts for text in part.literals),
    )


def _unknown_start(node: Node) -> str:
    """Why it cannot be known what is started, for people."""
    roles: tuple[Role, ...] = ("package", "executable")
    for role in roles:
        if not node.knows(role):
            return f"its {role} depends on something that is not here"
    if not node.name:
        return "it has no name"
    return ""


def _start(process: _Process, namer: Namer, parameters: Parameters, program: Program, skip: int = 0) -> Start:
    named, placed = process.node.knows("name", "namespace"), process.node.knows("namespace")
    return Start(namer, process.line, parameters, program.options, skip, named=named, placed=placed)


def _loaded(line: CommandLine, mode: str) -> str:
    """The class of the nodelet that is loaded; empty where ``args`` do not say one, or no manager for it."""
    class_ = line.words[1] if len(line.words) > 1 else ""
    enough = mode != "load" or len(line.words) > 2 or not line.known
    return class_ if isinstance(class_, str) and enough else ""


def _manager(process: _Process, managers: dict[str, _Process]) -> _Process | None:
    """The process that runs what ``process`` loads as a nodelet; None where it is not of this launch, or not known."""
    if process.mode != "load":
        return None
    given = process.line.words[2] if len(process.line.words) > 2 else UNKNOWN
    return managers.get(process.namer.resolve(f"{given}/load_nodelet").name) if isinstance(given, str) else None


def _around_manager(process: _Process) -> str:
    """The namespace of the manager that ``process`` loads a nodelet into, by its name; an unknown one where that is not known."""
    given = process.line.words[2] if len(process.line.words) > 2 else UNKNOWN
    if not isinstance(given, str):
        return f"/{UNKNOWN_NAMESPACE}"
    return absolute(given, process.namer.namespace, process.namer.graph_name).rpartition("/")[0] or "/"


def _without_private(part: Interface, own: str, pattern: str) -> Interface:
    """The interface of a node of whose name only ``pattern`` is known: what lies below its name may lie below any such name beside it."""
    below, beside = f"{own}/", f"{own.rpartition('/')[0]}/{pattern}"
    endpoints = [endpoint for endpoint in part.endpoints if not endpoint.name.startswith(below)]
    doubts = [each._replace(pattern=beside + each.pattern[len(own) :]) if each.pattern.startswith(below) else each for each in part.doubts]
    doubts += [_doubt(each, beside + each.name[len(own) :]) for each in part.endpoints if each.name.startswith(below)]
    readings = [reading for reading in part.readings if not reading.name.startswith(below)]
    return part._replace(endpoints=endpoints, doubts=doubts, readings=readings)


def _anywhere(part: Interface) -> Interface:
    """The interface of a node whose namespace is not known: what lies below that may lie anywhere."""
    endpoints = [each._replace(certain=False) if _PLACELESS in each.name else each for each in part.endpoints]
    doubts = [each._replace(pattern=_somewhere(each.pattern)) for each in part.doubts]
    doubts += [_doubt(each, _somewhere(each.name)) for each in part.endpoints if _PLACELESS in each.name]
    readings = [each._replace(certain=False) if _PLACELESS in each.name else each for each in part.readings]
    return part._replace(endpoints=endpoints, doubts=doubts, readings=readings)


def _somewhere(name: str) -> str:
    """The name with ``*`` for an unknown namespace and what is around it: such a namespace may begin with a slash."""
    _, unknown, inner = name.rpartition(_PLACELESS)
    return f"*/{inner}" if unknown else name


def _doubt(endpoint: Endpoint, pattern: str) -> Doubt:
    return Doubt(CATEGORY[endpoint.role], pattern, endpoint.declared, endpoint.type)


def _namespace(node: Node, line: CommandLine) -> str:
    """The namespace of the process: that of the node, unless its args or its environment say another (roslaunch.core.setup_env)."""
    given = [each.value for each in node.environment if each.name == "ROS_NAMESPACE"]
    if line.namespace is not None:
        given.append(line.namespace)
    if given and "*" in given[-1]:
        return f"/{UNKNOWN_NAMESPACE}"
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

"""One entry file as the page's data: nodes, channels and params by number, each with its places, findings and marks."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence, Set

from launchlint.finding import Finding
from launchlint.graph.topology import Connection, Topology, TopologyChannel, TopologyNode, TopologyParam
from launchlint.report.html.attachment import Attachment
from launchlint.report.html.material import EntryMaterial
from launchlint.report.html.places import Places
from launchlint.report.html.plain import Plain
from launchlint.report.html.tally import tally
from launchlint.report.html.union import REMOVED, Marked, Union, alone, united
from launchlint.sight import Sight

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

WHEN = {"subscriber": "on_subscriber", "message": "on_message"}
"""When a name appears that is not there from the start; by the word of the library format."""


def entry_data(
    material: EntryMaterial, findings: Sequence[Finding], new: Set[int], learn: Mapping[str, str], plain: Plain, places: Places, *,
    compared: bool,
) -> dict[str, Any]:  # fmt: skip
    """The ``Entry`` of ``js/data.d.ts``. ``findings`` are all of the page, ``new`` the numbers of new ones; ``learn`` as in Material."""
    differs = compared and material.topology != material.before
    state = united(material.before, material.topology) if differs else alone(material.topology or _nothing(material))
    entry = _EntryData(state, material, findings, plain, places)
    gone = material.topology is None and material.before is not None
    file = places.file(material.path, base=gone)
    nodes, params = entry.nodes(learn), entry.params()
    fresh = sum(each in new for each in material.findings)
    changes = tally(material, nodes, params, fresh).words if compared and material.before is not None and not gone else []
    return {
        "file": file,
        "verdict": material.verdict.word,
        "launcher": material.verdict.launcher,
        "why": plain.text(material.verdict.why),
        "withArgs": plain.text(material.verdict.with_args),
        "configurations": [plain.text(each) for each in state.configurations],
        "complete": material.topology is None or material.topology.complete,
        "sight": [material.sight.known, material.sight.nodes],
        "mend": mend({each: learn[each] for each in entry.unknown() if each in learn}, plain.text(material.probe), plain),
        "containers": entry.containers(),
        "nodes": nodes,
        "channels": entry.channels(),
        "connections": entry.connections(),
        "params": params,
        "findings": list(material.findings),
        "findingsOnly": _shown_in(material, state.configurations),
        "given": [[[plain.text(name), plain.text(value)] for name, value in each] for each in _given(material, state.configurations)],
        "whole": material.whole,
        "command": plain.text(material.command),
        "changes": [[looks, plain.text(words)] for looks, words in changes],
        "fixed": list(material.fixed),
        **_programs(material.sight, plain),
        **_mark(REMOVED if gone else "added" if compared and material.before is None else ""),
    }


MOST_PACKAGES = 6
"""Packages that one sentence names."""


def mend(learn: Mapping[str, str], probe: str, plain: Plain) -> dict[str, str]:
    """What makes the programs of ``learn`` known: one ``command`` (empty: none helps), and one sentence on the others, ``advice``."""
    absent = sorted({program.partition("/")[0].partition("::")[0] for program, how in learn.items() if how == "sources"})
    names = [plain.name(each) for each in absent[:MOST_PACKAGES]]
    if len(absent) > MOST_PACKAGES:
        names.append(f"{len(absent) - MOST_PACKAGES} more")
    listed = " and ".join(filter(None, (", ".join(names[:-1]), *names[-1:])))
    are, them = ("are", "them") if len(absent) > 1 else ("is", "it")
    where = f"{listed} {are} not in the workspace: put the sources there, or name their directory with --workspace"
    advice = f"{where}, and launchlint reads {them} by itself"
    return {"command": probe if "probe" in learn.values() else "", "advice": advice if absent else ""}


def _programs(sight: Sight, plain: Plain) -> dict[str, Any]:
    """The launch files in Python that are not known as a whole, with the reasons; nothing where there are none."""
    open_ = [each for each in sight.followed if each.state != "resolved"]
    if not open_:
        return {}
    return {
        "python": [
            {"file": plain.text(each.path), "state": each.state, "reasons": [[line, plain.text(why)] for line, why in each.reasons]}
            for each in open_
        ]
    }


def _given(material: EntryMaterial, configurations: Sequence[str]) -> list[Sequence[tuple[str, str]]]:
    """The args of each configuration, without those that it is started with anyway; of a former state they are not known."""
    start = set(material.given[0]) if material.given else set()
    known = {" ".join(f"{name}:={value}" for name, value in each): [pair for pair in each if pair not in start] for each in material.given}
    return [known.get(each, []) for each in configurations]


def _shown_in(material: EntryMaterial, configurations: Sequence[str]) -> list[list[int]]:
    """For each finding the numbers of the configurations that have it."""
    numbers = {each: number for number, each in enumerate(configurations)}
    spelled = [numbers.get(" ".join(f"{name}:={value}" for name, value in each), -1) for each in material.given]
    shown = material.shown_in or [() for _ in material.findings]
    return [sorted({spelled[each] for each in those} - {-1}) for those in shown]


def _nothing(material: EntryMaterial) -> Topology:
    return Topology(material.path, ("",), True, (), (), (), (), ())


def _mark(mark: str) -> dict[str, str]:
    return {"mark": mark} if mark else {}


class _EntryData:
    """The parts of one entry file, numbered."""

    def __init__(self, state: Union, material: EntryMaterial, findings: Sequence[Finding], plain: Plain, places: Places) -> None:
        self._state = state
        self._plain = plain
        self._places = places
        self._details = material.details
        self._configurations = {name: number for number, name in enumerate(state.configurations)}
        self._containers: dict[int, int] = {}  # by identity: one stands under two ids
        self._order = list({id(each): each for each in state.containers.values()}.values())
        for number, marked in enumerate(self._order):
            self._containers[id(marked)] = number
        self._by_name: dict[str, list[tuple[int, Marked[TopologyNode]]]] = {}
        for number, node in enumerate(state.nodes):
            self._by_name.setdefault(node.item.name, []).append((number, node))
        self._attachment = Attachment([(index, findings[index]) for index in material.findings], material.extents)
        topology = material.topology or _nothing(material)
        self._of_channels = self._attachment.of_channels(topology)
        self._of_containers = self._attachment.of_containers(topology)

    def containers(self) -> list[dict[str, Any]]:
        found = []
        for marked in self._order:
            item, mark, base = marked.item, marked.mark, marked.base
            label = self._plain.path(item.label) if item.kind == "include" else self._plain.name(item.label)
            found.append(
                {
                    "kind": item.kind,
                    "label": label,
                    "namespace": self._plain.name(item.namespace),
                    "place": self._places.of(item.place, base=base),
                    "parent": self._container(item.parent, base=False),
                    **self._arguments(item.id, base=base),
                    "findings": [] if base else self._of_containers.get(item.id, []),
                    **_mark(mark),
                }
            )
        return found

    def _arguments(self, container: str, *, base: bool) -> dict[str, Any]:
        """The args of an include; nothing where it has none, as most containers."""
        known = () if base else self._details.arguments.get(container, ())
        text = self._plain.text
        said = [[text(each.name), *(None if value is None else text(value) for value in (each.value, each.default))] for each in known]
        return {"args": said} if said else {}

    def unknown(self) -> set[str]:
        """The programs of which nothing is known."""
        return {node.item.program for node in self._state.nodes if node.item.knowledge == "unknown" and not node.base}

    def nodes(self, learn: Mapping[str, str]) -> list[dict[str, Any]]:
        name, text = self._plain.name, self._plain.text
        found = []
        for marked in self._state.nodes:
            item, mark, base = marked.item, marked.mark, marked.base
            found.append(
                {
                    "name": name(item.name),
                    "program": name(item.program),
                    "package": name(item.package),
                    "executable": name(item.executable),
                    "kind": item.kind,
                    "knowledge": item.knowledge,
                    "reason": text(item.reason),
                    "learn": learn.get(item.program, "") if item.knowledge == "unknown" else "",
                    "host": name(item.host),
                    "machine": [] if base else [name(each) for each in self._details.machines.get((item.name, item.place), ())],
                    "namespace": name(item.namespace),
                    "isTest": item.is_test,
                    **({"lifecycle": True} if not base and (item.name, item.place) in self._details.lifecycle else {}),
                    "place": self._places.of(item.place, base=base),
                    "container": self._container(item.container, base=base),
                    "open": [[category, text(why)] for category, why in item.open],
                    "partly": [] if base else [[kind, name(each)] for kind, each in self._details.partly.get((item.name, item.place), ())],
                    "conditions": [text(each) for each in item.conditions],
                    "only": self._only(item.only),
                    "findings": [] if base else self._attachment.inside(item.place),
                    "related": [] if base else self._attachment.pointing_at(item.place),
                    **_mark(mark),
                }
            )
        return found

    def channels(self) -> list[dict[str, Any]]:
        of_actions = self._of_actions()
        found = []
        for marked in self._state.channels:
            item, mark = marked.item, marked.mark
            key = (item.kind, item.name)
            found.append(
                {
                    "kind": item.kind,
                    "name": self._plain.name(item.name),
                    "types": [self._plain.name(each) for each in item.types],
                    "hub": item.hub,
                    "plumbing": item.plumbing or key in of_actions,
                    "findings": self._of_channels.get(key, []),
                    "may": self._may(item),
                    **_mark(mark),
                }
            )
        return found

    def _may(self, channel: TopologyChannel) -> list[list[Any]]:
        """Who may be at an empty end."""
        found = []
        for offers in (True, False):
            for node, unknown, reason in self._details.doubts.get((channel.kind, channel.name, offers), ()):
                # The reason of a node of which nothing is known stands at the node: here it would stand as often as there are names.
                found.append([offers, self._plain.name(node), unknown, "" if unknown else self._plain.text(reason)])
        return found

    def connections(self) -> list[dict[str, Any]]:
        channels = {(each.item.kind, each.item.name): number for number, each in enumerate(self._state.channels)}
        found = []
        for marked in self._state.connections:
            item, mark, base = marked.item, marked.mark, marked.base
            channel = channels[item.kind, item.name]
            for node, only in self._nodes_of(item, base=base):
                found.append({"node": node, "channel": channel, **self._connection(item, base=base), "only": only, **_mark(mark)})
        return found

    def _connection(self, item: Connection, *, base: bool) -> dict[str, Any]:
        name = self._plain.name
        return {
            "role": item.role,
            "offers": item.offers,
            "declared": name(item.declared),
            "spelling": item.spelling,
            "unremapped": name(item.unremapped),
            "remaps": [[name(step.source), name(step.target), self._places.of(step.place, base=base)] for step in item.remaps],
            "type": name(item.type),
            "certain": item.certain,
            "when": WHEN.get(item.when, ""),
            "action": name(item.action),
            "evidence": [self._plain.text(each) for each in item.evidence],
            **({"qos": self._plain.text(item.qos)} if item.qos else {}),
        }

    def params(self) -> list[dict[str, Any]]:
        found = []
        for marked in self._state.params:
            item, mark, base = marked.item, marked.mark, marked.base
            readers = [number for reader in item.readers for number, node in self._by_name.get(reader, ()) if base or not node.base]
            found.append(
                {
                    "name": self._plain.name(item.name),
                    "value": self._plain.text(item.value),
                    "place": self._places.of(item.place, base=base),
                    "overrides": [] if base else self._overridden(item),
                    "readers": readers,
                    "only": self._only(item.only),
                    "findings": [] if base else self._attachment.inside(item.place),
                    **_mark(mark),
                }
            )
        return found

    def _overridden(self, param: TopologyParam) -> list[list[Any]]:
        earlier = self._details.overridden.get((param.name, param.place), ())
        return [[self._plain.text(value), self._places.of(place)] for value, place in earlier]

    def _container(self, id_: str, *, base: bool) -> int:
        marked = self._state.containers.get(f"base {id_}" if base else id_) if id_ else None
        return -1 if marked is None else self._containers[id(marked)]

    def _only(self, configurations: Iterable[str]) -> list[int]:
        return sorted(self._configurations[each] for each in configurations)

    def _of_actions(self) -> set[tuple[str, str]]:
        """The channels that are there only as parts of an action."""
        parts: dict[tuple[str, str], bool] = {}
        for each in self._state.connections:
            key = (each.item.kind, each.item.name)
            parts[key] = parts.get(key, True) and bool(each.item.action)
        return {key for key, is_part in parts.items() if is_part}

    def _nodes_of(self, connection: Connection, *, base: bool) -> list[tuple[int, list[int]]]:
        """The nodes that have a connection, each with the configurations in which it does.

        Topologies name the node. Where several have one name (alternatives of which one runs, or a mistake), it is each one that is there
        in the same configurations.
        """
        named = self._by_name.get(connection.node, ())
        nodes = [each for each in named if each[1].base == base] or named
        found = []
        for number, node in nodes:
            theirs = frozenset(connection.only) if not node.item.only else frozenset(node.item.only)
            mine = frozenset(connection.only) or theirs
            both = mine & theirs
            if both or not mine:
                found.append((number, self._only(both)))
        return found

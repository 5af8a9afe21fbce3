"""Records of runs → a library."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from launchlint import __version__
from launchlint.library.format import CATEGORIES, FORMAT, version_for
from launchlint.library.merge import merge_programs
from launchlint.model import ROS1, ROS2
from launchlint.probe.configuration import ProbeConfiguration
from launchlint.probe.record import PROGRAMS, LaunchRecord, NodeRecord, Note, Problem
from launchlint.probe.sources import Tree

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

OPEN = {
    "waits-for-service": "it waited for the service {}, whose type is not installed",
    "waits-for-message": "nothing could be sent to it on {}, and it may have more names once that comes",
    "waits-for-param": "it waited for the param {}",
    "waits-for-device": "it waited for {}, and may have more names once that is there",
    "waits": "it said: {}",
    "never-quiet": "there was still something new when it was stopped",
    "ended": "{}",
    "odd-names": "names that no node can have were left out",
    "too-much-output": "it was stopped because it printed without end",
    "too-much-memory": "it was stopped: {}",
    "too-much-disk": "it was stopped: {}",
    "too-many-processes": "it was stopped: {}",
    "unsteady": "{}",
    "exception": "it had an exception: {}",
    "error-logged": "it reported an error: {}",
    "device-missing": "it had no device: {}",
    "module-missing": "a Python module was missing: {}",
    "library-missing": "a shared library was missing: {}",
    "file-missing": "a file was missing: {}",
    "param-required": "a param was missing: {}",
    "arguments-required": "it wanted arguments: {}",
    "display-required": "it had no display: {}",
    "network": "it had no network: {}",
    "not-configured": "{}, so what it has when it is configured was not seen",
    "not-active": "{}, so what it has when it is active was not seen",
    "observer-ended": "{}",
}
"""Problems of a node that ran, after which its interface is not taken to be the whole one."""
PARAMS_OPEN = "params-unanswered"
"""That after which only its params are not."""
TABLES_OF = {"nodelet": "nodelets", "component": "components"}
"""Where a package lists its programs of a kind, if not among the executables."""
CLIENTS_OPEN = "a service client is seen only when it waits for its service or calls it"


def assemble(
    configuration: ProbeConfiguration,
    records: Iterable[NodeRecord | LaunchRecord],
    notes: Sequence[Note],
    trees: Sequence[Tree],
    origins: Mapping[str, str],
    *,
    local: bool,
) -> dict[str, Any]:
    """The library.

    Args:
        configuration: what was asked for.
        records: what was probed; of several runs of the same the last one counts.
        notes: what else was said.
        trees: the sources.
        origins: package → name of its tree.
        local: whether it was this machine's ROS.
    """
    facts: Mapping[str, Any] = next((note.facts for note in notes if note.kind == "environment"), {})
    base = facts.get("base", "") if local else configuration.base
    run = f"local, {base}" if local else base
    document: dict[str, Any] = {
        "format": FORMAT,
        "version": 1,
        "generator": f"launchlint {__version__} probe",
        "environment": {
            "base": base,
            **({"distro": facts["distro"]} if facts.get("distro") else {}),
            "network": "that of this machine" if local else "none",
        },
    }
    ids = {tree.name: _source_id(tree) for tree in trees}
    if trees:
        document["sources"] = sorted((_source(tree, ids[tree.name]) for tree in trees), key=lambda source: str(source["id"]))
    last = {(type(record).__name__, record.label, getattr(record, "program", ""), _way(record)): record for record in records}
    nodes = [record for record in last.values() if isinstance(record, NodeRecord)]
    launches = [record for record in last.values() if isinstance(record, LaunchRecord)]
    messages = {kind: dict(message) for record in nodes for kind, message in record.messages.items()}
    if messages:
        document["messages"] = {kind: messages[kind] for kind in sorted(messages)}
    middleware = facts.get("middleware", ROS1)
    packages = _packages(notes, origins, ids)
    programs: dict[tuple[str, str, str], list[dict[str, Any]]] = {}
    for record in sorted(nodes, key=lambda each: (each.variant != "default", each.variant)):
        table = TABLES_OF.get(record.program, "executables")
        programs.setdefault((record.package, table, record.name), []).append(program(record, configuration, run))
    for (package, table, name), known in sorted(programs.items()):
        packages.setdefault(package, {}).setdefault(table, {})[name] = merge_programs(known)
    for launch in sorted(launches, key=lambda each: (each.label, sorted(each.args.items()))):
        packages.setdefault(launch.package, {}).setdefault("launch", []).append(_launch(launch))
    if middleware == ROS2:
        packages = {name: {"middleware": ROS2, **package} for name, package in packages.items()}
    document["packages"] = {name: packages[name] for name in sorted(packages)}
    document["version"] = version_for(packages.values())
    return document


def _way(record: NodeRecord | LaunchRecord) -> str:
    return record.variant if isinstance(record, NodeRecord) else repr(sorted(record.args.items()))


def _source_id(tree: Tree) -> str:
    name = "/".join(tree.url.rstrip("/").removesuffix(".git").replace(":", "/").split("/")[-2:]) if tree.url else tree.name
    return f"{name}@{tree.commit[:12]}" if tree.commit else name


def _source(tree: Tree, identity: str) -> dict[str, Any]:
    source = {"id": identity, "url": tree.url or f"local:{tree.name}"}
    if tree.ref:
        source["ref"] = tree.ref
    if tree.commit:
        source["commit"] = tree.commit
    return source


def _packages(notes: Sequence[Note], origins: Mapping[str, str], ids: Mapping[str, str]) -> dict[str, dict[str, Any]]:
    """Version, source and build of each package."""
    packages: dict[str, dict[str, Any]] = {}
    for note in notes:
        name = note.facts.get("package", "")
        if note.kind == "package" and note.facts["status"] == "found":
            known = packages.setdefault(name, {})
            if note.facts["version"]:
                known["version"] = note.facts["version"]
        elif note.kind == "build":
            build = {"result": note.facts["result"], **({"errors": list(note.facts["errors"])} if note.facts["errors"] else {})}
            packages.setdefault(name, {})["build"] = build
    for name, known in packages.items():
        if name in origins:
            known["source"] = ids[origins[name]]
    return packages


def program(record: NodeRecord, configuration: ProbeConfiguration, run: str) -> dict[str, Any]:
    """What one run says of a program, as the library format has it."""
    if record.status == "not-a-node":
        return {"class": "none"}
    found: dict[str, Any] = {"class": record.program, **({"hash": record.digest} if record.digest else {})}
    if record.problems:
        found["problems"] = [problem._asdict() for problem in record.problems]
    if record.status == "failed":
        return {**found, "status": "failed"}
    settings = configuration.nodes.get(record.label, {})
    own: Mapping[str, Any] = settings.get("variants", {}).get(record.variant, {})
    variant: dict[str, Any] = {}
    if record.variant != "default":
        variant["match"] = own["match"] if "match" in own else condition_of(own.get("params", {}))
    for key in ("args", "env", "remap"):
        value = _joined(settings.get(key), own.get(key))
        if value:
            variant[key] = value
    variant.update(record.traits)
    evidence = [{"by": "dynamic", "run": run}]
    for category in CATEGORIES:
        if category in record.interface:
            variant[category] = [
                {**_with_md5(category, entry, record.messages), "evidence": evidence} for entry in record.interface[category]
            ]
    opened = _open(record.problems, PROGRAMS[record.program])
    if opened:
        variant["open"] = opened
    return {**found, "variants": {record.variant: variant}}


def condition_of(params: Mapping[str, Any]) -> dict[str, Any]:
    """The condition that these params have these values."""
    conditions = [{"param": name, "is": value} for name, value in sorted(params.items())]
    return conditions[0] if len(conditions) == 1 else {"all": conditions}


def _joined(general: Any, own: Any) -> Any:
    if isinstance(general, dict) and isinstance(own, dict):
        return {**general, **own}
    return general if own is None else own


def _with_md5(category: str, entry: Mapping[str, Any], messages: Mapping[str, Mapping[str, str]]) -> dict[str, Any]:
    """A topic with the sum of its type: publishers say it themselves, subscribers do not."""
    if category in ("publishers", "subscribers") and "md5" not in entry and entry.get("type") in messages:
        return {**entry, "md5": messages[entry["type"]]["md5"]}
    return dict(entry)


def _open(problems: Sequence[Problem], middleware: str) -> dict[str, str]:
    """What is open: after a problem everything, or the params; and service clients in ROS 1, whose master does not learn of them."""
    reasons = [OPEN[problem.code].format(problem.detail) for problem in problems if problem.code in OPEN]
    if reasons:
        return dict.fromkeys(CATEGORIES, reasons[0])
    found = {"clients": CLIENTS_OPEN} if middleware == ROS1 else {}
    if unanswered := [problem.detail for problem in problems if problem.code == PARAMS_OPEN]:
        found["params"] = unanswered[0]
    return found


def _launch(record: LaunchRecord) -> dict[str, Any]:
    """What a launch file starts, for whoever includes it."""
    found: dict[str, Any] = {"file": record.file, "status": record.status}
    if record.args:
        found["args"] = dict(record.args)
    if record.nodes:
        found["nodes"] = [dict(node) for node in record.nodes]
    if record.params:
        found["params"] = list(record.params)
    if record.problems:
        found["problems"] = [problem._asdict() for problem in record.problems]
    return found

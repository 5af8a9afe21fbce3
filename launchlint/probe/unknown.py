"""What launch files start and nobody knows, as the configuration of a probe."""

from __future__ import annotations

import os
import shlex
from collections import Counter
from collections.abc import Iterable, Mapping

from launchlint.model import ROS1, ROS2
from launchlint.named_tuple import NamedTuple
from launchlint.probe.words import is_a, is_package
from launchlint.workspace.ros2_distributions import DEFAULT

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.graph.connections import ConnectionGraph, Instance
    from launchlint.workspace.package import Package
    from launchlint.workspace.packages import Packages

PLACE = "{}"
"""Stands in args for a word that the probe makes up, to find it again in names."""
LONGEST_ARGS = 2_000


class Unknown(NamedTuple):
    """What nobody knows.

    Args:
        programs: package/executable, or the class of a nodelet or component, sorted: those that can be probed.
        aside: those of the other version of ROS, where there are both: one image has one of them.
        absent: those whose package is not in the workspace.
        settings: the probe's configuration as plain values, to be written as YAML; paths are relative to the directory it was made for.
    """

    programs: tuple[str, ...]
    aside: tuple[str, ...]
    absent: tuple[str, ...]
    settings: Mapping[str, Any]


def unknown(graphs: Iterable[ConnectionGraph], packages: Packages, directory: str) -> Unknown:
    """The programs of which nothing is known, with the packages of the workspace that they need, and the args they are started with.

    ``directory`` is where the configuration will be: its paths are relative to that.
    """
    args: dict[str, Counter[str]] = {}
    dialects: dict[str, str] = {}
    distro = ""
    for graph in graphs:
        distro = distro or graph.launch.distro
        for instance in graph.instances:
            if instance.knowledge == "unknown" and is_a("program", instance.program):
                args.setdefault(instance.program, Counter())[_args(instance)] += 1
                dialects[instance.program] = graph.launch.dialect
    packages_here = {program: package for program in sorted(args) if (package := package_here(program, packages)) is not None}
    many = Counter(dialects[program] for program in packages_here)
    chosen = ROS2 if many[ROS2] > many[ROS1] else ROS1
    present = [program for program in packages_here if dialects[program] == chosen]
    here: dict[str, Package] = {}
    for program in present:
        _add_with_dependencies(packages_here[program], packages, here)
    settings: dict[str, Any] = {
        **({"base": f"ros:{distro or DEFAULT}"} if chosen == ROS2 else {}),
        "repositories": [{"path": os.path.relpath(here[name].directory, directory)} for name in sorted(here)],
        "packages": sorted({program.partition("/")[0].partition("::")[0] for program in present}),
        "programs": present,
    }
    nodes = {program: {"args": text} for program in present if (text := args[program].most_common(1)[0][0])}
    if nodes:
        settings["nodes"] = nodes
    aside = tuple(program for program in packages_here if dialects[program] != chosen)
    absent = tuple(program for program in sorted(args) if program not in packages_here)
    return Unknown(tuple(present), aside, absent, settings)


def package_here(program: str, packages: Packages) -> Package | None:
    """The package of a program, if its sources are in the workspace: what ``probe --unknown`` can build and run."""
    name = program.partition("/")[0].partition("::")[0]
    return _of_workspace(name, packages) if is_package(name) else None


def _of_workspace(name: str, packages: Packages) -> Package | None:
    package = packages.get(name, os.curdir)
    if package is None or package.broken:
        return None
    inside = os.path.realpath(package.directory) + os.sep
    return package if any(inside.startswith(os.path.realpath(each) + os.sep) for each in packages.workspaces) else None


def _add_with_dependencies(package: Package, packages: Packages, here: dict[str, Package]) -> None:
    """The package, and what it depends on of the workspace: without that it cannot be built."""
    waiting = [package]
    while waiting:
        each = waiting.pop()
        if each.name in here:
            continue
        here[each.name] = each
        for name in sorted(each.manifest.depends()) if each.manifest is not None else ():
            other = _of_workspace(name, packages) if is_package(name) else None
            if other is not None:
                waiting.append(other)


def _args(instance: Instance) -> str:
    """The arguments of a node as a probe is told them: what may be a name becomes ``{}``; empty where nothing can be said.

    Nodelets are loaded by the probe itself, and remaps change names that are still to be found out.
    """
    node = instance.node
    if instance.kind != "node" or "args" in node.unknown or len(node.arguments) > LONGEST_ARGS or PLACE[0] in node.arguments:
        return ""
    try:
        words = shlex.split(node.arguments)
    except ValueError:
        return ""
    told = [PLACE if is_a("name", word) and word[0] != "~" else word for word in words if ":=" not in word]
    text = " ".join(shlex.quote(word) if word != PLACE else word for word in told)
    return text if text.isprintable() else ""


def text_of(found: Unknown, output: str) -> str:
    """The configuration as YAML, with words for whoever opens it."""
    import yaml

    body = yaml.safe_dump(dict(found.settings), sort_keys=False, default_flow_style=False, width=120)
    return (
        "# Written by `launchlint probe --unknown`: the programs that launch files start and nobody knows.\n"
        "# It is written anew each time. To change it, copy it, and run the copy: launchlint probe COPY.yaml -o "
        f"{output}\n{body}"
    )

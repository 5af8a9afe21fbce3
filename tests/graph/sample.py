"""Launch files and libraries as tests write them down, and the graph they make. Nothing of the bundled library is used."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.graph.connect import connect
from launchlint.graph.connections import ConnectionGraph, Instance
from launchlint.graph.plausible import Possible
from launchlint.library.file import open_library
from launchlint.library.lookup import Library
from launchlint.workspace.packages import Packages

STRING = "std_msgs/String"
ENVIRONMENT = {"HOME": "/home/user", "PATH": "/usr/bin:/bin"}


def program(client: str = "roscpp", **interface: Any) -> dict[str, Any]:
    """An executable with one variant; ``options`` go to the executable, all else to the variant."""
    options = {"options": interface.pop("options")} if "options" in interface else {}
    return {"class": client, **options, "variants": {"default": interface}}


def library(directory: Path, packages: Mapping[str, Any]) -> Library:
    file = directory / "library.json"
    file.write_text(json.dumps({"format": "launchlint-library", "version": 1, "packages": packages}), encoding="utf-8")
    return Library([open_library(str(file))], bundled=False)


def graph(
    directory: Path, launch: str, packages: Mapping[str, Any], files: Mapping[str, str] | None = None, args: Mapping[str, str] | None = None
) -> ConnectionGraph:
    """The graph of ``<launch>LAUNCH</launch>``; ``files`` are more launch files of the package ``pkg``."""
    home = directory / "pkg"
    home.mkdir(exist_ok=True)
    (home / "package.xml").write_text("<package><name>pkg</name><version>1.0.0</version></package>", encoding="utf-8")
    for name, text in {"main.launch": launch, **(files or {})}.items():
        (home / name).write_text(f"<launch>{text}</launch>", encoding="utf-8")
    session = Session(Packages([str(directory)], ENVIRONMENT, explicit=True), ENVIRONMENT, str(directory))
    evaluation = evaluate(session, str(home / "main.launch"), tuple((args or {}).items()))
    return connect(evaluation.launch, library(directory, packages))


def edges(of: Instance | ConnectionGraph) -> list[str]:
    """``role name`` of every endpoint, with a ? where it may not be there; for a graph with the node before it."""
    if isinstance(of, Instance):
        return [f"{each.role} {each.name}{'' if each.certain else '?'}" for each in of.endpoints]
    return [f"{instance.name} {edge}" for instance in of.instances for edge in edges(instance)]


def channels(of: ConnectionGraph) -> list[str]:
    """``kind name: offers > uses`` of every channel."""
    return [
        f"{kind} {name}: {' '.join(each.node for each in channel.offers)} > {' '.join(each.node for each in channel.uses)}"
        for (kind, name), channel in of.channels.items()
    ]


def reasons(possible: Iterable[Possible]) -> list[str]:
    """Why somebody could have a name, for each of those who could."""
    return [each.reason for each in possible]

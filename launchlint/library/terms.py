"""The words and bounds of the library format that every check needs; :mod:`.format` has the rest."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.model import ROS1, ROS2

VERSION = 1
"""Of a library that does not say which middleware its packages are of."""
VERSION_2 = 2
"""Of a library that says it."""

CATEGORIES = ("publishers", "subscribers", "services", "clients", "actions", "params")
"""The kinds of names a node has, in the order in which they are written."""

FRAMES = "frames"
"""The coordinate frames of a node: no names on the graph, and listed behind them."""

LISTS = (*CATEGORIES, FRAMES)
"""All that a variant lists, in the order in which it is written."""

KINDS = {"executables": "executable", "nodelets": "nodelet class", "components": "component"}
"""The tables of programs in a package, with what one of each is called."""

TABLES = {ROS1: ("executables", "nodelets"), ROS2: ("executables", "components")}
"""The tables that a package has, by its middleware; what can be loaded into a process is in the last one."""

DEEPEST_CONDITION = 8
"""Levels of ``not``, ``all`` and ``any`` in a condition, and of templates in templates."""

READ_FROM = "read from "
"""What evidence begins with that is a place in the sources of the checked packages."""


def evidence_text(evidence: Mapping[str, str]) -> str:
    """One piece of evidence for people: *read from src/talker.cpp:40*, *static: owner/name@commit:src/talker.cpp:40*."""
    at = evidence.get("at") or evidence.get("run") or ""
    return f"{READ_FROM}{at}" if "here" in evidence else f"{evidence['by']}: {at}"

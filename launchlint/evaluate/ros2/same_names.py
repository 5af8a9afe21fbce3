"""Nodes of one name: ROS 2 launch warns and starts them all (launch_ros.actions.Node, launch_ros.utilities.add_node_name)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from launchlint.evaluate.problems import DuplicateNode
from launchlint.model import Node
from launchlint.problem import Problem


def duplicates(nodes: Iterable[Node]) -> Iterator[Problem]:
    """The nodes that have the full name of one before them, for certain: each with the first of that name."""
    first: dict[str, Node] = {}
    for node in nodes:
        if node.deferred not in (None, "timer"):
            continue  # what is started when something ends may take its place
        if not node.name or not node.knows("name", "namespace") or any(each.assumed for each in node.conditions):
            continue
        other = first.setdefault(node.full_name, node)
        if other is not node:
            related = ((other.origin.place, "the first one"),)
            yield DuplicateNode(origin=node.origin, related=related, name=node.full_name, first=other, second=node, core=False)

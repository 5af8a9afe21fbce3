"""ROS name resolution as the client libraries do it.

A name in a node's code is relative (``scan``), private (``~state``) or global (``/tf``). It is resolved against the namespace and name
of the node, then looked up among the remappings, whose two sides were resolved the same way: one look-up, no chains.

Where two remappings have one resolved source, the client libraries differ: roscpp keeps its rules sorted by their spelling and the last of
them wins (ros::init, ros::names::init); rospy keeps them as given and the last wins (rosgraph.names.load_mappings,
rospy.names.initialize_mappings).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from launchlint.model import Remap


class Rule(NamedTuple):
    """One remapping as the process gets it. ``remap`` is the ``<remap>`` it comes from; None for one written in ``args``."""

    source: str
    target: str
    remap: Remap | None = None


class Applied(NamedTuple):
    """A remapping that acted on a name: both sides resolved."""

    source: str
    target: str
    rule: Rule


class Resolved(NamedTuple):
    """A name on the graph: ``name`` after remapping, ``unremapped`` before, ``applied`` what acted, in order."""

    name: str
    unremapped: str
    applied: tuple[Applied, ...] = ()


def clean(name: str) -> str:
    """``name`` without doubled or trailing slashes (ros::names::clean)."""
    while "//" in name:
        name = name.replace("//", "/")
    return name[:-1] if name.endswith("/") and len(name) > 1 else name


def absolute(name: str, namespace: str, node: str) -> str:
    """``name`` as a global name, not remapped (ros::names::resolve, rosgraph.names.resolve_name).

    Args:
        name: as code or launch file says it.
        namespace: of the node; with or without a slash at its end.
        node: the full name of the node.
    """
    if name.startswith("/"):
        return clean(name)
    if name.startswith("~"):
        return clean(f"{node}/{name[1:]}")
    return clean(f"/{namespace}/{name}")


def kind(name: str) -> str:
    """``global``, ``private`` or ``relative``."""
    return "global" if name.startswith("/") else "private" if name.startswith("~") else "relative"


class Namer:
    """Resolves the names of one node.

    Args:
        namespace: of the node.
        node: its full name.
        rules: the remappings in the order the process gets them.
        client: ``rospy``, or anything else for roscpp's way.
        beneath: for a nodelet, the remappings of its manager: they act where its own do not (ros::NodeHandle::remapName).
    """

    __slots__ = ("_beneath", "_table", "namespace", "node")

    def __init__(self, namespace: str, node: str, rules: Iterable[Rule] = (), client: str = "", beneath: Namer | None = None) -> None:
        self.namespace = namespace
        self.node = node
        self._beneath = beneath
        self._table = self._resolved(rules, client)

    def _resolved(self, rules: Iterable[Rule], client: str) -> Mapping[str, Applied]:
        given: dict[str, Rule] = {}
        for rule in rules:
            given[rule.source] = rule
        table: dict[str, Applied] = {}
        for source in given if client == "rospy" else sorted(given):
            if client != "rospy" and source == self.node:
                continue
            rule = given[source]
            resolved = absolute(source, self.namespace, self.node)
            table[resolved] = Applied(resolved, absolute(rule.target, self.namespace, self.node), rule)
        return table

    @property
    def remappings(self) -> Mapping[str, Applied]:
        """The remappings of the node itself, by their resolved source."""
        return self._table

    def resolve(self, name: str) -> Resolved:
        """The name that ``name`` of the node's code has on the graph."""
        unremapped = absolute(name, self.namespace, self.node)
        applied = self._applied(unremapped)
        return Resolved(unremapped, unremapped) if applied is None else Resolved(applied.target, unremapped, (applied,))

    def _applied(self, name: str) -> Applied | None:
        own = self._table.get(name)
        return own if own is not None or self._beneath is None else self._beneath._applied(name)

    def beneath(self, base: Resolved, suffix: str) -> Resolved:
        """A name made by the code from a name that is already resolved: ``image`` → ``/cam/image`` → ``/cam/image/compressed``."""
        inner = self.resolve(clean(f"{base.name}/{suffix}"))
        return Resolved(inner.name, inner.unremapped, (*base.applied, *inner.applied))

    def is_remapped(self, name: str) -> bool:
        """Whether a remapping acts on ``name``."""
        return self._applied(absolute(name, self.namespace, self.node)) is not None

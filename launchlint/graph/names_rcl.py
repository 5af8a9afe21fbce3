"""ROS name resolution as rcl does it, for nodes of ROS 2: behind the same methods as that of roscpp and rospy.

The first remap rule that matches the expanded name counts, and no other one: there are no chains. A rule may be for topics or services
only, or for one node. Source: see :mod:`launchlint.rcl.names`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from launchlint.graph.names import Applied, Namer, Resolved, Rule, clean, placed
from launchlint.graph.qos import qos_of
from launchlint.model import Remap
from launchlint.rcl.names import Names, is_node_name
from launchlint.rcl.remap import Rule as RclRule
from launchlint.rcl.remap import parse

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    from launchlint.graph.qos import Own
    from launchlint.library.program import Declaration
    from launchlint.library.template import Situation, Undetermined


def param_name(name: str) -> str:
    """What code calls ``~group.name``, without what says that it is the node's own; a slash in it is a letter like others for rcl."""
    return name.removeprefix("~").lstrip("/")


_UNNAMED = "launchlint_unnamed"
"""Stands for the name of a node that only its program knows."""


class RclNamer(Namer):
    """Resolves the names of one node of ROS 2.

    Args:
        namespace: of the node, as launch gives it.
        node: its full name, also where that is no more than a way to call it.
        remaps: its remappings in the order of its command line; what rcl would refuse does nothing here.
        unknown: remappings of which only patterns are known.
        params: its params, type and value by name; None where they are not known.
        is_named: whether launch gives the node its name: then all nodes of the process get it.
    """

    __slots__ = ("_by_rule", "_is_named", "_names", "_own", "_patterns", "_remaps", "_rules")

    has_action_topics = False
    image_topics = (
        ("compressed", "sensor_msgs/msg/CompressedImage"),
        ("compressedDepth", "sensor_msgs/msg/CompressedImage"),
        ("theora", "theora_image_transport/msg/Packet"),
        ("zstd", "sensor_msgs/msg/CompressedImage"),
    )

    def __init__(
        self,
        namespace: str,
        node: str,
        remaps: Iterable[Remap] = (),
        unknown: Iterable[tuple[str, str]] = (),
        params: Own = None,
        *,
        is_named: bool = True,
    ) -> None:
        self._remaps = remaps = tuple(remaps)
        self._patterns = unknown = tuple(unknown)
        self._own = params
        self._is_named = is_named
        parsed = [(remap, parse(f"{remap.source}:={remap.target}")) for remap in remaps]
        rules = [(remap, rule) for remap, rule in parsed if isinstance(rule, RclRule)]
        self._by_rule = {id(rule): remap for remap, rule in rules}
        own = node.rpartition("/")[2]
        self._names = Names(own if is_node_name(own) else _UNNAMED, namespace.rstrip("/") or "/", [rule for _, rule in rules])
        self.namespace = self.home = self._names.namespace
        self.node = self.graph_name = self.private = node
        self._is_rospy = False
        self._spelled = {}
        self._unknown = [(placed(source, self.namespace, node), placed(target, self.namespace, node)) for source, target in unknown]
        self._rules = rules
        self._table: dict[str, Applied] = {}

    @property
    def remappings(self) -> Mapping[str, Applied]:
        """The remappings of the node itself, by their resolved source: of several the one that counts."""
        if not self._table:
            for remap, rule in reversed(self._rules):
                source = self._expanded(rule.match) if rule.match else None
                target = self._expanded(rule.replacement)
                if source is not None and target is not None:
                    self._table[source] = Applied(source, target, Rule(rule.match, rule.replacement, remap))
        return self._table

    def resolve(self, name: str) -> Resolved:
        """The name that a service of the node's code has on the graph."""
        return self._named(name, "service")

    def param(self, name: str) -> Resolved:
        """The param that ``name`` of the node's code is: ``/node:group.name``."""
        full = f"{self.graph_name}:{param_name(name)}"
        return Resolved(full, full)

    def is_param(self, name: str) -> bool:
        """Whether a param may be called so that no topic may: ``~FollowPath.max_vel_x``."""
        return name.startswith("~") and len(name) > 1

    def of_node(self, name: str | Undetermined | None) -> RclNamer | None:
        """Resolves the names of another node of the process; ``__node`` renames all of them (rcl_parse_arguments, rcl_node_init)."""
        if self._is_named:
            return self
        if not isinstance(name, str) or not is_node_name(name):
            return None
        made = RclNamer(self.namespace, f"{self.namespace.rstrip('/')}/{name}", self._remaps, self._patterns, self._own, is_named=False)
        made.node = self.node
        return made

    def qos(self, declaration: Declaration, topic: str, start: Situation) -> Mapping[str, str | float]:
        """What is known of the quality of service of an endpoint."""
        return qos_of(declaration, topic, start, self._own)

    def topic(self, name: str) -> Resolved:
        """The topic that ``name`` of the node's code has on the graph."""
        return self._named(name, "topic")

    def action(self, name: str) -> Resolved:
        """The name of an action: its topics and services are hidden ones below that, which a rule for the name itself does not move."""
        unremapped = self._expanded(name) or clean(f"/{self.namespace}/{name}")
        return Resolved(unremapped, unremapped)

    def again(self, base: Resolved) -> Resolved:
        """Rcl resolves a name once."""
        return base

    def moved(self, name: str) -> str:
        """A global name after remapping."""
        return self._named(name, "topic").name

    def beneath(self, base: Resolved, suffix: str) -> Resolved:
        """A name made by the code from a name that is already resolved: ``image`` → ``/cam/image`` → ``/cam/image/compressed``."""
        inner = self.topic(clean(f"{base.name}/{suffix}"))
        return Resolved(inner.name, inner.unremapped, (*base.applied, *inner.applied))

    def _handles(self, unremapped: str) -> Iterator[str]:
        """Rcl remaps whole names only: nothing that the code puts around them."""
        return iter(())

    def _expanded(self, name: str) -> str | None:
        """``name`` before any rule. A library that is written for ROS 1 spells private names ``~name``."""
        name = f"~/{name[1:]}" if name.startswith("~") and name[1:2] not in ("", "/") else name
        found = self._names.expand(name)
        if found is None or self._names.node != _UNNAMED:
            return found
        below = f"{self._names.full_name}/"
        return f"{self.private}/{found[len(below) :]}" if found.startswith(below) else found

    def _named(self, name: str, kind: Literal["topic", "service"]) -> Resolved:
        unremapped = self._expanded(name)
        if unremapped is None:  # a name that rcl refuses
            unremapped = clean(f"/{self.namespace}/{name}")
            return Resolved(unremapped, unremapped)
        rule = self._names.rule(unremapped, kind)
        target = None if rule is None else self._expanded(rule.replacement)
        if rule is None or target is None:
            return Resolved(unremapped, unremapped)
        applied = Applied(unremapped, target, Rule(rule.match, rule.replacement, self._by_rule.get(id(rule))))
        return Resolved(target, unremapped, (applied,))

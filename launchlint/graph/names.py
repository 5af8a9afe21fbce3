"""ROS name resolution as the client libraries do it.

A name in a node's code is relative (``scan``), private (``~state``) or global (``/tf``). It is resolved against the namespace and name
of the node, then looked up among the remappings, whose two sides were resolved the same way: one look-up, no chains. Only the topics of
rospy are looked up twice, so there two remappings do chain (rospy.topics.Topic, then rospy.topics._TopicImpl).

Where two remappings have one resolved source, the client libraries differ: roscpp keeps its rules sorted by their spelling and the last of
them wins (ros::init, ros::names::init); rospy keeps them as given and the last wins (rosgraph.names.load_mappings,
rospy.names.initialize_mappings).

In roscpp the name of the node is a name like any other: a rule for it gives the node another name and its private names another place
(ros::this_node::init), unless the rule is spelled as just that name, without namespace: then it is dropped (ros::names::init). Private
names are made in a namespace that is itself resolved, so a rule that moves it moves them (ros::NodeHandle::construct).

A NodeHandle of ``/`` is one of no name: ros::names::clean leaves nothing of the slash, and ros::NodeHandle::resolveName takes the namespace
of the process for nothing. So the relative names of a nodelet in no namespace lie in that of its manager.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from launchlint.graph.qos import NO_QOS
from launchlint.model import Remap
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.library.program import Declaration
    from launchlint.library.template import Situation, Undetermined


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


def around(name: str) -> Iterator[str]:
    """The names around a global ``name``, the nearest first: ``/arm/left`` and ``/arm`` around ``/arm/left/gripper``."""
    outer = name.rpartition("/")[0]
    while outer:
        yield outer
        outer = outer.rpartition("/")[0]


def _is_within(name: str, outer: str) -> bool:
    """Whether a global ``name`` is ``outer``, or ``outer`` is one of the names around it."""
    return f"{name.rstrip('/')}/".startswith(f"{outer}/")


def kind(name: str) -> str:
    """``global``, ``private`` or ``relative``."""
    return "global" if name.startswith("/") else "private" if name.startswith("~") else "relative"


def placed(pattern: str, namespace: str, node: str) -> str:
    """A name of which only a pattern is known, as :func:`absolute` would give it: what begins with ``*`` may begin with anything."""
    return pattern if pattern.startswith("*") else absolute(pattern, namespace, node)


def matches(pattern: str, name: str) -> bool:
    """Whether ``name`` is one that ``pattern`` stands for; each ``*`` in it stands for anything."""
    first, *others = pattern.split("*")
    if not others:
        return name == first
    *middle, last = others
    if not name.startswith(first) or not name.endswith(last) or len(name) < len(first) + len(last):
        return False
    at, end = len(first), len(name) - len(last)
    for part in middle:
        at = name.find(part, at, end)
        if at < 0:
            return False
        at += len(part)
    return True


class Namer:
    """Resolves the names of one node.

    ``graph_name`` is the name that the node really has, ``private`` the namespace of its private names. ``node`` is what the launch file
    calls it; the same but for rare remappings. ``namespace`` is where the relative names of its code lie, ``home`` where those of its
    ``<remap>`` do; the same but for nodelets.

    Args:
        namespace: of the process.
        node: its full name as the launch file gives it.
        rules: the remappings in the order the process gets them.
        client: ``rospy``, or anything else for roscpp's way.
        unknown: remappings of which only patterns are known, of source and target: ``*`` stands for anything.
    """

    has_action_topics = True
    """Whether actions are five topics that can be remapped (actionlib)."""
    image_topics: tuple[tuple[str, str], ...] = (
        ("compressed", "sensor_msgs/CompressedImage"),
        ("compressedDepth", "sensor_msgs/CompressedImage"),
        ("theora", "theora_image_transport/Packet"),
    )
    """What the usual plugins of image_transport publish beside an image, where they are installed."""

    __slots__ = ("_is_rospy", "_spelled", "_table", "_unknown", "graph_name", "home", "namespace", "node", "private")

    def __init__(
        self, namespace: str, node: str, rules: Iterable[Rule] = (), client: str = "", unknown: Iterable[tuple[str, str]] = ()
    ) -> None:
        self.namespace = self.home = namespace
        self.node = node
        self._is_rospy = client == "rospy"
        own = node.rpartition("/")[2]
        full = absolute(own, namespace, node)
        self._spelled: dict[str, Applied] = {}
        self._table = self._resolved(rules, own, full)
        self._unknown = [(placed(source, namespace, full), placed(target, namespace, full)) for source, target in unknown]
        self.graph_name = full if self._is_rospy else self.moved(full)
        self.private = full if self._is_rospy else self.moved(self.moved(self.graph_name))

    def _resolved(self, rules: Iterable[Rule], own: str, full: str) -> dict[str, Applied]:
        given: dict[str, Rule] = {}
        for rule in rules:
            given[rule.source] = rule
        table: dict[str, Applied] = {}
        for source in given if self._is_rospy else sorted(given):
            if source == own and not self._is_rospy:
                continue
            rule = given[source]
            resolved = absolute(source, self.namespace, full)
            table[resolved] = self._spelled[source] = Applied(resolved, absolute(rule.target, self.namespace, full), rule)
        return table

    def elsewhere(self, unremapped: str, *, handles: bool = True) -> tuple[list[str], bool]:
        """Patterns of the names that remappings which are not known may make of a name, and whether one of them acts for certain.

        A remapping of a namespace that the code puts around the name acts where the code makes a NodeHandle of that
        (ros::NodeHandle::construct), and does not where the name is one text: both may be, unless ``handles`` says that it is one text.
        """
        inner = list(self._handles(unremapped)) if handles else []
        if not self._unknown:
            return inner, False
        found = [(source, target) for source, target in self._unknown if matches(source, unremapped)]
        return [*(target for _, target in found), *inner], any("*" not in source for source, _ in found)

    def _handles(self, unremapped: str) -> Iterator[str]:
        """What a name is if the code makes NodeHandles of the namespaces of its own around it, of those that are remapped."""
        if self._is_rospy:
            return
        for outer in around(unremapped):
            applied = self._applied(outer)
            if (applied is None and not self._unknown) or _is_within(self.namespace, outer) or _is_within(self.private, outer):
                continue
            rest = unremapped[len(outer) + 1 :]
            if applied is not None and applied.target != outer:
                yield clean(f"{applied.target}/{rest}")
            for source, target in self._unknown:
                if "*" not in source and source == outer:
                    yield f"{target}/{rest}"

    @property
    def remappings(self) -> Mapping[str, Applied]:
        """The remappings of the node itself, by their resolved source."""
        return self._table

    def resolve(self, name: str) -> Resolved:
        """The name that ``name`` of the node's code has on the graph."""
        if self._is_rospy and name.startswith("~/"):
            name = name[1:]  # rospy.names.resolve_name joins what follows the ~, and that is a global name
        unremapped = absolute(name, self.namespace, self.private)
        applied = self._applied(unremapped)
        return Resolved(unremapped, unremapped) if applied is None else Resolved(applied.target, unremapped, (applied,))

    def param(self, name: str) -> Resolved:
        """The param that ``name`` of the node's code is."""
        return self.resolve(name)

    def is_param(self, name: str) -> bool:
        """Whether a param may be called so that no topic may."""
        return False

    def of_node(self, name: str | Undetermined | None) -> Namer | None:
        """Resolves the names of another node of the same process, as it calls itself; None where that is not known."""
        return self

    def qos(self, declaration: Declaration, topic: str, start: Situation) -> Mapping[str, str | float]:
        """What is known of the quality of service of an endpoint."""
        return NO_QOS

    def topic(self, name: str) -> Resolved:
        """The topic that ``name`` of the node's code has on the graph."""
        found = self.resolve(name)
        return self.again(found) if self._is_rospy else found

    def action(self, name: str) -> Resolved:
        """The name beneath which an action has its topics. In rospy only a remapping spelled as ``name`` acts on it (rospy.remap_name)."""
        if not self._is_rospy:
            return self.resolve(name)
        applied = self._spelled.get(name)
        unremapped = absolute(name, self.namespace, self.private)
        return Resolved(unremapped, unremapped) if applied is None else Resolved(applied.target, unremapped, (applied,))

    def again(self, base: Resolved) -> Resolved:
        """A resolved name that is given to a second resolution."""
        inner = self.resolve(base.name)
        return Resolved(inner.name, base.unremapped, (*base.applied, *inner.applied))

    def moved(self, name: str) -> str:
        """A global name after remapping."""
        applied = self._applied(name)
        return name if applied is None else applied.target

    def _applied(self, name: str) -> Applied | None:
        return self._table.get(name)

    def beneath(self, base: Resolved, suffix: str) -> Resolved:
        """A name made by the code from a name that is already resolved: ``image`` → ``/cam/image`` → ``/cam/image/compressed``."""
        inner = self.topic(clean(f"{base.name}/{suffix}"))
        return Resolved(inner.name, inner.unremapped, (*base.applied, *inner.applied))

    def is_remapped(self, name: str) -> bool:
        """Whether a remapping acts on ``name``."""
        return bool(self.resolve(name).applied)


class NodeletNamer(Namer):
    """Resolves the names of a nodelet.

    Its loader sends its own remappings, resolved. The manager resolves both sides once more (nodelet::LoaderROS::serviceLoad) and makes the
    namespaces of the nodelet under its own remappings (nodelet::Nodelet::init); these also act on a name for which the nodelet has no rule
    (ros::NodeHandle::remapName).

    Args:
        loader: names of the process that loads the nodelet.
        manager: names of the process that runs it; None where that is not known.
        around: the namespace of the process that runs it, as far as its name says it.
    """

    __slots__ = ("_manager",)

    def __init__(self, loader: Namer, manager: Namer | None, around: str = "/") -> None:
        self._manager = manager
        self._unknown = loader._unknown
        self._is_rospy = False
        self._spelled = {}
        self._table: dict[str, Applied] = {}
        self.node = loader.node
        self.graph_name = loader.graph_name
        self.home = loader.namespace
        self.namespace = self.moved(loader.graph_name.rpartition("/")[0] or (around if manager is None else manager.namespace))
        self.private = self.moved(loader.graph_name)
        moved = {
            self.moved(source): applied._replace(target=self.moved(applied.target)) for source, applied in sorted(loader.remappings.items())
        }
        self._table = {source: applied._replace(source=source) for source, applied in moved.items()}

    def _applied(self, name: str) -> Applied | None:
        own = self._table.get(name)
        return own if own is not None or self._manager is None else self._manager._applied(name)

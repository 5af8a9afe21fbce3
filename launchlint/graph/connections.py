"""The connection graph of one launch, in plain values."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.graph.frames import Frame
from launchlint.graph.names import Applied, Namer, matches
from launchlint.graph.parameters import Parameters
from launchlint.graph.qos import NO_QOS
from launchlint.library.program import Declaration
from launchlint.model import Launch, Node
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.graph.plausible import Possible, Unseen

OFFERS = frozenset({"publisher", "server", "action server"})
"""The roles that give; the others take."""
KINDS = {
    "publisher": "topic",
    "subscriber": "topic",
    "server": "service",
    "client": "service",
    "action server": "action",
    "action client": "action",
}
"""The kind of channel of each role."""
CATEGORY = {
    "publisher": "publishers",
    "subscriber": "subscribers",
    "server": "services",
    "client": "clients",
    "action server": "actions",
    "action client": "actions",
}
"""The category of the library in which a role is declared."""

HUBS = frozenset({"/tf", "/tf_static", "/clock", "/diagnostics", "/diagnostics_agg", "/rosout", "/rosout_agg", "/statistics"})
"""Topics that everybody uses: of no interest in a drawing, and shared on purpose."""
HUB_SIZE = 64
"""A topic of several publishers and several subscribers with this many pairs of them counts as a hub, too."""
PLUMBING = ("bond/", "dynamic_reconfigure/", "nodelet/", "composition_interfaces/", "lifecycle_msgs/", "rcl_interfaces/")
"""Packages whose types belong to the machinery of nodes, not to what they do."""


class Endpoint(NamedTuple):
    """One name that a node uses, in one role (a key of KINDS).

    Args:
        node: full name of the instance.
        role: publisher, subscriber, server, client, action server or action client.
        name: the name on the graph.
        declared: the name as the node's code says it, templates filled in.
        unremapped: the name on the graph if nothing were remapped.
        applied: the remappings that acted, in order.
        type: of message, service or action; empty where it is not known, ``*`` for any.
        certain: whether it is there whenever the node runs; else it may or may not be.
        process: full name under which the ROS master sees it: that of the manager for a nodelet.
        declaration: what the library says.
        action: the action that a topic belongs to, as a full name; else empty.
        qos: in ROS 2 what is known of its quality of service, policy by policy.
    """

    node: str
    role: str
    name: str
    declared: str
    unremapped: str
    applied: tuple[Applied, ...]
    type: str
    certain: bool
    process: str
    declaration: Declaration
    action: str = ""
    qos: Mapping[str, str | float] = NO_QOS

    @property
    def kind(self) -> str:
        """``topic``, ``service`` or ``action``."""
        return KINDS[self.role]

    @property
    def is_plumbing(self) -> bool:
        """Whether it belongs to the machinery of nodes (bonds, dynamic_reconfigure, nodelet services)."""
        return self.type.startswith(PLUMBING)

    @property
    def is_read_here(self) -> bool:
        """Whether sources of the workspace say that the node has this end, not what is known of a public program."""
        return any("here" in each for each in self.declaration.evidence)


class Reading(NamedTuple):
    """A param that a node reads; the fields are those of :class:`Endpoint`."""

    node: str
    name: str
    declared: str
    unremapped: str
    applied: tuple[Applied, ...]
    certain: bool
    declaration: Declaration


class Doubt(NamedTuple):
    """A name of some ``category`` that exists but is not known. ``pattern`` is what is known: ``*`` stands for anything.

    ``declared`` is how the library writes it; ``type`` is that of message, service or action, empty or ``*`` where it may be any.
    """

    category: str
    pattern: str
    declared: str
    type: str = ""

    def may_be(self, name: str) -> bool:
        """Whether it may be the name ``name`` on the graph."""
        return matches(self.pattern, name)

    def speaks(self, type_: str) -> bool:
        """Whether it may be of the type ``type_``, as far as is known: copies of a type in other packages count."""
        known = self.type.rpartition("/")[2].casefold()
        return known in ("", "*") or type_ in ("", "*") or known == type_.rpartition("/")[2].casefold()


class Instance(NamedTuple):
    """A node of the launch with what is known of it.

    Args:
        node: the node as the launch file starts it.
        name: its full name.
        program: ``package/executable``, or the class of a nodelet.
        kind: ``node``, ``nodelet`` (loaded into a manager), ``manager`` (of nodelets); in ROS 2 ``component`` and ``container``.
        knowledge: ``known``, ``template`` (known, some names made from args or params), ``unknown``.
        reason: why it is unknown, for people; else empty.
        host: full name of the process it runs in: its own, that of its manager, or empty where that is not known.
        open: category of the library → why there may be more of it than is listed.
        doubts: names that it has but that are not known.
        endpoints: what it says and hears, sorted by role and name.
        readings: the params it reads.
        looked_up: further names its code resolves → how the code says them.
        namer: resolves its names.
        certain: whether it runs in this configuration for certain.
        frames: the coordinate frames it publishes, asks for and writes into messages.
        client: its client library: roscpp, rospy, nodelet, none, other; empty where it is unknown.
        literals: texts in its sources that may be names, where some of its names are not known.
        lifecycle: whether it is a node of ROS 2 that somebody has to configure and activate.
        managed: whether its program does that, or may.
        undeclared: whether it takes params that it does not declare, or may; in ROS 1 always.
    """

    node: Node
    name: str
    program: str
    kind: str
    knowledge: str
    reason: str
    host: str
    open: Mapping[str, str]
    doubts: tuple[Doubt, ...]
    endpoints: tuple[Endpoint, ...]
    readings: tuple[Reading, ...]
    looked_up: Mapping[str, str]
    namer: Namer
    certain: bool = True
    client: str = ""
    frames: tuple[Frame, ...] = ()
    literals: tuple[str, ...] = ()
    lifecycle: bool = False
    managed: bool = True
    undeclared: bool = True

    @property
    def is_unknown(self) -> bool:
        """Whether nothing is known of what it does."""
        return self.knowledge == "unknown"

    def may_have_more(self, category: str) -> bool:
        """Whether it may have more of a category of the library than its endpoints show."""
        return self.knowledge == "unknown" or category in self.open or any(doubt.category == category for doubt in self.doubts)


class Channel:
    """A topic, service or action: ``offers`` are its publishers or servers, ``uses`` its subscribers or clients.

    What is asked of all of these is asked when the graph is complete, by many rules, and so is worked out once.
    """

    def __init__(self, kind: str, name: str) -> None:
        self.kind = kind
        self.name = name
        self.offers: list[Endpoint] = []
        self.uses: list[Endpoint] = []
        self._is_plumbing: bool | None = None

    @property
    def is_hub(self) -> bool:
        """Whether everybody uses it."""
        many = len(self.offers) > 1 and len(self.uses) > 1
        return self.name in HUBS or (many and len(self.offers) * len(self.uses) >= HUB_SIZE)

    @property
    def is_plumbing(self) -> bool:
        """Whether it belongs to the machinery of nodes."""
        if self._is_plumbing is None:
            self._is_plumbing = all(endpoint.type.startswith(PLUMBING) for endpoint in (*self.offers, *self.uses))
        return self._is_plumbing


class ConnectionGraph(NamedTuple):
    """What the nodes of one launch say to each other.

    ``channels`` is by kind and name, ``readers`` by the full name of the param; ``unseen`` is what may be there beside all that.
    """

    launch: Launch
    instances: tuple[Instance, ...]
    channels: Mapping[tuple[str, str], Channel]
    parameters: Parameters
    readers: Mapping[str, tuple[Reading, ...]]
    unseen: Unseen

    def instance(self, name: str) -> Instance | None:
        """The node of that full name."""
        return next((instance for instance in self.instances if instance.name == name), None)

    def may_offer(self, kind: str, name: str, type_: str = "") -> tuple[Possible, ...]:
        """Who may publish (kind ``topic``) or serve ``name`` although the graph does not show it; those of which something says so first.

        With a ``type_`` who can only say another one does not count. At most MOST_ANSWERS are given.
        """
        return self.unseen.who(kind, name, type_, offers=True)

    def may_use(self, kind: str, name: str, type_: str = "") -> tuple[Possible, ...]:
        """As :meth:`may_offer`: who may subscribe to (kind ``topic``) or call ``name``."""
        return self.unseen.who(kind, name, type_, offers=False)

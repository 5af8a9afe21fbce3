"""From what the graph of ROS 2 shows of a process to an interface in the library format; what every node has is left out."""

import re
from typing import Any, Dict, FrozenSet, List, Optional, Set, Tuple

from launchlint_probe.counterpart import Name
from launchlint_probe.interface import FULL, Entry, spelled

TOPICS = ("publishers", "subscribers")
SERVICES = ("services", "clients")
CATEGORIES = TOPICS + SERVICES

Owner = Tuple[str, str]
"""Namespace and name of a node."""
Key = Tuple[Owner, str, str]
"""A node, a category, and a name."""

_PRIVATE = frozenset(
    (
        "describe_parameters",
        "get_parameter_types",
        "get_parameters",
        "list_parameters",
        "set_parameters",
        "set_parameters_atomically",
        "get_type_description",
        "change_state",
        "get_state",
        "get_available_states",
        "get_available_transitions",
        "get_transition_graph",
        "transition_event",
    )
)
"""What client libraries give a node below its own name."""
_GLOBAL = frozenset(("/rosout", "/parameter_events", "/clock"))
_PARAMS = frozenset(("use_sim_time", "start_type_description_service"))
_OVERRIDES = re.compile(r"qos_overrides\.(?P<topic>.+)\.(?P<side>publisher|subscription)(?:_\w+)?\.(?P<policy>\w+)")
"""The params by which the QoS of an endpoint can be changed (rclcpp::QosOverridingOptions)."""
_SIDES = {"publisher": "publishers", "subscription": "subscribers"}
_HELPER = re.compile(r"transform_listener_impl_[0-9a-f]+")
"""The node that a tf2 listener makes for itself: what it hears is what the node hears that has the listener."""
_ACTION = "/_action/"
CHANGE_STATE = "lifecycle_msgs/srv/ChangeState"


def full(owner: Owner) -> str:
    """The whole name of a node."""
    return "{}/{}".format(owner[0].rstrip("/"), owner[1])


def is_helper(owner: Owner) -> bool:
    """Whether a node is one that a library makes for itself."""
    return _HELPER.fullmatch(owner[1]) is not None


def is_given(owner: Owner, name: str) -> bool:
    """Whether a topic or service of a node comes from its client library."""
    own = full(owner) + "/"
    return name in _GLOBAL or (name.startswith(own) and name[len(own) :] in _PRIVATE)


class Facts:
    """All that was ever seen of the nodes of one process.

    ``seen`` has the type and the QoS of each name; ``params`` what each node answered, in the order of asking: the state it was in, and its
    params; ``states`` the names that were there when a node with a lifecycle was constructed, and configured.
    """

    def __init__(self) -> None:
        self.owners: List[Owner] = []
        self.seen: Dict[Key, List[Tuple[str, Dict[str, Any]]]] = {}
        self.params: Dict[Owner, List[Tuple[str, Optional[List[Entry]]]]] = {}
        self.states: Dict[str, Set[Key]] = {}
        self.undeclared: Set[Owner] = set()

    def add(self, graph: Dict[str, Any]) -> bool:
        """Take in a graph. Returns whether anything is new."""
        new = False
        for node in graph["nodes"]:
            owner = (node["namespace"], node["name"])
            if owner not in self.owners:
                self.owners.append(owner)
                new = True
            for category in CATEGORIES:
                for name, kind, *qos in node.get(category, []):
                    known = self.seen.setdefault((owner, category, name), [])
                    entry = (kind, dict(qos[0]) if qos else {})
                    if entry not in known:
                        known.append(entry)
                        new = True
        return new

    def named(self) -> List[Owner]:
        """The nodes without those that libraries make for themselves."""
        return [owner for owner in self.owners if not is_helper(owner)]

    def own(self) -> List[Key]:
        """What the nodes have that not every node has."""
        return [key for key in self.seen if not is_given(key[0], key[2])]

    def lifecycle(self) -> List[Owner]:
        """The nodes that have states."""
        return [
            owner
            for owner in self.named()
            if any(kind == CHANGE_STATE for kind, _ in self.seen.get((owner, "services", full(owner) + "/change_state"), []))
        ]


def ways(owner: Owner, name: str) -> FrozenSet[str]:
    """All ways in which the code of a node may have said a name, given the node's own name and namespace."""
    found = {name}
    space = owner[0].rstrip("/") + "/"
    if name.startswith(space):
        found.add(name[len(space) :])
    own = full(owner) + "/"
    if name.startswith(own):
        found.add("~" + name[len(own) :])
    return frozenset(found | {each.replace(owner[1], "{node}") for each in found if not each.startswith("~")})


def spelled_for(owner: Owner, name: str, tokens: Dict[str, str]) -> str:
    """How the code of a node said a name, where its namespace is the probe's."""
    own = full(owner)
    if name == own or name.startswith(own + "/"):
        name = FULL + name[len(own) :]
    return spelled(name, tokens)


def spelled_names(facts: Facts, tokens: Dict[str, str]) -> Set[Name]:
    """The names of a process whose namespace is the probe's, as its code said them."""
    return {(category, spelled_for(owner, name, tokens)) for owner, category, name in facts.own()}


def possible_names(facts: Facts) -> Set[Name]:
    """The names of a process that is in no namespace of the probe's, in every way in which its code may have said them."""
    return {(category, way) for owner, category, name in facts.own() for way in ways(owner, name)}


def interface(facts: Facts, tokens: Dict[str, str], woken: Dict[Key, str], given: Set[str]) -> Dict[str, List[Entry]]:
    """The interface of a process, as the library format has it but for the evidence.

    Args:
        facts: what was seen.
        tokens: words that the probe gave the node → templates.
        woken: what was not there from the start → what it appeared upon.
        given: names of params that the probe itself set.
    """
    nodes = facts.named()
    found: Dict[str, List[Entry]] = {}
    for owner in facts.owners:
        of = "" if is_helper(owner) or owner == nodes[0] else owner[1]
        for category, entries in _of_node(facts, owner, tokens, woken, given).items():
            found.setdefault(category, []).extend(dict(entry, **({"node": of} if of else {})) for entry in entries)
    return {category: _sorted(entries) for category, entries in found.items() if entries}


def _sorted(entries: List[Entry]) -> List[Entry]:
    unique: Dict[Tuple[str, str, str, str], Entry] = {}
    for entry in entries:
        unique.setdefault((entry["name"], entry.get("role", ""), entry.get("node", ""), entry.get("type", "")), entry)
    return [unique[key] for key in sorted(unique)]


def _of_node(facts: Facts, owner: Owner, tokens: Dict[str, str], woken: Dict[Key, str], given: Set[str]) -> Dict[str, List[Entry]]:
    params, changeable = _params(facts, owner, given)
    found: Dict[str, List[Entry]] = {"params": params}
    actions: Dict[Tuple[str, str], Entry] = {}
    for key in facts.own():
        if key[0] != owner:
            continue
        _, category, name = key
        base, action, last = name.partition(_ACTION)
        for kind, qos in facts.seen[key]:
            more = _when(facts, key, woken)
            if action:
                role = "server" if category in ("services", "publishers") else "client"
                entry = {"name": spelled_for(owner, base, tokens), "role": role, **more}
                if last == "send_goal":
                    entry["type"] = kind[: -len("_SendGoal")]
                    actions[(base, role)] = entry
                continue
            entry = {"name": spelled_for(owner, name, tokens), "type": kind, **more}
            if category in TOPICS and qos:
                entry["qos"] = qos
            if (category, name) in changeable:
                entry["overrides"] = True
            found.setdefault(category, []).append(entry)
    if actions:
        found["actions"] = list(actions.values())
    return found


def _when(facts: Facts, key: Key, woken: Dict[Key, str]) -> Entry:
    """From which state of the node on, and upon what, there is such a name."""
    found: Entry = {}
    if facts.states and key not in facts.states.get("constructed", set()):
        if "configured" not in facts.states or key in facts.states["configured"]:
            found["exists"] = "configured"
        else:
            found["exists"] = "active"
    if key in woken:
        found["when"] = woken[key]
        found.pop("exists", None)
    return found


def _params(facts: Facts, owner: Owner, given: Set[str]) -> Tuple[List[Entry], Set[Tuple[str, str]]]:
    """The params of a node, and the topics whose QoS some of them change."""
    known: Dict[str, Entry] = {}
    changeable: Set[Tuple[str, str]] = set()
    for state, answered in facts.params.get(owner, []):
        for param in answered or []:
            name = param["name"]
            override = _OVERRIDES.fullmatch(name)
            if override is not None:
                changeable.add((_SIDES[override.group("side")], override.group("topic")))
            elif name not in _PARAMS and name not in known and not re.search(r"[\s~{}]", name):
                known[name] = _param(param, state, name in given)
    return list(known.values()), changeable


def _param(param: Entry, state: str, is_given: bool) -> Entry:
    entry = {key: value for key, value in param.items() if key not in ("name", "default" if is_given else "")}
    if not entry.get("type"):
        entry.pop("type", None)
    found = dict({"name": "~" + param["name"], "declared": True}, **entry)
    if state != "constructed":
        found["exists"] = state
    return found

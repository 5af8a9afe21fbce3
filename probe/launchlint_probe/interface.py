"""From recorded facts to an interface in the library format: kinds of names, actions, params; what every node has is left out."""

import json
import re
from typing import Any, Dict, List, Optional, Tuple

from launchlint_probe.recorder import Facts

NAMESPACE = "/launchlint_ns"
NODE = "launchlint_node"
FULL = NAMESPACE + "/" + NODE

Entry = Dict[str, Any]

_ANONYMOUS = re.compile(r"_\d+_\d{12,}(?=_|/|$)")
"""What rospy and roscpp append to anonymous names: the process id and the time in milliseconds (or nanoseconds)."""
_INFRASTRUCTURE = re.compile(
    r"/rosout|/rosout_agg|/clock|/statistics.*|.*/(get_loggers|set_logger_level)|/use_sim_time|/enable_statistics|/run_id|.*tcp_keepalive"
    r"|/rosout_disable_topics_generation|/roslaunch(/.*)?|/rosdistro|/rosversion|/launchlint_probe.*"
)
_ACTION_TYPES = {"status": "actionlib_msgs/GoalStatusArray", "cancel": "actionlib_msgs/GoalID"}


def spelled(name: str, tokens: Optional[Dict[str, str]] = None) -> str:
    """A recorded name as the node's code says it: relative, ``~private`` or ``/global``, with what changes from run to run left open.

    ``tokens`` maps words that the probe gave the node in its arguments and params to the templates that stand for them.
    """
    if name == FULL:
        own = "~"
    elif name.startswith(FULL + "/"):
        own = "~" + name[len(FULL) + 1 :]
    elif name.startswith(NAMESPACE + "/"):
        own = name[len(NAMESPACE) + 1 :]
    else:
        own = name
    own = own.replace("{", "{{").replace("}", "}}")
    own = _ANONYMOUS.sub("{any}", own)
    own = own.replace(NODE, "{node}").replace(NAMESPACE[1:], "{any}")
    for token in sorted(tokens or (), key=len, reverse=True):
        own = own.replace(token, (tokens or {})[token])
    return own


def is_infrastructure(name: str) -> bool:
    """Whether every node has this name."""
    return _INFRASTRUCTURE.fullmatch(name) is not None


class Harvest:
    """What was learnt of a node besides the recorded calls.

    Args:
        headers: topic → header of a connection to its publisher.
        services: service → header of its answer to a probe.
        woken: names that were not there from the start → what they appeared upon, ``subscriber`` or ``message``.
        reconfigure: full name of a param → what dynamic_reconfigure says of it.
        given: full names of params that the probe itself set.
        tokens: words that the probe gave the node → templates, see :func:`spelled`.
        clients: service → what the node's client said of it: type and MD5 sum.
    """

    def __init__(
        self,
        headers: Dict[str, Dict[str, str]],
        services: Dict[str, Dict[str, str]],
        woken: Dict[str, str],
        reconfigure: Dict[str, Dict[str, Any]],
        given: Dict[str, Any],
        tokens: Dict[str, str],
        clients: Optional[Dict[str, Dict[str, str]]] = None,
    ) -> None:
        self.headers = headers
        self.services = services
        self.woken = woken
        self.reconfigure = reconfigure
        self.given = given
        self.tokens = tokens
        self.clients = clients or {}


def interface(facts: Facts, harvest: Harvest) -> Dict[str, List[Entry]]:
    """The interface of a node, as the library format has it but for the evidence."""
    publishers = {name: kind for (_, name), (kind, _) in facts.publishers.items() if not is_infrastructure(name)}
    subscribers = {name: kind for (_, name), (kind, _) in facts.subscribers.items() if not is_infrastructure(name)}
    actions = _take_actions(publishers, subscribers)
    found: Dict[str, List[Entry]] = {
        "publishers": [_topic(name, kind, harvest.headers.get(name), harvest.woken) for name, kind in publishers.items()],
        "subscribers": [_topic(name, kind, None, harvest.woken) for name, kind in subscribers.items()],
        "services": [_typed(name, harvest.services.get(name, {})) for _, name in facts.services if not is_infrastructure(name)],
        "clients": [
            _typed(name, harvest.clients.get(name, {}))
            for name in facts.lookups
            if not is_infrastructure(name) and not any(name == served for _, served in facts.services)
        ],
        "actions": actions,
        "params": _params(facts, harvest.reconfigure, harvest.given),
    }
    return {category: _sorted(entries, harvest.tokens) for category, entries in found.items() if entries}


def per_node(facts: Facts) -> List[Entry]:
    """What each node of a launch file publishes, subscribes and serves, by its name; names are relative to the namespace of the launch
    file.
    """
    found: Dict[str, Dict[str, List[Entry]]] = {}
    for category, table in (("publishers", facts.publishers), ("subscribers", facts.subscribers), ("services", facts.services)):
        for (caller, name), (kind, _) in list(table.copy().items()):
            if is_infrastructure(name) or is_infrastructure(caller) or caller == "/rosout":
                continue
            entry = {"name": spelled(name)}
            if category != "services" and kind:
                entry["type"] = kind
            found.setdefault(spelled(caller), {}).setdefault(category, []).append(entry)
    nodes = []
    for caller in {spelled(each) for each in facts.nodes if each != "/rosout" and not is_infrastructure(each)} | set(found):
        node: Dict[str, Any] = {
            category: sorted(entries, key=lambda each: each["name"]) for category, entries in found.get(caller, {}).items()
        }
        nodes.append(dict(node, name=caller))
    return sorted(nodes, key=lambda node: node["name"])


def _sorted(entries: List[Entry], tokens: Dict[str, str]) -> List[Entry]:
    unique: Dict[Tuple[str, str], Entry] = {}
    for entry in entries:
        entry = dict(entry, name=spelled(entry["name"], tokens))
        unique.setdefault((entry["name"], entry.get("role", "")), entry)
    return [unique[key] for key in sorted(unique)]


def _topic(name: str, kind: str, header: Optional[Dict[str, str]], woken: Dict[str, str]) -> Entry:
    entry: Entry = {"name": name}
    if kind:
        entry["type"] = kind
    if header and header.get("md5sum", "*") != "*" and header.get("type") == kind:
        entry["md5"] = header["md5sum"]
    if header and header.get("latching") == "1":
        entry["latched"] = True
    if name in woken:
        entry["when"] = woken[name]
    return entry


def _typed(name: str, header: Dict[str, str]) -> Entry:
    entry: Entry = {"name": name}
    if header.get("type"):
        entry["type"] = header["type"]
    if header.get("md5sum", "*") != "*":
        entry["md5"] = header["md5sum"]
    return entry


def _take_actions(publishers: Dict[str, str], subscribers: Dict[str, str]) -> List[Entry]:
    """The actions among the topics, which are taken out: a server publishes status, feedback and result and hears goal and cancel."""
    found = []
    for role, out, into in (("server", subscribers, publishers), ("client", publishers, subscribers)):
        for name in sorted(out):
            base, _, last = name.rpartition("/")
            kind = out[name]
            if last != "goal" or not kind.endswith("ActionGoal"):
                continue
            action = kind[: -len("Goal")]
            others = {"cancel": out, "status": into, "feedback": into, "result": into}
            types = dict(_ACTION_TYPES, feedback=action + "Feedback", result=action + "Result")
            if all(table.get("{}/{}".format(base, each)) == types[each] for each, table in others.items()):
                found.append({"name": base, "type": action, "role": role})
                del out[name]
                for each, table in others.items():
                    del table["{}/{}".format(base, each)]
    return found


_KINDS = {bool: "bool", int: "int", float: "double", str: "str", list: "list", dict: "dict"}


def _is_plain(value: Any) -> bool:
    """Whether JSON can hold a value: a node may set dates, or numbers without end."""
    try:
        json.dumps(value, allow_nan=False)
        return True
    except (TypeError, ValueError, RecursionError):
        return False


def _params(facts: Facts, reconfigure: Dict[str, Dict[str, Any]], given: Dict[str, Any]) -> List[Entry]:
    names = [name for name in facts.reads if not is_infrastructure(name)]
    names += [name for name in reconfigure if name not in facts.reads]
    entries = []
    for name in names:
        entry: Entry = {"name": name}
        known = reconfigure.get(name)
        written = facts.writes.get(name)
        if known:
            entry.update({key: known[key] for key in ("type", "default", "min", "max") if key in known})
        elif written is not None and name not in given and type(written) in _KINDS:
            entry["type"] = _KINDS[type(written)]
            entry["default"] = written
        for key in ("default", "min", "max"):
            if key in entry and not _is_plain(entry[key]):
                del entry[key]
        entries.append(entry)
    # What is looked for is looked for in the node's own namespace first, then upward: relative, as where the search ends.
    searches = [name for name in facts.searches if not name.startswith("/") and not is_infrastructure("/" + name)]
    entries.extend({"name": "{}/{}".format(NAMESPACE, name)} for name in searches)
    return entries

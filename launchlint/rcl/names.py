"""Names: which are valid, how they expand, and what the remap rules of a node make of them.

Sources: ``rcl/src/rcl/expand_topic_name.c``, ``validate_topic_name.c``, ``node_resolve_name.c``, ``remap.c``, ``node.c``; and of rmw
``validate_node_name.c``, ``validate_namespace.c``, ``validate_full_topic_name.c``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache

from launchlint.rcl.remap import Rule

LONGEST_NODE_NAME = 255
LONGEST_NAME = 247
LONGEST_NAMESPACE = 245

_NODE_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_FULL_NAME = re.compile(r"(?:/[A-Za-z_][A-Za-z0-9_]*)+")
# As a program writes it: ``~`` in front (and no slash behind it if the name has two characters: rcl does not look at the last one),
# ``{name}`` for what is filled in.
_WRITTEN = re.compile(r"(?![0-9])(?:~(?=/|.?$))?(?:[A-Za-z0-9_/]|\{(?![0-9])[A-Za-z0-9_]*\})*")
_FILLED_IN = re.compile(r"\{([A-Za-z0-9_]*)\}")


def is_node_name(name: str) -> bool:
    """Whether rmw takes ``name`` as the name of a node."""
    return len(name) <= LONGEST_NODE_NAME and _NODE_NAME.fullmatch(name) is not None


def is_namespace(namespace: str) -> bool:
    """Whether rmw takes ``namespace`` as that of a node."""
    return namespace == "/" or (len(namespace) <= LONGEST_NAMESPACE and _FULL_NAME.fullmatch(namespace) is not None)


def is_full_name(name: str) -> bool:
    """Whether rmw takes ``name`` as that of a topic or service on the graph."""
    return len(name) <= LONGEST_NAME and _FULL_NAME.fullmatch(name) is not None


@lru_cache(maxsize=16384)  # the names of one program, and those in remap rules, are asked for with each node
def is_written(name: str) -> bool:
    """Whether a program may ask for ``name``: what it becomes may still be refused."""
    if not name or name.endswith("/") or _WRITTEN.fullmatch(name) is None:
        return False
    return re.search(r"/[0-9]", name) is None


def full_name(namespace: str, name: str) -> str:
    """The name of a node on the graph."""
    return f"{namespace}{name}" if namespace.endswith("/") else f"{namespace}/{name}"


class Names:
    """The names of one node: ``node_name`` and ``namespace`` are those its program gives it, ``rules`` what its command line says.

    ``node`` and ``namespace`` are what they become. A rule for a node counts by the name that the node has got.
    """

    __slots__ = ("_is_usable", "_rules", "_tables", "namespace", "node")

    def __init__(self, node_name: str, namespace: str, rules: Sequence[Rule] = ()) -> None:
        self._rules = rules
        self.node = next((rule.replacement for rule in rules if rule.acts == "node" and rule.node in (None, node_name)), node_name)
        given = namespace if namespace.startswith("/") else f"/{namespace}"
        self.namespace = next((rule.replacement for rule in rules if rule.acts == "namespace" and rule.node in (None, self.node)), given)
        self._is_usable = is_node_name(self.node) and is_namespace(self.namespace)
        self._tables: dict[str, Mapping[str, Rule]] = {}

    @property
    def full_name(self) -> str:
        """The name of the node on the graph."""
        return full_name(self.namespace, self.node)

    def topic(self, name: str) -> str | None:
        """What the topic becomes that the program calls ``name``; None where rcl refuses it."""
        return self._resolved(name, "topic")

    def service(self, name: str) -> str | None:
        """What the service becomes that the program calls ``name``; None where rcl refuses it."""
        return self._resolved(name, "service")

    def expand(self, name: str) -> str | None:
        """``name`` as the node means it, before any rule; None where rcl refuses it."""
        if not self._is_usable or not is_written(name):
            return None
        if name.startswith("/") and "{" not in name:
            return name
        if name.startswith("~"):
            name = self.full_name + name[1:]
        if "{" in name:
            values = {"node": self.node, "ns": self.namespace, "namespace": self.namespace}
            for word in set(_FILLED_IN.findall(name)):
                if word not in values:
                    return None
                name = name.replace(f"{{{word}}}", values[word])
        return name if name.startswith("/") else full_name(self.namespace, name)

    def rule(self, name: str, kind: str) -> Rule | None:
        """The first rule that acts on the expanded ``name``; ``kind`` is topic or service."""
        if kind not in self._tables:
            self._tables[kind] = self._acting_on(kind)
        return self._tables[kind].get(name)

    def _acting_on(self, kind: str) -> Mapping[str, Rule]:
        """The rules for names of a kind, by what they act on: of several for one name the first."""
        table: dict[str, Rule] = {}
        for rule in self._rules:
            expanded = self.expand(rule.match) if rule.acts in (kind, "both") and rule.node in (None, self.node) else None
            if expanded is not None:
                table.setdefault(expanded, rule)
        return table

    def _resolved(self, name: str, kind: str) -> str | None:
        expanded = self.expand(name)
        if expanded is None:
            return None
        rule = self.rule(expanded, kind)
        if rule is not None:
            expanded = self.expand(rule.replacement)
        return expanded if expanded is not None and is_full_name(expanded) else None

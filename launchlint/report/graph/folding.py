"""The tree of namespaces behind a picture, and which of them are opened so that it can still be read."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from launchlint.graph.containment import namespaces_of
from launchlint.graph.topology import TopologyNode


class Tree:
    """The namespaces of some nodes. One that holds nothing but another one is drawn as one box with it: ``/a/b``.

    ``namespaces`` are those that are drawn.
    """

    def __init__(self, nodes: Iterable[TopologyNode]) -> None:
        self._nodes: dict[str, list[str]] = {}
        chains: dict[str, tuple[str, ...]] = {}
        for node in nodes:
            self._nodes.setdefault(node.namespace, []).append(node.name)
            if node.namespace not in chains:
                chains[node.namespace] = namespaces_of(node)
        children: dict[str, dict[str, None]] = {}
        for chain in chains.values():
            for around, inner in zip(("", *chain), chain, strict=False):
                children.setdefault(around, {})[inner] = None
        passed = {each for each, inner in children.items() if each and len(inner) == 1 and each not in self._nodes}
        self._chains = {namespace: tuple(each for each in chain if each not in passed) for namespace, chain in chains.items()}
        self._parents: dict[str, str] = {}
        self._depths: dict[str, int] = {}
        self._children: dict[str, int] = {}
        for chain in self._chains.values():
            for depth, (around, inner) in enumerate(zip(("", *chain), chain, strict=False)):
                if inner not in self._parents:
                    self._parents[inner] = around
                    self._depths[inner] = depth
                    self._children[around] = self._children.get(around, 0) + 1

    @property
    def namespaces(self) -> frozenset[str]:
        """All that are drawn."""
        return frozenset(self._parents)

    def label(self, namespace: str) -> str:
        """What is written on it: its name within the one around it."""
        around = self._parents[namespace]
        return namespace[len(around) + 1 :] if around else namespace

    def visible(self, namespace: str, opened: Collection[str]) -> tuple[tuple[str, ...], str]:
        """The open namespaces around a node, outermost first, and the first one that is folded (empty: none)."""
        chain = self._chains[namespace]
        for number, each in enumerate(chain):
            if each not in opened:
                return chain[:number], each
        return chain, ""

    def order(self, lonely: Collection[str], gathered_from: int, most: int) -> list[str]:
        """The namespaces that can be opened with at most ``most`` boxes, in the order of opening: outer ones first, small ones first.

        ``lonely`` nodes are one box where a namespace has ``gathered_from`` or more of them.
        """
        cost: dict[str, int] = {}
        for namespace in ("", *self._parents):
            nodes = self._nodes.get(namespace or "/", ())
            alone = sum(name in lonely for name in nodes)
            boxes = len(nodes) - alone + (1 if alone >= gathered_from else alone)
            cost[namespace] = boxes + self._children.get(namespace, 0)
        opened: list[str] = []
        left = most - cost[""]
        known: set[str] = {""}
        for each in sorted(self._parents, key=lambda namespace: (self._depths[namespace], cost[namespace], namespace)):
            if cost[each] <= left and self._parents[each] in known:
                opened.append(each)
                known.add(each)
                left -= cost[each]
        return opened

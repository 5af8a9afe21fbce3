"""Params as nodes can read them: of the parameter server that a launch file fills (ROS 1), or each node's own (ROS 2)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from launchlint.library.template import UNKNOWN
from launchlint.model import Binary, Command, ParameterSetting, Unknown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.graph.names import Namer
    from launchlint.model import Node


class Parameters:
    """The params that a launch file sets on the server, by their full names; in the namespaces ``more`` there may be others."""

    def __init__(self, settings: Mapping[str, ParameterSetting], more: Sequence[str] = ()) -> None:
        self._settings = settings
        self._more = tuple({namespace.rstrip("/") for namespace in more})
        self._below: dict[str, list[str]] | None = None
        self._noted: dict[str, Any] = {}

    def noted(self) -> Mapping[str, Any]:
        """The values that were asked for since this was called the last time."""
        noted, self._noted = self._noted, {}
        return noted

    def value(self, name: str) -> Any:
        """The value of a param; a mapping of what is below it where only that is set; None where nothing is; UNKNOWN."""
        value = self._noted[name] = self._value(name)
        return value

    def _value(self, name: str) -> Any:
        setting = self._settings.get(name)
        if setting is not None:
            return _plain(setting.value)
        if any(f"{name}/".startswith(f"{namespace}/") or namespace.startswith(f"{name}/") for namespace in self._more):
            return UNKNOWN
        below = self._names_below(name)
        return self._tree(name, below) if below else self._inside(name)

    def read(self, name: str, namer: Namer) -> Any:
        """The value of what the code of a node calls ``name``."""
        return self.value(namer.resolve(name).name)

    def setting(self, name: str) -> ParameterSetting | None:
        """How the param itself is set."""
        return self._settings.get(name)

    def is_set(self, name: str) -> bool:
        """Whether the param, or something below it, is certainly set."""
        return name in self._settings or bool(self._names_below(name))

    @property
    def of_nodes(self) -> Iterable[tuple[str, Node]]:
        """The nodes that have params for themselves, by the names that they are called by; none where there is a server."""
        return ()

    def below(self, name: str) -> Sequence[str]:
        """The full names of what is set below ``name``, in the order of setting."""
        return self._names_below(name)

    def is_of(self, name: str, node: Node) -> bool:
        """Whether what is below ``name`` is what ``node`` has for itself, so that it hangs on nothing else; never so of a server."""
        return False

    def _tree(self, name: str, below: Sequence[str]) -> dict[str, Any]:
        tree: dict[str, Any] = {}
        for full in below:
            *steps, last = full[len(name) + 1 :].split("/")
            inner: Any = tree
            for step in steps:
                inner = inner.setdefault(step, {}) if isinstance(inner, dict) else None
            if isinstance(inner, dict):
                inner[last] = _plain(self._settings[full].value)
        return tree

    def _inside(self, name: str) -> Any:
        """A member of a mapping that is set as a whole."""
        outer, _, key = name.rpartition("/")
        while outer:
            setting = self._settings.get(outer)
            if setting is not None:
                value = setting.value
                for step in key.split("/"):
                    value = value.get(step) if isinstance(value, Mapping) else None
                return value
            outer, _, inner = outer.rpartition("/")
            key = f"{inner}/{key}"
        return None

    def _names_below(self, name: str) -> list[str]:
        if self._below is None:
            self._below = {}
            around: dict[str, list[list[str]]] = {}
            for full in self._settings:
                namespace = outer = full.rpartition("/")[0]
                lists = around.get(namespace)
                if lists is None:
                    lists = around[namespace] = []
                    while outer:
                        lists.append(self._below.setdefault(outer, []))
                        outer = outer.rpartition("/")[0]
                for names in lists:
                    names.append(full)
        return self._below.get(name, [])


class NodeParameters(Parameters):
    """The params of the nodes of ROS 2, each of which has its own: their full names are ``/node:param``."""

    def __init__(self, nodes: Iterable[tuple[str, Node]]) -> None:
        """``nodes`` with the names that they are called by."""
        super().__init__({})
        self._own = dict(nodes)

    @property
    def of_nodes(self) -> Iterable[tuple[str, Node]]:
        """All of them."""
        return self._own.items()

    def _value(self, name: str) -> Any:
        full, _, inner = name.partition(":")
        node = self._own.get(full)
        if node is None or node.own is None:
            return UNKNOWN
        typed = node.own.get(inner)
        if typed is None:
            return None
        return list(typed[1]) if isinstance(typed[1], tuple) else _plain(typed[1])

    def read(self, name: str, namer: Namer) -> Any:
        """The value of what the code of a node calls ``name``: it is always its own."""
        return self.value(f"{namer.graph_name}:{name.removeprefix('~').lstrip('/').replace('/', '.')}")

    def below(self, name: str) -> Sequence[str]:
        """The full names of the params of a node."""
        node = self._own.get(name)
        return [] if node is None else [f"{name}:{inner}" for inner in node.own or ()]

    def is_of(self, name: str, node: Node) -> bool:
        """Whether ``node`` is the one that is called ``name``."""
        return self._own.get(name) is node

    def is_set(self, name: str) -> bool:
        """Whether the param is certainly set."""
        return self._value(name) not in (None, UNKNOWN)


def _plain(value: Any) -> Any:
    return UNKNOWN if isinstance(value, (Unknown, Command, Binary)) else value

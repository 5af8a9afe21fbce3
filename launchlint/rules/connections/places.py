"""Where a person must act to change a name on the graph, and how that name came about."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.graph.connections import ConnectionGraph, Endpoint, Instance
from launchlint.graph.names import absolute, kind
from launchlint.source import Origin

Owners = Mapping[int, Instance]
"""The node of each endpoint, by the ``id`` of the endpoint: full names need not be unique."""

TALKS = {
    "publisher": "publishes",
    "subscriber": "subscribes to",
    "server": "serves",
    "client": "calls",
    "action server": "serves",
    "action client": "uses",
}
"""What a node of each role does with a name."""


def owners(graph: ConnectionGraph) -> Owners:
    """The node of each endpoint of ``graph``."""
    return {id(endpoint): instance for instance in graph.instances for endpoint in instance.endpoints}


def node_origin(instance: Instance) -> Origin:
    """The place of a node's name."""
    node = instance.node
    return Origin(node.attributes.get("name", node.origin.place), node.origin.step)


def remap_origin(endpoint: Endpoint) -> Origin | None:
    """The ``<remap>`` that acted last on the name, if any did."""
    for applied in reversed(endpoint.applied):
        if applied.rule.remap is not None:
            return applied.rule.remap.origin
    return None


def acting_origin(endpoint: Endpoint, instance: Instance) -> Origin:
    """Where the name is made: the last remap, ``args`` where it stands there, else the node."""
    remap = remap_origin(endpoint)
    if remap is not None:
        return remap
    if endpoint.applied and "args" in instance.node.attributes:
        return Origin(instance.node.attributes["args"], instance.node.origin.step)
    return node_origin(instance)


def how(endpoint: Endpoint, instance: Instance) -> str:
    """How the name came about, in words; empty where the code says it just so."""
    if endpoint.applied:
        rule = endpoint.applied[-1].rule
        return f"{instance.name} says {endpoint.declared}; the remap of {rule.source} to {rule.target} makes it {endpoint.name}"
    way = kind(endpoint.declared)
    if way == "global":
        return f"{instance.name} says {endpoint.declared}, a global name that no namespace changes"
    if way == "relative" and instance.namer.namespace.strip("/"):
        return f"{instance.name} says {endpoint.declared}; its namespace makes it {endpoint.name}"
    return ""


def new_remap(endpoint: Endpoint, instance: Instance, target: str) -> tuple[str, str]:
    """The two sides of a remap that gives ``endpoint``, on which none acts, the name ``target``."""
    namespace = instance.namer.namespace.strip("/")
    prefix = f"/{namespace}/" if namespace else "/"
    says = absolute(endpoint.declared, namespace, instance.namer.node)
    source = endpoint.declared if says == endpoint.unremapped else endpoint.unremapped
    return source, target[len(prefix) :] if not source.startswith("/") and target.startswith(prefix) else target


def write_remap(endpoint: Endpoint, instance: Instance, target: str) -> str:
    """What to write so that ``endpoint`` gets the name ``target``."""
    if endpoint.applied:
        rule = endpoint.applied[-1].rule
        remap = rule.remap
        namespace = instance.namer.namespace.strip("/")
        prefix = f"/{namespace}/" if namespace else "/"
        shown = target[len(prefix) :] if not rule.target.startswith(("/", "~")) and target.startswith(prefix) else target
        source = rule.source if remap is None else remap.source
        if endpoint.unremapped == target:
            return f"take the remap of {source} away"
        return f'let the remap of {source} lead to="{shown}"'
    source, shown = new_remap(endpoint, instance, target)
    return f'put <remap from="{source}" to="{shown}"/> into the <node> of {instance.name}'

"""A node is connected to no other node.

What it does: it looks for nodes whose every name is known and is used by nobody else in the launch, while other nodes of it talk to each
other. It is told only where nothing unknown could be the partner. Transforms (`/tf`) count as a connection; logging, diagnostics, the
clock and the services of dynamic_reconfigure do not.

## Why it matters

A node that nobody hears and that hears nobody has often lost its partner by a namespace or a remap. It may also be meant for people or
programs outside the launch file: that is why this is only an info.

## Example

```xml
<launch>
  <node pkg="turtlesim" type="turtlesim_node" name="turtle"/>
  <node pkg="turtlesim" type="draw_square" name="square"/>
  <node pkg="depthimage_to_laserscan" type="depthimage_to_laserscan" name="scanner"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="turtlesim" type="turtlesim_node" name="turtle"/>
  <node pkg="turtlesim" type="draw_square" name="square"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import HUBS, OFFERS, ConnectionGraph, Endpoint, Instance
from launchlint.rules.judging.name_places import node_origin
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL618", "isolated-node", Severity.INFO)

_TRANSFORMS = frozenset({"/tf", "/tf_static"})
"""Who has transforms, or wants some, is connected to all the others that do."""
_CALLS = ("client", "action client")
"""A node that only calls services, as those that load controllers do: whether they are there is told for each of them (LL614)."""
_CATEGORIES = ("publishers", "subscribers", "services", "clients", "actions")


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at every node whose interface is known."""
    graph = view.graph
    talking = {instance.name for instance in graph.instances if _talks(instance, graph)}
    for instance in graph.instances:
        if instance.name in talking or len(talking) < 2 or not _is_isolated(instance, graph):
            yield RULE.fine(node_origin(instance))
        else:
            does = sorted({endpoint.name for endpoint in _own(instance) if endpoint.certain and not endpoint.action})
            origin = node_origin(instance)
            some = ", ".join(does[:4]) + (" …" if len(does) > 4 else "")
            yield RULE.at(
                origin,
                f"{instance.name} is connected to no other node",
                label="nobody else uses its names",
                notes=(f"it has {some}",) if some else (),
                help="check its namespace and remaps, unless its partners are started elsewhere",
                cause=f"{origin.place.source.path} {instance.program}",  # a file of relays whose partners are in another launch
            )


def _own(instance: Instance) -> Iterator[Endpoint]:
    """The endpoints that can connect it to somebody."""
    for endpoint in instance.endpoints:
        if endpoint.name not in HUBS and not endpoint.is_plumbing:
            yield endpoint


def _talks(instance: Instance, graph: ConnectionGraph) -> bool:
    """Whether somebody else uses what it offers, or offers what it uses."""
    for endpoint in _own(instance):
        channel = graph.channels[endpoint.kind, endpoint.name]
        if any(other.node != endpoint.node for other in (channel.uses if endpoint.role in OFFERS else channel.offers)):
            return True
    return False


def _is_isolated(instance: Instance, graph: ConnectionGraph) -> bool:
    """Whether nothing unknown could be its partner."""
    own = list(_own(instance))
    if any(endpoint.name in _TRANSFORMS for endpoint in instance.endpoints):
        return False
    if (
        all(endpoint.role in _CALLS for endpoint in own)
        or not instance.certain
        or instance.node.is_test
        or any(instance.may_have_more(category) for category in _CATEGORIES)
    ):
        return False
    may = (graph.may_use if endpoint.role in OFFERS else graph.may_offer for endpoint in own)
    return not any(ask(endpoint.kind, endpoint.name, endpoint.type) for ask, endpoint in zip(may, own, strict=True))

"""Two remaps of a node look like a chain, and remaps do not chain.

With `a` to `b` and `b` to `c`, what the node calls `a` becomes `b`, and only what it calls `b` itself becomes `c`. It
is told where a node remaps a name to one that a scope around it remaps for every node, and meets nobody there. What somebody plainly
wanted is left alone: a name on which the node has a partner, and two such remaps in one node, as filters have that take `scan` and give
`scan_filtered`. It is an info where a node that is not known may be the partner, and of a node that no library knows. Topics of Python
nodes are an exception: rospy looks them up twice, so there two remaps do chain, and nothing is said.

In ROS 2 the scope has a `<set_remap>` (`SetRemap`), and no node is an exception: rcl takes the first remap that fits a name, and no other.

## Why it matters

The remap of the scope seems to hold for all nodes, but this one goes on talking on the name in the middle, mostly
alone.

## Example

```xml
<launch>
  <remap from="/odom" to="/base/odom"/>
  <node pkg="robot_pose_ekf" type="robot_pose_ekf" name="ekf">
    <remap from="vo" to="/odom"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <remap from="/odom" to="/base/odom"/>
  <node pkg="robot_pose_ekf" type="robot_pose_ekf" name="ekf">
    <remap from="vo" to="/base/odom"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import OFFERS, ConnectionGraph, Instance
from launchlint.model import ROS2, Node, Remap
from launchlint.rules.judging.resolved_remaps import has_known_name, resolve
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView
from launchlint.rules.wording import words_at

RULE = Rule("LL606", "remap-chain", Severity.WARNING)


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every node whose own remap leads to a name that a scope around it remaps too."""
    graph = view.graph
    for instance in graph.instances:
        node = instance.node
        if len(node.remaps) < 2 or not has_known_name(node) or not instance.certain or instance.kind == "manager":
            continue
        ros2 = view.dialect.name == ROS2
        by_source = {resolve(node, each.source): each for each in (reversed(node.remaps) if ros2 else node.remaps) if each.source}
        for source, remap in by_source.items():
            middle = resolve(node, remap.target)
            further = by_source.get(middle)
            if further is None or middle == source or not _is_own(node, remap) or _is_own(node, further):
                continue
            end = resolve(node, further.target)
            ends = _ends(instance, source)
            if end in (middle, source) or end in ends or not (middle in ends or instance.is_unknown):
                continue
            meets = _meets(graph, instance, middle)
            if meets is not True:
                meant = words_at(remap.origin).remap(remap.source, further.target) if ros2 else f'to="{further.target}"'
                yield _finding(node, remap, further, meant, sure=middle in ends and meets is False)


def _meets(graph: ConnectionGraph, instance: Instance, name: str) -> bool | None:
    """Whether the node is certainly connected to another one on ``name``, as was wanted then; None where that cannot be known."""
    possible = False
    for kind in ("topic", "service", "action"):
        channel = graph.channels.get((kind, name))
        ends = () if channel is None else (*channel.offers, *channel.uses)
        own = {each.role in OFFERS for each in ends if each.node == instance.name}
        if any(each.node != instance.name and (not own or (each.role in OFFERS) not in own) for each in ends):
            return True
        possible = possible or any((graph.may_use if offers else graph.may_offer)(kind, name) for offers in own)
    if graph.parameters.is_set(name):
        return True
    return None if possible else False


def _ends(instance: Instance, source: str) -> set[str]:
    """What becomes of ``source`` of the node's code; of an unknown Python node anything may: rospy looks topics up twice."""
    if instance.is_unknown and instance.node.executable.endswith(".py"):
        return {instance.namer.topic(source).name}
    endpoints = {endpoint.name for endpoint in instance.endpoints if endpoint.unremapped == source}
    return endpoints | {reading.name for reading in instance.readings if reading.unremapped == source}


def _is_own(node: Node, remap: Remap) -> bool:
    """Whether the remap stands inside the ``<node>``: those of scopes around it stand before it, or in another file."""
    at, home = remap.origin.place, node.origin.place
    return at.source is home.source and at.span.start > home.span.start and remap.origin.chain == node.origin.chain


def _finding(node: Node, remap: Remap, further: Remap, meant: str, *, sure: bool) -> Finding:
    return RULE.at(
        remap.origin,
        f"{remap.source} of {node.full_name} becomes {remap.target} and not {further.target}: remaps do not chain",
        severity=None if sure else Severity.INFO,
        label=f"ends at {remap.target}",
        related=((further.origin.place, "does not act on it"),),
        help=f"write {meant}, unless {remap.target} is what this node is to use",
    )

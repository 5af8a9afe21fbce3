"""Two remaps of a node look like a chain, and remaps do not chain.

With `a` to `b` and `b` to `c`, what the node calls `a` becomes `b`, and only what it calls `b` itself becomes `c`. It
is told where a node remaps a name to one that a scope around it remaps for every node. Two such remaps in one node
are an info only: the node may well have both names, as filters do that take `scan` and give `scan_filtered`. So is what
is said of a node that no library knows. Topics of Python nodes are an exception: rospy looks them up twice, so there
two remaps do chain, and nothing is said.

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
from launchlint.graph.connections import Instance
from launchlint.model import Node, Remap
from launchlint.rules.remaps.resolved import has_known_name, resolve
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView

RULE = Rule("LL606", "remap-chain", Severity.WARNING)


def check(view: GraphView) -> Iterator[Finding]:
    """Look at every node whose own remap leads to a name that is remapped too."""
    for instance in view.graph.instances:
        node = instance.node
        if len(node.remaps) < 2 or not has_known_name(node) or not instance.certain or instance.kind == "manager":
            continue
        by_source = {resolve(node, remap.source): remap for remap in node.remaps}
        for source, remap in by_source.items():
            middle = resolve(node, remap.target)
            further = by_source.get(middle)
            if further is None or middle == source or not _is_own(node, remap):
                continue
            end = resolve(node, further.target)
            ends = _ends(instance, source)
            if end not in (middle, source) and end not in ends and (middle in ends or instance.is_unknown):
                yield _finding(node, remap, further, sure=middle in ends and not _is_own(node, further))


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


def _finding(node: Node, remap: Remap, further: Remap, *, sure: bool) -> Finding:
    return RULE.at(
        remap.origin,
        f"{remap.source} of {node.full_name} becomes {remap.target} and not {further.target}: remaps do not chain",
        severity=None if sure else Severity.INFO,
        label=f"ends at {remap.target}",
        related=((further.origin.place, "does not act on it"),),
        help=f'write to="{further.target}", unless {remap.target} is what this node is to use',
    )

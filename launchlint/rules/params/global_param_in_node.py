"""A parameter inside a node has a global name, which roslaunch makes private.

Inside a `<node>` every `<param>` belongs to the node, also one whose name begins with `/`. It is an info, unless others look
for the global name: it is one that all nodes know, such as `/use_sim_time`, or the launch sets it elsewhere. The infos of one file are told
as one.

## Why it matters

`/use_sim_time` inside the node `/slam` becomes `/slam/use_sim_time`: the global parameter is not set. Where the node
asks for the private name anyway, the `/` only misleads.

## Example

```xml
<launch>
  <node pkg="gmapping" type="slam_gmapping" name="slam">
    <param name="/use_sim_time" value="true"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <param name="/use_sim_time" value="true"/>
  <node pkg="gmapping" type="slam_gmapping" name="slam"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.names import UNKNOWN_NAMESPACE, canonical
from launchlint.evaluate.problems import GlobalParamInNode
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL511", "global-param-in-node", Severity.WARNING)
WELL_KNOWN = frozenset(
    ("/enable_statistics", "/robot_description", "/robot_description_semantic", "/rosdistro", "/rosversion", "/run_id", "/tf_prefix",
     "/use_sim_time")
)  # fmt: skip


def tell(problem: GlobalParamInNode, view: LaunchView) -> Iterator[Finding]:
    """Say which parameter is set instead."""
    name, namespace = problem.name, problem.namespace
    private = canonical(namespace + name)
    becomes = "a private name" if UNKNOWN_NAMESPACE in namespace else private
    everybodys = canonical(name) in WELL_KNOWN or canonical(name) in view.launch.parameters
    yield RULE.at(
        problem.origin,
        f"the global name {name} becomes {becomes} inside a node",
        severity=None if everybodys else Severity.INFO,
        label="not global here",
        related=problem.related,
        cause="" if everybodys else problem.place.source.path,
        help=f"put the <param> above the <node> to set {name}, or write {name.lstrip('/')} for the private one",
    )

"""A `<set_remap>` or `<set_parameter>` in a group acts on nodes behind the group as well.

What it does: it looks for what a `<group>` sets for its nodes while something of the kind has been set outside of it before, and that is
given to a node behind the group, which would get another value else.

## Why it matters

A group puts back what was set in it, but not this: remaps and params are added to one list, which is made where the first of them is set.
A list that is older than the group keeps what the group adds. Nodes behind it are started with a remap or param that was not meant for
them.

## Example

```xml
<launch>
  <set_remap from="chatter" to="news"/>
  <group>
    <set_remap from="status" to="front_status"/>
    <node pkg="demo_nodes_cpp" exec="talker" name="front"/>
  </group>
  <node pkg="demo_nodes_cpp" exec="talker" name="rear"/>
</launch>
```

## Use instead

```xml
<launch>
  <set_remap from="chatter" to="news"/>
  <group>
    <node pkg="demo_nodes_cpp" exec="talker" name="front">
      <remap from="status" to="front_status"/>
    </node>
  </group>
  <node pkg="demo_nodes_cpp" exec="talker" name="rear"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.problems import LeaksFromGroup
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule

RULE = Rule("LL917", "setting-leaks-from-group", Severity.WARNING)


def tell(problem: LeaksFromGroup, view: object) -> Iterator[Finding]:
    """Say who gets it (launch_ros.actions.SetRemap and SetParameter change a list of the context in place)."""
    element = "remap" if problem.tag == "set_remap" else "param"
    yield RULE.at(
        problem.origin,
        f"this {problem.tag} acts on {problem.node} as well, which is started behind the group",
        label="not put back at the end of the group",
        related=problem.related,
        notes=(f"there has been a {problem.tag} outside of the group before it, and a group adds to the list which that one has begun",),
        help=f"write it as a <{element}> in the nodes of the group, or let the group come before the first {problem.tag} outside of it",
    )

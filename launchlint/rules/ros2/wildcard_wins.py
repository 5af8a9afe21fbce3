"""A value for one ROS 2 node loses against a key with wildcards, or against one that was read before it.

rcl puts what it reads under the same key together, over all files and params of the node, and the keys keep the order in which they came
first. Of two keys that reach the node, the later one wins: not the more exact one, and not the value that was read last. What a launch file
says in `<param name>` stands under `/**`, unless the node has both a `name` and a `namespace`.

## Why it matters

The node starts with another value than the one that stands there for it, and nobody says so.

## Example

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
talker:
  ros__parameters:
    rate: 5
/**:
  ros__parameters:
    rate: 1
```

## Use instead

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
/**:
  ros__parameters:
    rate: 1
talker:
  ros__parameters:
    rate: 5
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import LaterValueLost
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule

RULE = Rule("LL903", "wildcard-wins", Severity.WARNING)


def tell(problem: LaterValueLost, view: object) -> Iterator[Finding]:
    """Say which value counts, and why."""
    name, kept, kept_key, lost_key = problem.name, problem.kept, problem.kept_key, problem.lost_key
    why = f"the key {kept_key} came first after the key {lost_key}, and of keys the later one wins"
    if problem.later:
        why = f"it goes to the key {lost_key}, which came before the key {kept_key}: of keys the later one wins"
    yield RULE.at(
        problem.origin,
        f"{problem.node} does not get this value of {name}: it starts with {kept}",
        label=f"{problem.lost} does not count",
        related=problem.related,
        notes=(why,),
        help=f"give {name} the value under the key {kept_key}, or let {lost_key} come after it",
        topic=name,
    )

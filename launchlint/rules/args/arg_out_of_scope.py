"""An arg is used outside the group that declares it.

An `<arg>` in a `<group>` ends with the group.

## Why it matters

Outside the group the arg has no value: roslaunch refuses the file.

## Example

```xml
<launch>
  <group ns="robot1">
    <arg name="frame" value="robot1_base"/>
  </group>
  <param name="base_frame" value="$(arg frame)"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="frame" value="robot1_base"/>
  <group ns="robot1"/>
  <param name="base_frame" value="$(arg frame)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule

RULE = Rule("LL211", "arg-out-of-scope", Severity.ERROR, roslaunch="refuses")


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Point at the declaration; facts: ``name``, ``declaration`` (a place)."""
    name = problem.facts["name"]
    yield RULE.at(
        problem.origin,
        f"the arg {name} is declared in a group and used outside of it",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        related=((problem.facts["declaration"], "known inside this group only"),),
        notes=(f"roslaunch stops here, since {name} has no value",),
        help=f"declare {name} above the group, or move this into the group",
        topic=name,
    )

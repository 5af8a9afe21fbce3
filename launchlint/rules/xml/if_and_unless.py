"""An element has both `if` and `unless`.

## Why it matters

roslaunch takes one condition for each element and refuses the file, whatever the two would come to. So does launch in ROS 2.

## Example

```xml
<launch>
  <arg name="sim" default="false"/>
  <arg name="slam" default="true"/>
  <node pkg="amcl" type="amcl" name="amcl" if="$(arg sim)" unless="$(arg slam)"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="sim" default="false"/>
  <arg name="slam" default="true"/>
  <group if="$(arg sim)">
    <node pkg="amcl" type="amcl" name="amcl" unless="$(arg slam)"/>
  </group>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.syntax.problems import IfAndUnless
from launchlint.syntax.ros2.problems import BothConditions

RULE = Rule("LL108", "if-and-unless", Severity.ERROR, roslaunch="refuses")


def tell(problem: IfAndUnless | BothConditions, view: object) -> Iterator[Finding]:
    """Point at the second of the two."""
    ros2 = isinstance(problem, BothConditions)
    stops = "ros2 launch stops with: if and unless conditions can't be used simultaneously"
    yield RULE.at(
        problem.origin,
        f"<{problem.tag}> has both if and unless",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label="one condition too many",
        related=problem.related,
        notes=(stops if ros2 else "roslaunch stops with: cannot set both 'if' and 'unless' on the same tag",),
        help="keep one, and put the element into a <group> that has the other; or join them in one $(eval …)",
    )

"""A condition on `<launch>` holds a substitution.

roslaunch reads `if` and `unless` on `<launch>`, unlike anywhere else, before there are any args; and it takes no
notice of the outcome.

## Why it matters

The substitution ends in a Python traceback, so that the file cannot be loaded, neither by itself nor from an
`<include>`.

## Example

```xml
<launch if="$(arg sim)">
  <arg name="sim" default="true"/>
  <node pkg="gazebo_ros" type="gzserver" name="gazebo"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="sim" default="true"/>
  <group if="$(arg sim)">
    <node pkg="gazebo_ros" type="gzserver" name="gazebo"/>
  </group>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import ConditionOnLaunch
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.syntax.problems import InvalidValue

RULE = Rule("LL114", "condition-on-launch", Severity.ERROR, roslaunch="refuses")


def tell(problem: ConditionOnLaunch | InvalidValue, view: object) -> Iterator[Finding]:
    """Point at the condition. From the file alone it comes as the :class:`InvalidValue` of a ``<launch>``."""
    name = problem.attribute
    if isinstance(problem, InvalidValue) and not (problem.tag == "launch" and "$" in problem.value):
        return
    yield RULE.at(
        problem.origin,
        f"{name} on <launch> cannot hold a substitution",
        notes=("roslaunch ends with a Python traceback: AttributeError",),
        help="put the content into a <group> with this condition, or the condition on the <include> of this file",
    )

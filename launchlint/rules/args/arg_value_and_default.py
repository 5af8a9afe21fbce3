"""An `<arg>` has both `value` and `default`.

`default` is what an arg is unless somebody gives another value; `value` is fixed, and giving another one is an error.

## Why it matters

roslaunch refuses the file, even where both are the same.

## Example

```xml
<launch>
  <arg name="map" value="office" default="office"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="map" default="office"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule

RULE = Rule("LL204", "arg-value-and-default", Severity.ERROR, roslaunch="refuses")


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Point at both; facts: ``name``."""
    name = problem.facts["name"]
    yield RULE.at(
        problem.origin,
        f"the arg {name} has both value and default",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label="one too many",
        related=problem.related,
        notes=("roslaunch stops with: <arg> tag must have one and only one of value/default.",),
        help="keep default if others may change the arg, value if it is fixed",
    )

"""An arg is declared twice in one scope.

Each arg may be declared once in a file. A group may declare args of its own, but not one that the file around it has
declared; two declarations of which only one is evaluated (`if` and `unless` with the same value) are fine.

## Why it matters

The second declaration does not replace the first: roslaunch refuses the file.

## Example

```xml
<launch>
  <arg name="map" default="office"/>
  <arg name="map" default="workshop"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="at_work" default="false"/>
  <arg name="map" default="office" unless="$(arg at_work)"/>
  <arg name="map" default="workshop" if="$(arg at_work)"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule

RULE = Rule("LL203", "arg-redeclared", Severity.ERROR, roslaunch="refuses")


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Point at both; facts: ``name``. Silent where it depends on a condition of unknown value: the two may exclude each other."""
    if problem.assumed:
        return
    name = problem.facts["name"]
    yield RULE.at(
        problem.origin,
        f"the arg {name} is declared twice",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label="the second declaration",
        related=problem.related,
        notes=(f"roslaunch stops with: arg '{name}' has already been declared",),
        help="remove one, or give them conditions that exclude each other",
    )

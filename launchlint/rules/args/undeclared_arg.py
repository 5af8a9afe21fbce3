"""A `$(arg …)` names an arg that is declared nowhere.

## Why it matters

roslaunch refuses the file as soon as it evaluates the element. In a branch that is rarely taken that may be on the
day of the demonstration.

## Example

```xml
<launch>
  <arg name="scan_topic" default="scan"/>
  <remap from="scan" to="$(arg scan_topci)"/>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="scan_topic" default="scan"/>
  <remap from="scan" to="$(arg scan_topic)"/>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

## Fix

`--unsafe-fixes` reads the arg with the most similar name.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.problem import Problem
from launchlint.rules.edits import LOADS, fix, replace, spot
from launchlint.rules.rule import Rule
from launchlint.spelling import closest

RULE = Rule("LL201", "undeclared-arg", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Name the arg that was meant; facts: ``name``, ``known`` (args in scope)."""
    name, known = problem.facts["name"], problem.facts["known"]
    near = closest(name, known)
    yield RULE.at(
        problem.origin,
        f"the arg {name} is not declared",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        related=problem.related,
        notes=(f"roslaunch stops here, since {name} has no value",),
        help=f"did you mean {near}?" if near is not None else f'declare it above: <arg name="{name}" default="…"/>',
        topic=name,
        fix=None if near is None else _fix(problem, view, name, near),
    )


def _fix(problem: Problem, view: object, name: str, near: str) -> Fix | None:
    """The arg with the near name is read instead, where the place is the name or a substitution with it."""
    text = problem.place.text
    if text.count(name) != 1:
        return None
    return fix(f"read {near}", replace(spot(view, problem.place), problem.place, text.replace(name, near)), safe=False, changes=LOADS)

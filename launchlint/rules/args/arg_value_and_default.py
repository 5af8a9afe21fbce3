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

## Fix

`--unsafe-fixes` removes `value` where `default` says the same: then others may change the arg.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS, fix, remove_attribute, spot
from launchlint.rules.rule import Rule
from launchlint.syntax.problems import ArgValueAndDefault

RULE = Rule("LL204", "arg-value-and-default", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: ArgValueAndDefault, view: object) -> Iterator[Finding]:
    """Point at both."""
    name = problem.name
    yield RULE.at(
        problem.origin,
        f"the arg {name} has both value and default",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label="one too many",
        related=problem.related,
        notes=("roslaunch stops with: <arg> tag must have one and only one of value/default.",),
        help="keep default if others may change the arg, value if it is fixed",
        fix=_fix(problem, view),
    )


def _fix(problem: ArgValueAndDefault, view: object) -> Fix | None:
    """Where both say the same, the value goes: then others may change the arg, as its default says."""
    at = spot(view, problem.place)
    if at is None or at.element.get("value") != at.element.get("default") or "value" not in at.element.attributes:
        return None
    return fix("keep default", remove_attribute(at._replace(attribute=at.element.attributes["value"])), safe=False, changes=LOADS)

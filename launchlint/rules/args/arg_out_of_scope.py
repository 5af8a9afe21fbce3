"""An arg is used outside the group that declares it.

An `<arg>` in a `<group>` ends with the group. All args of one group that are used outside of it are told as one.

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

from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import ArgOutOfScope
from launchlint.finding import Finding, Severity
from launchlint.rules.edits import spot
from launchlint.rules.judging.joined import joined
from launchlint.rules.rule import Rule
from launchlint.source import Place

RULE = Rule("LL211", "arg-out-of-scope", Severity.ERROR, roslaunch="refuses")
MOST_NAMED = 4


def tell(problem: ArgOutOfScope, view: object) -> Iterator[Finding]:
    """Point at the declaration."""
    name = problem.name
    declaration: Place = problem.declaration
    at = spot(view, declaration)
    group = None if at is None else at.element.parent
    yield RULE.at(
        problem.origin,
        f"the arg {name} is declared in a group and used outside of it",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        related=((declaration, "known inside this group only"),),
        notes=(f"roslaunch stops here, since {name} has no value",),
        help=f"move the declaration of {name} above the group, or this into the group",
        topic=name,
        cause="" if group is None else f"{declaration.source.path} {group.span.start}",
    )


def together(findings: Sequence[Finding]) -> Finding:
    """All that one group declares and that is used outside of it, by the names of the args."""
    result = joined(findings)
    names = sorted({finding.topic for finding in findings})
    if len(names) < 2:
        return result
    listed = ", ".join(names[:MOST_NAMED]) + (" …" if len(names) > MOST_NAMED else "")
    return result._replace(
        message=f"{len(names)} args are declared in a group and used outside of it: {listed}",
        help="move their declarations above the group, or what uses them into the group",
    )

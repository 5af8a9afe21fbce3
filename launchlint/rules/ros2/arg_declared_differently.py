"""An arg has two defaults on one path, and only the first counts.

What it does: it looks for an arg that is declared with a default where a file around this one has declared it already with another default,
and the include does not pass it. Where both stand in one file it is a warning.

## Why it matters

Who changes the second default sees no effect: the file gets the other one whenever it is included from there. Started by itself it goes on
with its own.

## Example

```xml main.launch.xml
<launch>
  <arg name="rate" default="30"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="driver"/>
  <include file="$(dirname)/camera.launch.xml"/>
</launch>
```

```xml camera.launch.xml
<launch>
  <arg name="rate" default="15"/>
  <node pkg="demo_nodes_cpp" exec="talker" args="$(var rate)"/>
</launch>
```

## Use instead

```xml main.launch.xml
<launch>
  <arg name="rate" default="30"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="driver"/>
  <include file="$(dirname)/camera.launch.xml">
    <arg name="rate" value="$(var rate)"/>
  </include>
</launch>
```

```xml camera.launch.xml
<launch>
  <arg name="rate" default="15"/>
  <node pkg="demo_nodes_cpp" exec="talker" args="$(var rate)"/>
</launch>
```
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from launchlint.evaluate.ros2.problems import DefaultOverruled
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.rule import Rule, shortened
from launchlint.rules.wording import words_at

RULE = Rule("LL915", "arg-declared-differently", Severity.INFO)
_EMPTY = "an empty text"


def tell(problem: DefaultOverruled, view: object) -> Iterator[Finding]:
    """Say which default counts (launch.actions.DeclareLaunchArgument: the first that is executed)."""
    if problem.left:
        return
    name, root = problem.name, root_of(problem.place.source)
    default, value = (shown(each, root) if posixpath.isabs(each) else each for each in (problem.default, problem.value))
    where = "above" if problem.same_file else f"in {problem.setter}"
    advice = "remove one of them" if problem.same_file else f"pass it in the include: {words_at(problem.origin).passed_on(name)}"
    yield RULE.at(
        problem.origin,
        f"the default of {name} does not count: {where} it is declared with {value or _EMPTY}",
        severity=Severity.WARNING if problem.same_file else None,
        label=f"{default or _EMPTY} does not count",
        related=problem.related,
        notes=("of two declarations on one path the first one sets the default",),
        help=advice,
        topic=name,
        cause=f"{problem.setter} {problem.place.source.path}",
    )


def together(findings: Sequence[Finding]) -> Finding:
    """All args of two files, by their names."""
    told = joined(findings)
    names = list(dict.fromkeys(each.topic for each in findings))
    if len(names) < 2:
        return told
    message = f"the defaults of {shortened(', '.join(names))} do not count: they are declared before with others"
    return told._replace(message=message, help="pass them in the include" if "include" in told.help else told.help)

"""An arg is used above its declaration, or args need each other.

roslaunch reads a file from top to bottom: what an arg's value uses must have been declared above it. Where args need
each other in a circle, no order helps; the whole circle is shown. In ROS 2 it is the same: a `$(var x)` above its `<arg name="x">` has no
value, unless somebody has set it before.

## Why it matters

roslaunch refuses the file, unless the arg is given on the command line: it may work for its author and for nobody
else.

## Example

```xml
<launch>
  <arg name="map" default="$(arg site)_map"/>
  <arg name="site" default="office"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="site" default="office"/>
  <arg name="map" default="$(arg site)_map"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```

## Fix

`--fix` moves a declaration that comes too late up, above what reads it. roslaunch loads the file then. Circles are left to their author.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import UndeclaredArg, UsedBeforeDeclaration
from launchlint.finding import Finding, Fix, Severity
from launchlint.plural import listed
from launchlint.rules.edits import LOADS, fix, move_before, spot
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.ros2_args import declared_below
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Place

_ITSELF = " from itself"
_MOST_NAMED = 6
RULE = Rule("LL205", "arg-cycle", Severity.ERROR, roslaunch="refuses", fixable="safe")


def tell(problem: UsedBeforeDeclaration | UndeclaredArg, view: LaunchView) -> Iterator[Finding]:
    """Show the circle, or the declaration that comes too late."""
    name = problem.name
    if isinstance(problem, UndeclaredArg):
        yield from _too_early(problem, view)
        return
    cycle: tuple[tuple[str, Place], ...] = problem.cycle
    related = problem.related
    if len(cycle) == 1:
        message, advice, related = f"the arg {name} is made from itself", "write its value out, or use an arg of another name", ()
    elif cycle:
        names = [each for each, _ in cycle]
        message = f"args need each other: {' needs '.join([*names, names[0]])}"
        advice = "give one of them a value that does not need the others"
        related = tuple((place, f"{each} needs {after}") for (each, place), after in zip(cycle, [*names[1:], names[0]], strict=True))
    else:
        message, advice = f"the arg {name} is used above its declaration", f"move the declaration of {name} up, above this"
    yield RULE.at(
        problem.origin,
        message,
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label=f"{name} has no value yet",
        related=related,
        notes=("roslaunch reads from top to bottom and stops here",),
        help=advice,
        topic=name,
        cause=f"{problem.place.source.path}{_ITSELF}" if len(cycle) == 1 else "",
        fix=None if cycle else _fix(problem, view),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """The args of one file that are made from themselves, by their names."""
    told, names = joined(findings), list(dict.fromkeys(each.topic for each in findings))
    if len(names) < 2 or not told.cause.endswith(_ITSELF):
        return told
    return told._replace(message=f"{listed(names, _MOST_NAMED)} are made from themselves")


def _too_early(problem: UndeclaredArg, view: LaunchView) -> Iterator[Finding]:
    """The same in ROS 2, where the launch configuration may be given by others: an error only where nobody is known who does."""
    below = declared_below(problem, view)
    if below is None:
        return
    name, alone = problem.name, problem.origin.step is None
    in_python = problem.place.source.path.endswith(".py")  # where one place may read several names, in a loop
    yield RULE.at(
        problem.origin,
        f"{name} is read above its declaration",
        severity=None if problem.refused else Severity.WARNING,
        label=f"{name} has no value yet",
        related=((below, "declared here"),),
        notes=(f"ros2 launch stops here with: launch configuration '{name}' does not exist{', unless it is given' if alone else ''}",),
        help=f"move the declaration of {name} up, above this",
        topic=name,
        cause=f"{problem.place.source.path} {problem.place.span.start if in_python else name}",
    )


def _fix(problem: UsedBeforeDeclaration, view: object) -> Fix | None:
    """The declaration moves up, above what stands in ``<launch>`` around the place that reads it."""
    reader, declared = spot(view, problem.place), spot(view, problem.related[0][0]) if problem.related else None
    if reader is None or declared is None or declared.document is not reader.document:
        return None
    above = reader.element
    while above.parent is not None and above.parent is not declared.element.parent:
        above = above.parent
    return fix(f"move the declaration of {problem.name} up", move_before(declared, above), safe=True, changes=LOADS)

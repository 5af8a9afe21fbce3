"""An arg is declared twice in one scope.

Each arg may be declared once in a file. A group may declare args of its own, but not one that the file around it has
declared; two declarations of which only one is evaluated (`if` and `unless` with the same value) are fine. Two of which each has a switch
of its own (`if="$(arg left)"`, `if="$(arg right)"`), so that only another value of an arg than its default brings them together, are
alternatives: that is an info.

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

## Fix

`--fix` removes the second declaration where it says the same as the first. roslaunch loads the file then.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import ArgRedeclared
from launchlint.finding import Finding, Fix, Severity
from launchlint.late import late
from launchlint.plural import listed
from launchlint.rules.edits import LOADS, fix, remove_element, spot
from launchlint.rules.judging.joined import alike, joined
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL203", "arg-redeclared", Severity.ERROR, roslaunch="refuses", fixable="safe")
_MOST_NAMED = 6
_WORD = late(r"\w+")


def tell(problem: ArgRedeclared, view: LaunchView) -> Iterator[Finding]:
    """Point at both. Silent where it depends on a condition of unknown value: the two may exclude each other."""
    if problem.assumed:
        return
    name = problem.name
    switches = _own_switches(problem, view) if view.tried else []
    notes: tuple[str, ...] = (f"roslaunch stops with: arg '{name}' has already been declared",)
    if switches:
        notes = (*notes, f"only one of the two hangs on {' and on '.join(switches)}, so that they may be alternatives")
    yield RULE.at(
        problem.origin,
        f"the arg {name} is declared twice",
        severity=Severity.INFO if switches else Severity.ERROR if problem.refused else Severity.WARNING,
        label="the second declaration",
        related=problem.related,
        notes=notes,
        help="remove one, or give them conditions that exclude each other",
        topic=name,
        cause=f"{problem.place.source.path}{' '.join(['', *switches])}",
        fix=None if switches else _fix(problem, view),
    )


def _own_switches(problem: ArgRedeclared, view: LaunchView) -> list[str]:
    """The args that the `if` of one of the two declarations names, and that of the other does not; both have one."""
    both = [spot(view, place) for place in (problem.place, *(place for place, _ in problem.related[:1]))]
    said = [condition for at in both if at is not None and (condition := at.element.get("if"))]
    if len(said) < 2:
        return []
    declared = {each.name for each in view.launch.declared}
    one, other = (declared.intersection(_WORD.findall(each)) for each in said)
    return sorted(one ^ other) if one and other else []


def together(findings: Sequence[Finding]) -> Finding:
    """The args that one file declares twice, by their names."""
    told, names = joined(findings), list(dict.fromkeys(each.topic.rpartition(":")[2] for each in findings))
    return told if len(names) < 2 else told._replace(message=f"{listed(names, _MOST_NAMED)} are declared twice")


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for the same args, declared twice in the same words in several files: the block was copied."""
    for several in alike(findings, lambda each: (each.message, each.location.text.strip())):
        yield from [joined(several)] if len(several) > 1 else several


def _fix(problem: ArgRedeclared, view: LaunchView) -> Fix | None:
    """Of two declarations that say the same, the second goes."""
    second = spot(view, problem.place)
    first = spot(view, problem.related[0][0]) if problem.related else None
    if first is None or second is None or first.document is not second.document or first.element.tag != second.element.tag:
        return None
    said = [{name: each.value for name, each in at.element.attributes.items()} for at in (first, second)]
    return fix("remove this declaration", remove_element(second), safe=True, changes=LOADS) if said[0] == said[1] else None

"""An arg without a value has to be given on the command line.

An `<arg>` without `default` and `value` is required. In a file that others include that is how it should be; in one
that people start it means typing `name:=value` each time. This is told as information only, unless the configuration
says how the file is started (`entries`) and leaves the arg out: then it is an error.

An arg with `default=""` stands for the same where roslaunch refuses the file with the empty value (a namespace, a
name, a condition made from it): that is told here, once, and not at each of the places that break.

## Why it matters

Without the arg roslaunch refuses the file.

## Example

```xml
<launch>
  <arg name="map"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map)"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="map" default="$(dirname)/office.yaml"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import RequiredArgUnset
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView, of_ros2

RULE = Rule("LL202", "required-arg-unset", Severity.INFO, roslaunch="refuses")


def tell(problem: RequiredArgUnset, view: LaunchView) -> Iterator[Finding]:
    """Point at the declaration. An error where the configuration file names this entry and gives no value."""
    if of_ros2(view):
        from launchlint.rules.judging import ros2_args as ros2_words

        yield from ros2_words.required(problem, RULE, view)
        return
    name, empty = problem.name, problem.empty
    path = view.launch.entry.path
    if view.declared_entry:
        severity, message = Severity.ERROR, f"the configuration starts {path} without the arg {name}, which it requires"
        advice = f"give it a default, or add {name} to the args of this entry in .launchlint.yaml"
    else:
        severity, message = Severity.INFO, f"{path} can only be started with {name}:=…"
        advice = f'add default="…" if there is a usual value; check it with --arg {name}:=VALUE'
    stops = f"without it roslaunch stops with: requires the '{name}' arg to be set"
    if empty:
        stops = "with the empty default roslaunch refuses the file"
        advice = f"leave the default out, so that roslaunch says what is missing, or give it a value; check it with --arg {name}:=VALUE"
    yield RULE.at(
        problem.origin,
        message,
        severity=severity,
        label="an empty default" if empty else "no default",
        related=problem.related,
        notes=(stops,),
        help=advice,
        topic=name,
    )

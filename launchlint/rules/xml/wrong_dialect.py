"""A tag, attribute or substitution of ROS 2 stands in a ROS 1 launch file.

`exec` and `namespace` of a `<node>`, `<let>`, `<push-ros-namespace>`, `$(var …)` and `$(find-pkg-share …)` belong to
the launch files of ROS 2, which look much the same.

## Why it matters

roslaunch skips the tags and attributes that it does not know, with a warning: so does launchlint. It refuses the substitutions, and a
node with `exec` in place of `type`: these are errors.

## Example

```xml
<launch>
  <arg name="map" default="office"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(var map).yaml"/>
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

`--unsafe-fixes` writes `type` for `exec`, `ns` for `namespace`, `args` for `ros_args`, `doc` for `description`, `$(arg …)` for `$(var …)`
and `$(find …)` for `$(find-pkg-share …)`.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS, fix, rename_attribute, replace, spot
from launchlint.rules.rule import Rule
from launchlint.syntax.parts import Substitution
from launchlint.syntax.problems import WrongDialect
from launchlint.syntax.ros1.substitutions import parse

_SAME = {"var": "arg", "find-pkg-share": "find"}

RULE = Rule("LL112", "wrong-dialect", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: WrongDialect, view: object) -> Iterator[Finding]:
    """Give the way of ROS 1."""
    what, construct, instead = problem.what, problem.construct, problem.instead
    if what == "tag":
        message, note = f"<{construct}> is a tag of ROS 2", "roslaunch (ROS 1) prints a warning and skips it, with all that it contains"
    elif what == "attribute":
        message = f"{construct} is an attribute of ROS 2"
        dropped = "roslaunch (ROS 1) prints a warning and drops it"
        note = f"{dropped}, and then misses the attribute it needs instead" if problem.refused else dropped
    else:
        message, note = f"{construct} is a substitution of ROS 2", "roslaunch (ROS 1) stops with: Unknown substitution command"
    yield RULE.at(
        problem.origin,
        message,
        severity=None if problem.refused else Severity.WARNING,
        label="ROS 2",
        notes=(note,),
        help=f"in ROS 1: {instead}" if instead else "ROS 1 has nothing like it: remove it",
        fix=_fix(problem, view),
    )


def _fix(problem: WrongDialect, view: object) -> Fix | None:
    """What has another name in ROS 1 and means the same gets that."""
    what, instead, place = problem.what, problem.instead, problem.place
    at = spot(view, place)
    if what == "attribute" and instead.isidentifier():
        return fix(f"write {instead}", rename_attribute(at, instead), safe=False, changes=LOADS)
    written = parse(place.text).alone if what == "substitution" else None
    if isinstance(written, Substitution) and written.command in _SAME and written.only:
        text = f"$({_SAME[written.command]} {written.only})"
        return fix(f"write {text}", replace(at, place, text), safe=False, changes=LOADS)
    return None

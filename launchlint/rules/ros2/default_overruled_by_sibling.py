"""The default of an arg does not count: an included file that came before has left another value.

What it does: it looks for args with a default that get their value from what another include was passed, or from what the file of another
include declares or sets, though neither this file nor one that includes it has anything to do with that include. Of an arg that nobody
reads LL206 tells alone.

## Why it matters

ROS 2 launch has one set of launch configurations for all files, and an include puts nothing back when it ends. So the order of includes
decides what a file starts, and the second of two includes that look alike goes on with the values of the first one. Nobody says so.

## Example

```xml main.launch.xml
<launch>
  <include file="$(dirname)/camera.launch.xml">
    <arg name="rate" value="30"/>
  </include>
  <include file="$(dirname)/lidar.launch.xml"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="driver"/>
</launch>
```

```xml camera.launch.xml
<launch>
  <arg name="rate" default="15"/>
  <node pkg="demo_nodes_cpp" exec="talker" args="$(var rate)"/>
</launch>
```

```xml lidar.launch.xml
<launch>
  <arg name="rate" default="10"/>
  <node pkg="demo_nodes_cpp" exec="listener" args="$(var rate)"/>
</launch>
```

## Use instead

```xml main.launch.xml
<launch>
  <group>
    <include file="$(dirname)/camera.launch.xml">
      <arg name="rate" value="30"/>
    </include>
  </group>
  <include file="$(dirname)/lidar.launch.xml"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="driver"/>
</launch>
```

```xml camera.launch.xml
<launch>
  <arg name="rate" default="15"/>
  <node pkg="demo_nodes_cpp" exec="talker" args="$(var rate)"/>
</launch>
```

```xml lidar.launch.xml
<launch>
  <arg name="rate" default="10"/>
  <node pkg="demo_nodes_cpp" exec="listener" args="$(var rate)"/>
</launch>
```
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from launchlint.evaluate.ros2.problems import ArgUnused, DefaultOverruled
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.rule import Rule, shortened
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import words_at

RULE = Rule("LL911", "default-overruled-by-sibling", Severity.WARNING)
_HOW = {"passed": "was passed to another include", "default": "is the default of another file", "let": "was set in another file"}


def tell(problem: DefaultOverruled, view: LaunchView) -> Iterator[Finding]:
    """Say where the value comes from (launch.actions.DeclareLaunchArgument sets a default only where nothing is set)."""
    if (
        not problem.left
        or _is_same_switch(problem.default, problem.value)
        or problem.name in view.once(_unread).get(problem.place.source.path, ())
    ):
        return
    name, group = problem.name, words_at(problem.origin).tag("group")
    root = root_of(problem.place.source)
    default, value = (shown(each, root) if posixpath.isabs(each) else each for each in (problem.default, problem.value))
    yield RULE.at(
        problem.origin,
        f"the default of {name} does not count: it is {value} here, which {_HOW[problem.how]} before",
        label=f"{default} does not count",
        related=problem.related,
        notes=("an include leaves behind whatever it was passed and whatever its file has set",),
        help=f"put that include into a {group}, or pass {name} in the include of {problem.place.source.path}",
        topic=name,
        cause=f"{problem.setter} {problem.place.source.path}",
        about=(group,),
    )


def _unread(view: LaunchView) -> dict[str, set[str]]:
    """The args of each file, by its path, that neither it nor anything behind it reads: LL206 tells of them."""
    found: dict[str, set[str]] = {}
    for each in view.launch.noticed(ArgUnused):
        found.setdefault(each.place.source.path, set()).add(each.name)
    return found


def _is_same_switch(default: str, value: str) -> bool:
    """Whether both say true, or both false, in the ways of Python and of XML."""
    return default.lower() == value.lower() in ("true", "false")


def together(findings: Sequence[Finding]) -> Finding:
    """All that one file leaves to another one, by the names of the args."""
    told = joined(findings)
    names = list(dict.fromkeys(each.topic for each in findings))
    if len(names) < 2:
        return told
    message = f"the defaults of {shortened(', '.join(names))} do not count: an include before has left other values"
    advice = f"put that include into a {told.about[0]}, or pass them in the include of {told.location.path}"
    return told._replace(message=message, help=advice)

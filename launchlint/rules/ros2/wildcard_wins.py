"""A value for one ROS 2 node loses against a key with wildcards, or against one that was read before it.

rcl puts what it reads under the same key together, over all files and params of the node, and the keys keep the order in which they came
first. Of two keys that reach the node, the later one wins: not the more exact one, and not the value that was read last. What a launch file
says in `<param name>` stands under `/**`, unless the node has both a `name` and a `namespace`. It is an information where the node is of
a public program that is not known to read the param, which may be one of another release.

## Why it matters

The node starts with another value than the one that stands there for it, and nobody says so.

## Example

```xml talk.launch.xml
<launch>
  <node pkg="my_robot" exec="talker" name="talker">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
talker:
  ros__parameters:
    rate: 5
/**:
  ros__parameters:
    rate: 1
```

## Use instead

```xml talk.launch.xml
<launch>
  <node pkg="my_robot" exec="talker" name="talker">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
/**:
  ros__parameters:
    rate: 1
talker:
  ros__parameters:
    rate: 5
```
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import LaterValueLost
from launchlint.finding import Finding, Severity
from launchlint.library.shipped import Bundled
from launchlint.model import ROS2
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL903", "wildcard-wins", Severity.WARNING)
_LONGEST = 60


def tell(problem: LaterValueLost, view: LaunchView) -> Iterator[Finding]:
    """Say which value counts, and why."""
    name, kept_key, lost_key = problem.name, problem.kept_key, problem.lost_key
    root = root_of(problem.place.source)
    lost, kept = (_short(value, root) for value in (problem.lost, problem.kept))
    why = f"the key {kept_key} came first after the key {lost_key}, and of keys the later one wins"
    if problem.later:
        why = f"it goes to the key {lost_key}, which came before the key {kept_key}: of keys the later one wins"
    other = _of_other_release(problem, view)
    yield RULE.at(
        problem.origin,
        f"{problem.node} does not get this value of {name}: {f'it would get {kept}' if other else f'it starts with {kept}'}",
        severity=Severity.INFO if other else None,
        label=f"{lost} does not count",
        related=problem.related,
        notes=(why, *((other,) if other else ())),
        help=f"give {name} the value under the key {kept_key}, or let {lost_key} come after it",
        topic=name,
    )


def _short(value: str, root: str) -> str:
    """A value that can be read: a path from the directory that is checked, and of a long one the beginning."""
    value = shown(value, root) if posixpath.isabs(value) else value
    return value if len(value) <= _LONGEST else f"{value[:_LONGEST]}…"


def _of_other_release(problem: LaterValueLost, view: LaunchView) -> str:
    """Why the node may know no such param: it is one of a public program that is known not to read it; empty where nothing says so.

    Params of plugins have names of several parts, and which these are hangs on the plugins.
    """
    if "." in problem.name:
        return ""
    node = next((each for each in view.launch.nodes if each.full_name == problem.node and each.knows("package", "executable")), None)
    if node is None or view.packages.colcon.get(node.package, view.launch.entry.file) is not None:
        return ""
    known = (Bundled(ROS2).package(node.package) or {}).get("executables", {}).get(node.executable)
    if known is None or any(each.get("name") == f"~{problem.name}" for way in known.get("variants", {}).values() for each in way["params"]):
        return ""
    return f"{node.package}/{node.executable} is not known to read {problem.name}: it may be a param of another release"

"""A namespace that an included file pushes is still there behind the include.

What it does: it looks for a `<push_ros_namespace>` of an included file, outside of any group, that is in force where something else is
started afterwards. A file that starts nothing itself is there to set something, and nothing is said of it, nor of a
namespace that is empty.

## Why it matters

An include puts nothing back. Whatever is started behind it gets the namespace of the included file, and its topics are others than they
were before somebody added the include, or moved it up.

## Example

```xml main.launch.xml
<launch>
  <include file="$(dirname)/camera.launch.xml"/>
  <node pkg="demo_nodes_cpp" exec="listener" name="listener"/>
</launch>
```

```xml camera.launch.xml
<launch>
  <push_ros_namespace namespace="camera"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker"/>
</launch>
```

## Use instead

```xml main.launch.xml
<launch>
  <include file="$(dirname)/camera.launch.xml"/>
  <node pkg="demo_nodes_cpp" exec="listener" name="listener"/>
</launch>
```

```xml camera.launch.xml
<launch>
  <group>
    <push_ros_namespace namespace="camera"/>
    <node pkg="demo_nodes_cpp" exec="talker" name="talker"/>
  </group>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.problems import NamespaceLeft
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.wording import words_at

RULE = Rule("LL918", "namespace-leaks-from-include", Severity.WARNING)


def tell(problem: NamespaceLeft, view: object) -> Iterator[Finding]:
    """Say who gets it (launch_ros.actions.PushROSNamespace sets a launch configuration like any other)."""
    if not problem.namespace.strip("/"):
        return  # an empty one, which an arg may fill
    group = words_at(problem.origin).tag("group")
    yield RULE.at(
        problem.origin,
        f"the namespace {problem.namespace} outlives this file: what is started behind the include gets it, too",
        label="not put back at the end of the file",
        related=problem.related,
        notes=(f"only the end of a {group} takes a pushed namespace away, and not the end of a file",),
        help=f"put a {group} around it and all that it is meant for, or around the include",
        cause=problem.place.source.path,
    )

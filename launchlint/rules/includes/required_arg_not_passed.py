"""An `<include>` does not pass an arg that the included file needs, though the arg has a value already.

What it does: it looks for args that the included file, or one that it includes, declares without a default and outside of any condition,
that are not among what the include passes, and that have a value at this point: from a `<let>`, an `<arg>`, or another include.
(Where they have none, that is LL404.)

## Why it matters

Launch configurations are seen in included files, so that the value would be there when the file reads it. But before `ros2 launch`
executes an include it looks at what is *passed*, not at what is set, and stops.

## Example

```xml
<launch>
  <let name="robot_name" value="r2"/>
  <include file="$(dirname)/arm.launch.xml"/>
</launch>
```

```xml arm.launch.xml
<launch>
  <arg name="robot_name"/>
  <push_ros_namespace namespace="$(var robot_name)"/>
</launch>
```

## Use instead

```xml
<launch>
  <let name="robot_name" value="r2"/>
  <include file="$(dirname)/arm.launch.xml">
    <arg name="robot_name" value="$(var robot_name)"/>
  </include>
</launch>
```

```xml arm.launch.xml
<launch>
  <arg name="robot_name"/>
  <push_ros_namespace namespace="$(var robot_name)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.problems import RequiredArgNotPassed
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.broken_call import broken_call
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import words_at

RULE = Rule("LL912", "required-arg-not-passed", Severity.ERROR, roslaunch="refuses")


def tell(problem: RequiredArgNotPassed, view: LaunchView) -> Iterator[Finding]:
    """Tell all of one include together (launch.actions.IncludeLaunchDescription.execute)."""
    together = view.beside(problem)
    names = list(dict.fromkeys(each.name for each in together)) or [problem.name]
    if problem.name != names[0]:
        return  # told with the first
    listed = ", ".join(names)
    several = len(names) > 1
    passes = "; ".join(map(words_at(problem.origin).passed_on, names))
    yield RULE.at(
        problem.origin,
        f"{problem.file} needs {listed}, which {'are' if several else 'is'} set here, and not passed",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label=f"included without {'them' if several else 'it'}",
        related=tuple(dict.fromkeys(each for one in together for each in one.related)) or problem.related,
        notes=(
            "ros2 launch looks at what an include passes before it looks at what is set",
            f"it stops with: Included launch description missing required argument '{names[0]}'",
        ),
        help=f"pass {'them' if several else 'it'} on: {passes}",
        topic=listed,
        shared_cause=broken_call(problem.file, listed),
    )

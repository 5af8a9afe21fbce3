"""`launch` has this, and its XML and YAML front ends cannot make it.

`$(any …)` and `$(all …)` are registered for launch files in XML and YAML, and fail whenever they stand there. `respawn_delay` and the
timeouts compare what is written with zero, so that a substitution in them is a `TypeError`. The modules of `$(eval … …)` must be text.
`<set_use_sim_time>` passes a list where rclpy wants true or false, and fails when it is executed.

## Why it matters

ros2 launch refuses the file with a Python error that does not speak of launch files.

## Example

```xml robot.launch.xml
<launch>
  <arg name="delay" default="2.0"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker" respawn="true" respawn_delay="$(var delay)"/>
</launch>
```

## Use instead

```xml robot.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker" respawn="true" respawn_delay="2.0"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.problems import NeverWorks
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.problems import BrokenInFrontend

RULE = Rule("LL935", "broken-in-frontend", Severity.ERROR, roslaunch="refuses")


def tell(problem: BrokenInFrontend | NeverWorks, view: object) -> Iterator[Finding]:
    """Say what does the same."""
    if isinstance(problem, NeverWorks):
        yield RULE.at(
            problem.origin,
            f"{problem.tag} fails whenever it is executed in XML and YAML",
            severity=Severity.ERROR if problem.refused else Severity.WARNING,
            notes=("ros2 launch stops with: Type 'Type.BOOL' and value do not agree",),
            help='write <set_parameter name="use_sim_time" value="true"/>',
        )
        return
    name = problem.name
    if problem.what == "any-all":
        word = "or" if name == "any" else "and"
        message, advice = (
            f"$({name} …) fails in XML and YAML, whatever stands in it",
            f"write $({word} … …), in each other for more than two",
        )
        note = f"ros2 launch stops with a TypeError about the keyword argument args of {name.capitalize()}Substitution"
    elif problem.what == "modules":
        message, advice = "the modules of $(eval …) cannot be computed", "write their names as they are, with commas between them"
        note = "launch looks for them when it reads the file, before anything has a value"
    elif problem.what == "flag":
        message, advice = f"{name} takes no substitution in XML and YAML", "write true or false"
        note = "ros2 launch stops with a TypeError: it wants the truth value itself when it reads the file"
    else:
        message, advice = f"{name} takes no substitution in XML and YAML", "write a number"
        note = "ros2 launch stops with a TypeError: it compares the text with 0.0 when it reads the file"
    yield RULE.at(problem.origin, message, notes=(note,), help=advice)

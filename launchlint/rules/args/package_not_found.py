"""A `$(find …)` names a package that does not exist.

A checkout does not hold what is installed on the robot, so that a package which is merely not here is nothing to tell
of. It is an error where the name is one slip away from a package that does exist (here, in a `package.xml`, or in the
public ROS index), or where everything is here: a ROS installation is set up on this machine, or the configuration
says `packages: complete`. It is a warning where nobody has ever heard of the name. Each package is told of once in a file.

## Why it matters

roslaunch refuses the file.

## Example

```xml
<launch>
  <include file="$(find turtlebot3_bringpu)/launch/turtlebot3_robot.launch"/>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(find turtlebot3_bringup)/launch/turtlebot3_robot.launch"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.first_of_file import all_but_first
from launchlint.rules.missing_package import judge
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL210", "package-not-found", Severity.ERROR, roslaunch="refuses")


def check(view: LaunchView) -> Iterator[Fine]:
    """Tell of each package once in a file."""
    return all_but_first(RULE, view.launch, "package-not-found", "package")


def tell(problem: Problem, view: LaunchView) -> Iterator[Finding]:
    """Judge the name; facts: ``package``, ``near`` (the entry file)."""
    name = problem.facts["package"]
    judgement = judge(name, view.packages, problem.place.source.file)
    if judgement is None:
        return
    severity = judgement.severity if problem.refused else min(judgement.severity, Severity.WARNING)
    unsure = judgement.severity is not Severity.ERROR
    yield RULE.at(
        problem.origin,
        f"the package {name} is not known" if unsure else f"there is no package {name}",
        severity=severity,
        notes=(f"roslaunch stops{' where it is missing' if unsure else ''} with: Resource not found: {name}", judgement.why),
        help=judgement.help,
        topic=name,
    )

"""A `$(find …)` names a package that does not exist.

A checkout does not hold what is installed on the robot, so that a package which is merely not here is nothing to tell of; nor is
one that has the name of a repository in a `.gitmodules`, `*.rosinstall` or `*.repos` of the workspace. It is an error where the
name is one slip away from a package that is here (and has one of the files asked for) or that a `package.xml` here declares, or where
everything is here: a ROS
installation is set up on this machine, or the configuration says `packages: complete`. It is a warning where the name is
much like that of a package that is here, declared or public (no list holds all packages, so that a near name in one is help and not proof),
or is one that is here with a number or its end twice (`arm_2` beside `arm`); else an info, since it may well lie in another repository of
the same people.
So it is where a document names it, or a script, a workflow or an image fetches something of that name.
Each package is told of once, with all files that need it.

## Why it matters

roslaunch refuses the file.

## Example

```xml
<launch>
  <param name="maps" value="$(find my_robto)"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
</package>
```

## Use instead

```xml
<launch>
  <param name="maps" value="$(find my_robot)"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
</package>
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import PackageNotFound
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.first_of_file import all_but_first
from launchlint.rules.judging.missing_package import cause, judge, told_of_all
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView, of_ros2

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.problems import InvalidPackageName

RULE = Rule("LL210", "package-not-found", Severity.ERROR, roslaunch="refuses")


def check(view: LaunchView) -> Iterator[Fine]:
    """Tell of each package once in a file."""
    return all_but_first(RULE, ((each, each.package) for each in view.launch.noticed(PackageNotFound)))


def tell(problem: PackageNotFound | InvalidPackageName, view: LaunchView) -> Iterator[Finding]:
    """Judge the name."""
    if of_ros2(view):
        from launchlint.rules.judging import ros2_names as ros2_words

        yield from ros2_words.package(problem, RULE, view)
        return
    assert isinstance(problem, PackageNotFound)
    name = problem.package
    judgement = judge(name, view.packages, problem.place.source.file, problem.place.source.text)
    if judgement is None:
        return
    severity = judgement.severity if problem.refused else min(judgement.severity, Severity.WARNING)
    unsure = judgement.severity is not Severity.ERROR
    yield RULE.at(
        problem.origin,
        f"the package {name} is not known" if unsure else f"there is no package {name}",
        severity=severity,
        label="not found",
        notes=(f"roslaunch stops{' where it is missing' if unsure else ''} with: Resource not found: {name}", judgement.why),
        help=judgement.help,
        topic=name,
        shared_cause=cause(name, severity, judgement),
        about=(name,),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """One for all packages that are missing for one reason."""
    return told_of_all(findings)

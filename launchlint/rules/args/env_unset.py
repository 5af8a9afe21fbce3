"""A `$(env …)` reads an environment variable that is not set here.

Variables that every login or ROS installation sets are not told of, nor those that an env-hook of a package in the workspace sets
(`catkin_add_env_hooks`, `env-hooks/*.sh`). Others may be set on the robot and not where this
check runs; `env:` in `.launchlint.yaml` gives them a value for the check. Each variable is told of once. It is an info where the
workspace itself sets or reads the variable elsewhere (a shell file, a Dockerfile, a service, `os.environ` or `getenv`), and where three or
more launch files read it: it is the project's own.

## Why it matters

Where the variable is not set roslaunch refuses the file. `$(optenv NAME default)` works everywhere.

## Example

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server" args="$(env SITE_MAP)"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server" args="$(optenv SITE_MAP /maps/office.yaml)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.first_of_file import all_but_first
from launchlint.rules.joined import joined
from launchlint.rules.other_file import root_of, shown
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView
from launchlint.spelling import one_slip

RULE = Rule("LL209", "env-unset", Severity.WARNING, roslaunch="refuses")
CONVENTION = 3
"""Launch files of a workspace that read a variable, from which it is no oversight."""
USUAL = (
    *("HOME", "LANG", "LOGNAME", "PATH", "PWD", "SHELL", "USER"),
    *("ROS_DISTRO", "ROS_ETC_DIR", "ROS_MASTER_URI", "ROS_PACKAGE_PATH", "ROS_PYTHON_VERSION", "ROS_ROOT", "ROS_VERSION"),
    *("CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH", "PKG_CONFIG_PATH", "PYTHONPATH"),
)
"""Set by every login shell, or by the set-up file of every ROS installation."""
OPTIONAL = ("ROS_HOME", "ROS_HOSTNAME", "ROS_IP", "ROS_LOG_DIR", "ROS_NAMESPACE")


def check(view: LaunchView) -> Iterator[Fine]:
    """Tell of each variable once in a file."""
    return all_but_first(RULE, view.launch, "env-unset", "variable")


def tell(problem: Problem, view: LaunchView) -> Iterator[Finding]:
    """Suggest a default; facts: ``variable``."""
    name = problem.facts["variable"]
    if name in USUAL or name in view.packages.hook_variables():
        return
    slip = one_slip(name, (*USUAL, *OPTIONAL))
    own = view.packages.own_variables().get(name)
    notes = [f"where it is not set roslaunch stops with: environment variable '{name}' is not set"]
    if own is not None:
        notes.append(f"{shown(own, root_of(problem.place.source))} sets or reads it, too")
    given = f"write $(optenv {name} DEFAULT), or give it a value under env: in .launchlint.yaml if it is always set"
    yield RULE.at(
        problem.origin,
        f"the environment variable {name} is not set here",
        severity=None if own is None or slip is not None else Severity.INFO,
        notes=tuple(notes),
        help=given if slip is None else f"did you mean {slip}?",
        topic=name,
        cause=f"{name} {own is None}",
    )


def together(findings: Sequence[Finding]) -> Finding:
    """A variable that many launch files read without a default is a convention of the project: an info."""
    whole = joined(findings)
    files = {finding.location.path for finding in findings}
    if len(files) < CONVENTION or whole.severity is not RULE.severity or whole.help.startswith("did you mean"):
        return whole
    return whole._replace(severity=Severity.INFO, notes=(*whole.notes, f"{len(files)} launch files read it: it is a convention here"))

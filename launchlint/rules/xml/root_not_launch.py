"""A launch file has exactly one `<launch>` element, and this one has none or several.

roslaunch looks for the `<launch>` element anywhere in the file and works on that. It refuses a file without one, a
file whose root is misspelt (`<Launch>`), and a file in which a second `<launch>` stands inside the first.

A file of another program (an Eclipse `<launchConfiguration>`, a `<concert>` with a `<launch>` inside) is no launch file:
it is left out where a directory is searched. Where it is named, or included, it is told what it is.

In ROS 2, `<launch>` has to be the root itself; a launch file in YAML has one key, `launch`, with a list of actions.

## Why it matters

Nothing of the file is started.

## Example

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server"/>
  <launch>
    <node pkg="amcl" type="amcl" name="amcl"/>
  </launch>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server"/>
  <group>
    <node pkg="amcl" type="amcl" name="amcl"/>
  </group>
</launch>
```
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.spelling import closest
from launchlint.syntax.problems import RootNotLaunch
from launchlint.syntax.ros2.problems import WrongRoot

RULE = Rule("LL102", "root-not-launch", Severity.ERROR, roslaunch="refuses")
STOPS = "roslaunch stops with: Invalid roslaunch XML syntax: no root <launch> tag"


def tell(problem: RootNotLaunch | WrongRoot, view: object) -> Iterator[Finding]:
    """Say what stands there instead."""
    if isinstance(problem, WrongRoot):
        yield _ros2(problem)
        return
    tag, count = problem.tag, problem.count
    if count and tag != "launch":
        alone = count == 1
        yield RULE.at(
            problem.origin,
            f"the root element is <{tag}>, with {'a' if alone else count} <launch> inside: this is a file of another program",
            severity=Severity.INFO if alone else Severity.ERROR,
            related=problem.related,
            notes=("roslaunch takes the <launch> inside it, and nothing else of the file" if alone else STOPS,),
            help="if this is a launch file, make <launch> its root; if not, exclude it",
        )
        return
    if count > 1:
        yield RULE.at(
            problem.origin,
            "a <launch> stands inside another <launch>",
            label="the second one",
            related=problem.related,
            notes=(STOPS,),
            help="use <group> for a part of the file, or <include> for a file of its own",
        )
        return
    near = closest(tag, ("launch",)) is not None
    yield RULE.at(
        problem.origin,
        f"the root element is <{tag}>, not <launch>",
        cause=f"{posixpath.dirname(problem.place.source.path)} {tag}",
        notes=(STOPS,),
        help="did you mean <launch>?" if near else "if this is a launch file, put everything into one <launch> element; if not, exclude it",
    )


def _ros2(problem: WrongRoot) -> Finding:
    tag = problem.tag
    if not tag:
        message = "a launch file in YAML has the one key launch, and this one has " + (
            "none" if not problem.keys else f"{problem.keys} keys"
        )
        advice = "write launch: and below it the list of actions"
        return RULE.at(problem.origin, message, notes=("ros2 launch refuses the file",), help=advice)
    return RULE.at(
        problem.origin,
        f"the root is {tag}, not launch",
        notes=("ros2 launch stops with: Expected 'launch' as root tag",),
        help="did you mean launch?"
        if closest(tag, ("launch",)) is not None
        else "if this is a launch file, put everything into one launch",
    )

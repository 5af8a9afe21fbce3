"""A class of launch is made with a keyword that its constructor does not take, or does not take any more.

`node_executable`, `node_name`, `node_namespace` and `node_plugin` are those of Foxy and before; since Galactic they are `executable`,
`name`, `namespace` and `plugin`. Where the repository's own files (README, images, workflows) name no other distribution than these old
ones, it is an information, and a warning where they name both. Where such a keyword stands in the place of the only argument that must be
given, as `plugin` of a `Node` without `executable`, that is told here, and not by LL928 as well.

## Why it matters

ros2 launch stops with a `TypeError` and does not load the file.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo_nodes_cpp', node_executable='talker', node_name='talker'),
    ])
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo_nodes_cpp', executable='talker', name='talker'),
    ])
```

## Fix

`--fix` writes the keyword of today where there is one; `--unsafe-fixes` also the one that is most likely meant. ros2 launch does not
stop there then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS2, fix
from launchlint.rules.judging.python_text import level, stops, write
from launchlint.rules.rule import Rule
from launchlint.spelling import closest
from launchlint.syntax.ros2.python.problems import UnknownKeyword

RULE = Rule("LL924", "removed-keyword", Severity.ERROR, roslaunch="refuses", fixable="safe")


def tell(problem: UnknownKeyword, view: object) -> Iterator[Finding]:
    """Name the keyword of today."""
    callee, keyword, new = problem.callee, problem.keyword, problem.replacement
    near = new or closest(keyword, problem.known)
    if problem.since:
        message = f"{callee} does not take {keyword} any more: since {problem.since.capitalize()} it is {new or 'called otherwise'}"
    else:
        message = f"{callee} does not take {keyword}"
    if problem.missing:
        notes = stops(f"a TypeError: missing required argument '{problem.missing}'")
        advice = f"did you mean {near}?" if near == problem.missing else f"write {problem.missing}=…, which it must be given"
    else:
        notes = stops(f"a TypeError: got an unexpected keyword argument '{keyword}'")
        advice = f"write {new}" if new else f"did you mean {near}?" if near else "take it out"
    severity = level(problem)
    if problem.still:
        still = " and ".join(each.capitalize() for each in problem.still)
        named = f"{still}, which the files of this repository name, {'takes' if len(problem.still) == 1 else 'take'} it"
        notes = (named, *(f"in later ones {note}" for note in notes))
        severity = min(severity, Severity.WARNING if problem.refused else Severity.INFO)
    yield RULE.at(
        problem.origin,
        message,
        severity=severity,
        label=f"{new} today" if problem.since and new else "no such keyword",
        notes=notes,
        help=advice,
        fix=_fix(problem, near) if problem.missing in ("", near) else None,
        topic=keyword,
        cause=f"since {problem.since} {problem.still}" if problem.since else f"{problem.place.source.path} {callee} {keyword}",
    )


def _fix(problem: UnknownKeyword, near: str | None) -> Fix | None:
    if not near or problem.place.text != problem.keyword:
        return None
    safe = bool(problem.replacement) and not problem.still
    return fix(f"write {near}", write(problem.place, near), safe=safe, changes="" if problem.still else LOADS2)

"""A name is imported from a module of launch that does not have it: another one does.

`FindPackageShare` is in `launch_ros.substitutions`, `Node` in `launch_ros.actions`, `LaunchConfiguration` in `launch.substitutions`.

## Why it matters

ros2 launch stops with an `ImportError` and does not load the file.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import FindPackageShare, PathJoinSubstitution


def generate_launch_description():
    demo = FindPackageShare('demo_nodes_cpp')
    return LaunchDescription([IncludeLaunchDescription(PathJoinSubstitution([demo, 'launch', 'topics', 'talker_listener.launch.py']))])
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    demo = FindPackageShare('demo_nodes_cpp')
    return LaunchDescription([IncludeLaunchDescription(PathJoinSubstitution([demo, 'launch', 'topics', 'talker_listener.launch.py']))])
```

## Fix

`--fix` imports the name from the module that has it. ros2 launch does not stop there then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Edit, Finding, Fix, Severity
from launchlint.late import late
from launchlint.rules.edits import LOADS2, Edits, fix
from launchlint.rules.judging.python_text import level, stops, write
from launchlint.rules.rule import Rule
from launchlint.source import Place, Span
from launchlint.syntax.ros2.python.problems import WrongModule

RULE = Rule("LL925", "wrong-module", Severity.ERROR, roslaunch="refuses", fixable="safe")
_COMMA_BEHIND = late(r"[ \t]*,[ \t]*(?:#[^\n]*)?(?:\r?\n[ \t]*)?")
_COMMA_BEFORE = late(r",\s*\Z")


def tell(problem: WrongModule, view: object) -> Iterator[Finding]:
    """Name the module that has it."""
    yield RULE.at(
        problem.origin,
        f"{problem.module} has no {problem.name}: {problem.right} has it",
        severity=level(problem),
        label=f"not in {problem.module}",
        notes=stops(f"an ImportError: cannot import name '{problem.name}' from '{problem.module}'"),
        help=f"write from {problem.right} import {problem.name}",
        fix=_fix(problem),
    )


def _fix(problem: WrongModule) -> Fix | None:
    message = f"import {problem.name} from {problem.right}"
    return fix(message, _edits(problem), safe=True, changes=LOADS2)


def _edits(problem: WrongModule) -> Edits:
    (statement, _), *_ = problem.related
    source, (start, end) = problem.place
    if problem.alone:
        at = source.text.find(problem.module, statement.span.start, start)
        return write(Place(source, Span(at, at + len(problem.module))), problem.right) if at >= 0 else ()
    line = source.position(statement.span.start)
    if source.line(line.line)[: line.column - 1].strip():
        return ()
    indented = source.line(line.line)[: line.column - 1]
    behind = _COMMA_BEHIND.match(source.text, end, statement.span.end)
    before = _COMMA_BEFORE.search(source.text[statement.span.start : start])
    if behind is not None:
        cut = Span(start, behind.end())
    elif before is not None:
        cut = Span(statement.span.start + before.start(), end)
    else:
        return ()
    newline = "\r\n" if "\r\n" in source.text else "\n"
    added = f"{newline}{indented}from {problem.right} import {problem.place.text}"
    return (Edit(source.path, *cut, ""), Edit(source.path, statement.span.end, statement.span.end, added))

"""A class of launch is made without an argument that its constructor must be given, or with one given without its name.

`ComposableNodeContainer` and `LifecycleNode` need `name` and `namespace` (which may be `''`). `LogInfo`, `Node`, `ExecuteProcess` and
others take their arguments by name only: `LogInfo(msg='…')`. `PathJoinSubstitution` takes one list.

## Why it matters

ros2 launch stops with a `TypeError` and does not load the file.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.actions import LogInfo


def generate_launch_description():
    return LaunchDescription([LogInfo('hello')])
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.actions import LogInfo


def generate_launch_description():
    return LaunchDescription([LogInfo(msg='hello')])
```

## Fix

`--fix` writes the name before a value where only one can be meant, and the brackets of a list. ros2 launch does not stop there then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.plural import counted
from launchlint.rules.edits import LOADS2, fix
from launchlint.rules.judging.python_text import before, behind, level, stops
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.python.problems import MissingArgument, TooManyPositional

RULE = Rule("LL928", "missing-constructor-argument", Severity.ERROR, roslaunch="refuses", fixable="safe")


def tell(problem: MissingArgument | TooManyPositional, view: object) -> Iterator[Finding]:
    """Name the argument."""
    callee = problem.callee
    if isinstance(problem, MissingArgument):
        name = problem.argument
        empty = name == "namespace"
        yield RULE.at(
            problem.origin,
            f"{callee} is made without {name}, which it must be given",
            severity=level(problem),
            label=f"no {name}",
            notes=stops(f"a TypeError: missing required argument '{name}'"),
            help="write namespace='' where it has none" if empty else f"write {name}=…",
            topic=name,
        )
        return
    names = ", ".join(f"{name}=" for name in problem.names)
    most = f"{counted(problem.most, 'value')} without a name" if problem.most else "values by name only"
    yield RULE.at(
        problem.origin,
        f"{callee} takes {most}, and is given {problem.count}",
        severity=level(problem),
        notes=stops("a TypeError: it takes fewer positional arguments"),
        help="put all of them in one list: […]" if problem.listed else f"write {names}" if names else "take it out",
        fix=_fix(problem),
    )


def _fix(problem: TooManyPositional) -> Fix | None:
    extra = problem.extra
    if len(set(extra)) < len(extra):
        return None
    if problem.listed and problem.related:
        (first, _), *_ = problem.related
        return fix("put them in a list", (*before(first, "["), *behind(extra[-1], "]")), safe=True, changes=LOADS2)
    if len(problem.names) == len(extra) == 1:
        return fix(f"write {problem.names[0]}=", before(extra[0], f"{problem.names[0]}="), safe=True, changes=LOADS2)
    return None

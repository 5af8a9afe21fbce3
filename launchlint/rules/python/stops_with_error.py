"""The launch file is a program that ends with an exception, whenever somebody starts it: it raises one, or looks for what is not there.

`launchlint` follows the program without running it, and tells this only where every way through it ends so. A program that refuses some
values of its arguments does so on purpose: it is told only of what happens without arguments. It is an info where a function asked for a
launch configuration before that is empty, or that nobody sets here: such a file wants an arg, or is made to be included. So it is where the
program itself raises the exception after it has looked for a package that is not here, or asked for an environment variable that is not
set: these may be there where it is started; and where it looks through `sys.argv` for an argument that a variable is set by. It is told,
too, of a `PopLaunchConfigurations` or `PopEnvironment` before which nothing was pushed: launch raises an exception there.

## Why it matters

ros2 launch stops before anything is started.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node

ROBOTS = {'small': 'talker', 'large': 'listener'}


def generate_launch_description():
    return LaunchDescription([Node(package='demo_nodes_cpp', executable=ROBOTS['medium'])])
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node

ROBOTS = {'small': 'talker', 'large': 'listener'}


def generate_launch_description():
    return LaunchDescription([Node(package='demo_nodes_cpp', executable=ROBOTS['large'])])
```
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from launchlint.evaluate.ros2.problems import NothingToPop
from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.rules.judging.made_file import made
from launchlint.rules.judging.other_file import root_of
from launchlint.rules.judging.python_text import level, shown
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.syntax.ros2.python.problems import StopsWithError

RULE = Rule("LL949", "stops-with-error", Severity.ERROR, roslaunch="refuses")
_PUSHES = {"configurations": "PushLaunchConfigurations", "environment": "PushEnvironment"}
_LACKING = frozenset(("FileNotFoundError", "IsADirectoryError", "NotADirectoryError"))
_NOT_SET = frozenset(("UnboundLocalError", "IndexError"))
"""What comes of an argument that nobody has given, where a file looks for it itself."""
_ABSENT = late(r"'(/[^']+)'$")
_LACKING_STATED = "ParameterBuilderFileNotFoundError"
"""What a build may mend that puts files where there are none in the sources: as Python says it, and as launch_param_builder does."""


def tell(problem: StopsWithError | NothingToPop, view: LaunchView) -> Iterator[Finding]:
    """Say which exception it is. A build may make a file that is not here, a file that includes this one may set a configuration."""
    if isinstance(problem, NothingToPop):
        yield _nothing_to_pop(problem)
        return
    if problem.called and view.launch.given:
        return
    root = root_of(problem.place.source)
    said = problem.what.replace(f"{root}/", "") if root else problem.what
    what = f"{problem.error}: {shown(said)}" if said else problem.error
    who = f"this {problem.action}" if problem.action else "a function of this launch file" if problem.called else "this launch file"
    lacks = problem.error == _LACKING_STATED if problem.stated else problem.error in _LACKING
    severity = Severity.WARNING if lacks else level(problem)
    notes: tuple[str, ...] = ("ros2 launch stops there" if problem.called else "ros2 launch stops before anything is started",)
    if problem.package:
        severity = Severity.INFO
        notes = (f"it looks for the package {problem.package} before that, which is not here",)
    elif problem.variable and not problem.lacking:
        severity = Severity.INFO
        notes = (f"it asks for the environment variable {problem.variable} before that, which is not set here",)
    elif problem.lacking:
        severity = Severity.INFO
        notes = (f"so it is where nobody gives {problem.lacking} a value, on the command line or in a file that includes this one",)
    elif not problem.stated and problem.error in _NOT_SET and "sys.argv" in problem.place.source.text:
        severity = Severity.INFO
        notes = ("it looks through sys.argv, and this is so where it finds nothing there: somebody gives it name:=value",)
    absent = _ABSENT.search(problem.what) if problem.error == "FileNotFoundError" else None
    maker = None if absent is None else made(absent[1], view, root)
    if maker is not None:
        severity = Severity.INFO
        notes = (*notes, maker.why)
    yield RULE.at(
        problem.origin,
        f"{who} ends with an exception: {what}",
        severity=severity,
        label="raised here" if problem.stated and not problem.related else "here",
        related=problem.related,
        notes=notes,
        help="" if maker is None else maker.help,
        cause=f"{posixpath.dirname(problem.place.source.path)} {what}",
    )


def _nothing_to_pop(problem: NothingToPop) -> Finding:
    pushed = _PUSHES.get(problem.what, "")
    what = f"{pushed.replace('Push', 'Pop')} has nothing to pop" if pushed else "this group has nothing to put back at its end"
    return RULE.at(
        problem.origin,
        what,
        severity=level(problem),
        label="here",
        notes=("ros2 launch stops there with a RuntimeError: the stack is empty",),
        help=f"add {pushed}() before what it is to put back"
        if pushed
        else "take out the PopLaunchConfigurations or PopEnvironment inside it that has no push",
        cause=f"{problem.place.source.path} {problem.place.span.start} nothing to pop",
    )

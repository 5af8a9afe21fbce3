"""`launch_arguments` of an include is a dict itself, or something else that is not made of pairs of a name and a value.

A dict gives only its names when launch goes through it, and launch takes the first letter of a name for the name and the second for the
value: `.items()` gives the pairs.

## Why it matters

ros2 launch stops with `ValueError: not enough values to unpack` or `too many values to unpack`. Where all names have two letters, it sets
args that nobody knows, and says nothing.

## Example

```python launch/robot.launch.py
import os

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource


def generate_launch_description():
    here = os.path.dirname(__file__)
    return LaunchDescription([
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(os.path.join(here, 'arm.launch.py')),
            launch_arguments={'name': 'left'},
        ),
    ])
```

```python launch/arm.launch.py
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('name', default_value='arm'), LogInfo(msg=LaunchConfiguration('name'))])
```

## Use instead

```python launch/robot.launch.py
import os

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource


def generate_launch_description():
    here = os.path.dirname(__file__)
    return LaunchDescription([
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(os.path.join(here, 'arm.launch.py')),
            launch_arguments={'name': 'left'}.items(),
        ),
    ])
```

```python launch/arm.launch.py
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('name', default_value='arm'), LogInfo(msg=LaunchConfiguration('name'))])
```

## Fix

`--fix` writes `.items()` behind a dict. ros2 launch passes the args then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.edits import fix
from launchlint.rules.judging.python_text import behind, is_one_operand, level, stops
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.python.problems import LaunchArgumentsNotPairs

RULE = Rule("LL926", "launch-arguments-not-pairs", Severity.ERROR, roslaunch="refuses", fixable="safe")
_PASSES = "ros2 launch passes these args"


def tell(problem: LaunchArgumentsNotPairs, view: object) -> Iterator[Finding]:
    """Say what launch makes of it."""
    wrong = problem.is_dict
    yield RULE.at(
        problem.origin,
        f"launch_arguments takes pairs of a name and a value, and {'is a dict' if wrong else f'this is {problem.found}'}",
        severity=level(problem),
        label="write .items() behind it" if wrong else "no pair",
        notes=stops("a ValueError when it includes the file") if problem.refused else ("launch takes the letters of the names apart",),
        help="write .items() behind it" if wrong else "write {'name': 'value'}.items()",
        fix=fix("write .items()", behind(problem.place, ".items()"), safe=True, changes=_PASSES)
        if wrong and is_one_operand(problem.place)
        else None,
    )

"""An include loads a launch file in XML or YAML with `PythonLaunchDescriptionSource`.

That class executes the file as a program of Python, whatever its name is. `AnyLaunchDescriptionSource` loads all kinds of launch files, and
`IncludeLaunchDescription` takes the path alone, too (since Humble).

## Why it matters

ros2 launch stops with a `SyntaxError` in the included file.

## Example

```python launch/robot.launch.py
import os

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource


def generate_launch_description():
    here = os.path.dirname(__file__)
    return LaunchDescription([IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(here, 'arm.launch.xml')))])
```

```xml launch/arm.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker"/>
</launch>
```

## Use instead

```python launch/robot.launch.py
import os

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import AnyLaunchDescriptionSource


def generate_launch_description():
    here = os.path.dirname(__file__)
    return LaunchDescription([IncludeLaunchDescription(AnyLaunchDescriptionSource(os.path.join(here, 'arm.launch.xml')))])
```

```xml launch/arm.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.python_text import level, stops
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.python.problems import WrongSourceClass

RULE = Rule("LL931", "wrong-source-class", Severity.ERROR, roslaunch="refuses")


def tell(problem: WrongSourceClass, view: object) -> Iterator[Finding]:
    """Name the classes that are for such a file."""
    yield RULE.at(
        problem.origin,
        f"{problem.callee} executes {problem.file} as a program of Python",
        severity=level(problem),
        label="for launch files in Python only",
        notes=stops("a SyntaxError in the included file"),
        help=f"use AnyLaunchDescriptionSource, or {problem.right}",
    )

"""One action that starts a process stands in two places of the description, or one source in two includes.

launch starts a process once for each object: a `Node` that is kept in a variable and added twice is still one object. A source, such as
`PythonLaunchDescriptionSource(…)`, reads its file once, so that two includes with the same one have the same nodes.

## Why it matters

ros2 launch stops at the second time: `executed more than once`.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    talker = Node(package='demo_nodes_cpp', executable='talker')
    return LaunchDescription([talker, talker])
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def talker(name):
    return Node(package='demo_nodes_cpp', executable='talker', name=name)


def generate_launch_description():
    return LaunchDescription([talker('first'), talker('second')])
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.python_text import level, stops
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.python.problems import ExecutedTwice

RULE = Rule("LL929", "executed-twice", Severity.ERROR, roslaunch="refuses")
_IS = {"node_container": "container", "lifecycle_node": "lifecycle node", "executable": "process"}


def tell(problem: ExecutedTwice, view: object) -> Iterator[Finding]:
    """Say what is started twice; a file that is included twice by one source is told where its node is made."""
    included = problem.origin.step is not None
    yield RULE.at(
        problem.origin,
        f"this {_IS.get(problem.callee, problem.callee)} is one object, and is to be started a second time",
        severity=level(problem),
        notes=stops("a RuntimeError: executed more than once"),
        help="make a source of its own for each include of this file" if included else "make an object of its own for each place",
        cause=problem.place.source.path,
    )

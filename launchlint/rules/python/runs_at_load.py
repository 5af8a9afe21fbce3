"""A launch file in Python starts a process, asks a question, writes, deletes or connects as soon as somebody loads it.

`ros2 launch --show-args`, `--print`, completion and every include load the file: whatever stands at its top or in
`generate_launch_description()` is executed then, before anything is launched, and whether or not it is needed. launchlint reads launch
files and executes nothing of them. What an `OpaqueFunction` does is executed with the launch, and is not told here.

## Why it matters

To list the arguments changes the machine. A question, as of `input()`, blocks whoever loads the file without a terminal: tests, services,
other launch files. What a process answers at load can differ from machine to machine, and is the same for all nodes.

## Example

```python launch/robot.launch.py
import subprocess

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    model = subprocess.check_output(['hostname']).decode()
    return LaunchDescription([Node(package='demo_nodes_cpp', executable='talker', arguments=['--model', model])])
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node


def generate_launch_description():
    model = Command(['hostname'])
    return LaunchDescription([Node(package='demo_nodes_cpp', executable='talker', arguments=['--model', model])])
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.python.problems import RunsAtLoad

RULE = Rule("LL930", "runs-at-load", Severity.INFO)
_DOES = {
    "process": "starts a process",
    "question": "waits for an answer",
    "write": "writes to the disk",
    "delete": "deletes files",
    "connection": "opens a connection",
}
_ADVICE = {
    "process": "use the substitution Command([…]), or an OpaqueFunction",
    "question": "declare a launch argument for it",
    "write": "do it in an OpaqueFunction, or in a node",
    "delete": "do it in an OpaqueFunction, or in a node",
    "connection": "do it in an OpaqueFunction, or in a node",
}


def tell(problem: RunsAtLoad, view: object) -> Iterator[Finding]:
    """Say what it does; all of one file that do the same are told together."""
    yield RULE.at(
        problem.origin,
        f"{problem.what.removeprefix('.')}() {_DOES[problem.effect]} whenever this launch file is loaded",
        label="executed at load",
        notes=("ros2 launch --show-args and every include load the file, too",),
        help=_ADVICE[problem.effect],
        cause=f"{problem.place.source.path} {problem.effect}",
    )

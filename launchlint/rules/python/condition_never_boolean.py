"""A condition can never come to true or false: it is no condition, or an expression of Python over `true` and `false`.

`condition=` takes an `IfCondition` or another condition, neither a boolean nor a substitution. `PythonExpression` is computed by Python,
for which `true` and `false`, as launch files spell them, are names that it does not know: put quotes around the value, and compare it.

## Why it matters

ros2 launch stops as soon as it comes to the action, mostly with an error that does not say which one.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('talk', default_value='true'),
        Node(package='demo_nodes_cpp', executable='talker', condition=LaunchConfiguration('talk')),
    ])
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('talk', default_value='true'),
        Node(package='demo_nodes_cpp', executable='talker', condition=IfCondition(LaunchConfiguration('talk'))),
    ])
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import EvalError
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.python_text import level, shown, stops
from launchlint.rules.judging.ros2_args import takes_text_for_name
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.python.problems import NotACondition

RULE = Rule("LL923", "condition-never-boolean", Severity.ERROR, roslaunch="refuses")
_COMPARE = (
    "put quotes around the value and compare it, True like true: PythonExpression([\"'\", LaunchConfiguration(…), \"'.lower() == 'true'\"])"
)


def tell(problem: NotACondition | EvalError, view: object) -> Iterator[Finding]:
    """Say what stands there, and what is wanted."""
    if isinstance(problem, EvalError):
        if takes_text_for_name(problem):
            yield _name(problem)
        return
    written = problem.place.text if len(problem.place.text) <= 40 else "…"
    yield RULE.at(
        problem.origin,
        f"condition of {problem.callee} is {problem.found}, which is no condition",
        severity=level(problem),
        label="no condition",
        notes=stops("an AttributeError when it comes to this action: it has no attribute 'evaluate'"),
        cause=f"{problem.place.source.path} {problem.callee} {problem.found}",
        help=f"write IfCondition({written})" if problem.substitution else "use a plain if of Python, or IfCondition over a substitution",
    )


def _name(problem: EvalError) -> Finding:
    word = "true" if "'true'" in problem.reason else "false"
    return RULE.at(
        problem.origin,
        f"this expression comes to {shown(problem.expression)!r}, and Python knows no name {word}",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        notes=stops(f"NameError: name '{word}' is not defined"),
        help=_COMPARE,
    )

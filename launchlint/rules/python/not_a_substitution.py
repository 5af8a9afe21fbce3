"""A boolean, a number, None or an object stands where launch takes a text or a substitution.

launch converts nothing: `default_value=True`, `arguments=['--rate', 5]` and `launch_arguments={'use_sim_time': True}.items()` are no texts.
(Values of params may be booleans and numbers, and must not be `None` or a list without items.) `period` of a timer takes a number with a
point. What an arg is declared with, `DeclareLaunchArgument`, is no value either: `LaunchConfiguration` is.

## Why it matters

ros2 launch stops with a `TypeError` that names neither the argument nor the line of the launch file.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('rate', default_value=10),
        Node(package='demo_nodes_cpp', executable='talker', arguments=['--rate', LaunchConfiguration('rate')]),
    ])
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('rate', default_value='10'),
        Node(package='demo_nodes_cpp', executable='talker', arguments=['--rate', LaunchConfiguration('rate')]),
    ])
```

## Fix

`--fix` puts quotes around a number or a boolean (`true` and `false`, as in XML), and `.0` behind the number of seconds of a timer. ros2
launch loads the file then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS2, fix
from launchlint.rules.judging.python_text import level, reads_environment, stops, write
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.syntax.ros2.python.problems import ConfigurationAsPythonValue, NotAParameterValue, NotASubstitution

RULE = Rule("LL922", "not-a-substitution", Severity.ERROR, roslaunch="refuses", fixable="safe")


def tell(problem: NotASubstitution | NotAParameterValue, view: object) -> Iterator[Finding]:
    """Name the argument and what is given."""
    if isinstance(problem, NotAParameterValue):
        param = f"the param {problem.name}" if problem.name else "a param"
        yield RULE.at(
            problem.origin,
            f"{param} of {problem.callee} is {problem.found}, which no param can be",
            severity=_level(problem, problem.found),
            notes=stops("a TypeError: unexpected type for parameter value"),
            help="leave the param out where it has no value",
        )
        return
    if isinstance(view, LaunchView) and any(_covers(each, problem) for each in view.launch.noticed(ConfigurationAsPythonValue)):
        return  # LL921 says what is wrong with the expression that gives this value
    timer = problem.argument == "period"
    yield RULE.at(
        problem.origin,
        f"{problem.argument} of {problem.callee} takes {'a number with a point' if timer else 'texts' if problem.item else 'a text'}, "
        f"and {'this is' if problem.item else 'is'} {problem.found}",
        severity=_level(problem, problem.found),
        label="no text" if not timer else "no number with a point",
        notes=stops("a TypeError"),
        help=_advice(problem),
        fix=_fix(problem),
        topic=problem.argument,
    )


def _covers(one: ConfigurationAsPythonValue, problem: NotASubstitution) -> bool:
    at, other = one.place, problem.place
    return at.source is other.source and other.span.start <= at.span.start and at.span.end <= other.span.end


def _level(problem: NotASubstitution | NotAParameterValue, found: str) -> Severity:
    # A variable of the environment that is not set here may be set where the file is launched.
    if found in ("None", "a list without items") and problem.place.text not in ("None", "[]") and reads_environment(problem.place):
        return Severity.INFO
    return level(problem)


def _advice(problem: NotASubstitution) -> str:
    if problem.written:
        return f"write {problem.written}"
    if problem.declared:
        return f"write LaunchConfiguration('{problem.declared}') to use the value of that arg"
    if problem.found == "None":
        return "leave it out where there is no value"
    return "give a text, a substitution, or a list of these"


def _fix(problem: NotASubstitution) -> Fix | None:
    if not problem.written:
        return None
    return fix(f"write {problem.written}", write(problem.place, problem.written), safe=True, changes=LOADS2)

"""A substitution is used in Python as if it were already the text that it will stand for.

`LaunchConfiguration('sim')` is an object, made while the launch file is loaded. Its value exists only when launch executes the description:
a test of it is always true, a comparison with a text always false, an f-string holds the name of the object. What `.perform(context)`
gives in an `OpaqueFunction` is a text: `'false'` is true for Python, too.

## Why it matters

Nothing complains: nodes are started always or never, whatever is given on the command line. Where a text or path is put together, Python
stops with a `TypeError`. Where the value is only printed, or held by a variable that nothing reads, it is an information.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    sim = LaunchConfiguration('sim')
    actions = [DeclareLaunchArgument('sim', default_value='false')]
    if sim == 'true':
        actions.append(Node(package='demo_nodes_cpp', executable='talker'))
    return LaunchDescription(actions)
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    sim = LaunchConfiguration('sim')
    return LaunchDescription([
        DeclareLaunchArgument('sim', default_value='false'),
        Node(package='demo_nodes_cpp', executable='talker', condition=IfCondition(sim)),
    ])
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.python_text import level, shown, stops
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.python.problems import ConfigurationAsPythonValue

RULE = Rule("LL921", "configuration-as-python-value", Severity.ERROR)
_OBJECT = "it is an object here; its value exists only when launch executes the description"
_TEXT = "launch configurations are texts; Python takes every text for true that is not empty"
_IDLE = "nothing is made of it: what it becomes here reaches no action"
_HAPPENS = {
    "test": "is always true here, whatever is given to the launch file",
    "compare": "is never equal to a text or value of Python",
    "format": "is written into the text as an object, not as its value",
    "str": "is turned into the text of an object, not into its value",
    "join": "cannot be added to a text in Python",
    "path": "is no text or number that a function of Python takes",
    "performed": "is a text here, and 'false' counts as true, too",
}
_ADVICE = {
    "test": "give the actions condition=IfCondition(…), or decide in an OpaqueFunction with .perform(context)",
    "compare": "use IfCondition(EqualsSubstitution(…, …)), or compare in an OpaqueFunction with .perform(context)",
    "format": "write a list, whose parts launch joins: ['text', LaunchConfiguration(…)]",
    "str": "give the substitution itself: launch puts its value there",
    "join": "write a list, whose parts launch joins: ['text', LaunchConfiguration(…)]",
    "performed": "compare it: …perform(context).lower() == 'true'",
    "path": "use PathJoinSubstitution([…]), or do it in an OpaqueFunction with .perform(context)",
}


def tell(problem: ConfigurationAsPythonValue, view: object) -> Iterator[Finding]:
    """Say what comes of it."""
    name = f"{problem.name}('{problem.of}')" if problem.of else f"a {problem.name}"
    idle = problem.idle and not problem.refused
    note = _IDLE if idle else _TEXT if problem.use == "performed" else _OBJECT
    compared = problem.use == "performed" and any(each in problem.place.text for each in ("==", "!=", " is "))
    yield RULE.at(
        problem.origin,
        f"{name} {'is a text here, never equal to True or False' if compared else _HAPPENS[problem.use]}",
        severity=Severity.INFO if idle else level(problem),
        label=shown(problem.place.text) if len(problem.place.text) > 200 else "",
        notes=stops("a TypeError") if problem.refused else (note,),
        help="give the substitution itself to an action, or leave this out" if idle else _ADVICE[problem.use],
        topic=problem.use,
        cause=f"{problem.place.source.path} {problem.use} {idle}",
    )

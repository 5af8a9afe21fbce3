"""A launch file in Python makes an action, keeps it in a variable, and gives it to nobody.

What it does: it looks for variables of a function that hold a `Node`, an include, an arg or another action of launch, and that nothing in
the function reads. Where a comment names the variable, as when the line that adds the action has been taken out, it is an information, and
so it is where more actions of the function are commented out, or left out like this, than are added. The same action, left out in several
launch files, is one finding. What would stop launch when it executes the action, as a condition that is none (LL923), is shown with it.

## Why it matters

launch starts what stands in the `LaunchDescription` that is returned, and nothing else: the node is not started, the arg is not declared.
Nothing complains.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    talker = Node(package='demo_nodes_cpp', executable='talker')
    listener = Node(package='demo_nodes_cpp', executable='listener')
    return LaunchDescription([talker])
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    talker = Node(package='demo_nodes_cpp', executable='talker')
    listener = Node(package='demo_nodes_cpp', executable='listener')
    return LaunchDescription([talker, listener])
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.joined import joined
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.python.problems import NeverAdded

RULE = Rule("LL936", "action-never-added", Severity.WARNING)
_CHOSEN = "most other actions here are left out, too, so that it may be done on purpose"
_COMES_TO = {
    "DeclareLaunchArgument": "the arg is not declared",
    "IncludeLaunchDescription": "the file is not included",
    "Node": "the node is not started",
    "LifecycleNode": "the node is not started",
    "ComposableNodeContainer": "the container is not started",
    "LoadComposableNodes": "the nodes are not loaded",
    "ExecuteProcess": "the process is not started",
}


def tell(problem: NeverAdded, view: object) -> Iterator[Finding]:
    """Say what does not come to pass."""
    why = "a comment names it, so that it may be left out on purpose" if problem.commented else _CHOSEN if problem.chosen else ""
    yield RULE.at(
        problem.origin,
        f"{problem.name} is made and never added: {_COMES_TO.get(problem.callee, 'launch never executes it')}",
        severity=Severity.INFO if why else Severity.WARNING,
        label=f"this {problem.callee} is given to nobody",
        related=problem.related,
        cause=f"{bool(why)} {problem.name if problem.commented else problem.together}",
        notes=(why,) if why else (),
        help=f"add {problem.name} to the LaunchDescription, or take it out",
        about=(f"{problem.callee} {problem.name}",),
    )


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for launch files that leave out the same action: one was made from the other."""
    groups: list[tuple[set[object], list[Finding]]] = []
    for finding in findings:
        names: set[object] = {(finding.severity, name) for name in finding.about} or {finding.key}
        several = [finding]
        for group in [each for each in groups if each[0] & names]:
            groups.remove(group)
            names |= group[0]
            several = [*group[1], *several]
        groups.append((names, several))
    yield from (joined(several) if len(several) > 1 else several[0] for _, several in groups)


def together(findings: Sequence[Finding]) -> Finding:
    """One for all of a function, with what each of them is."""
    return joined(findings)._replace(about=tuple(dict.fromkeys(name for each in findings for name in each.about)))

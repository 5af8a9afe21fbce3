"""Launch gets no description out of a launch file in Python: the function is missing, wants arguments, or returns something else.

It executes the file, calls `generate_launch_description()` without arguments, and wants a `LaunchDescription` of actions back. A list of
actions is none, nor is `None`, as from a function that forgets its `return`, nor one with an item that is no action. It is a warning for
an empty file, which is still to be written.

## Why it matters

ros2 launch stops with an error that does not name the line: `'NoneType' object has no attribute …`.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    description = LaunchDescription()
    description.add_action(Node(package='demo_nodes_cpp', executable='talker'))
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    description = LaunchDescription()
    description.add_action(Node(package='demo_nodes_cpp', executable='talker'))
    return description
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.python_text import level, stops
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.python.problems import NoDescription, NotAnAction

RULE = Rule("LL932", "no-description", Severity.ERROR, roslaunch="refuses")
_LAUNCH = re.compile(r"^[ \t]*(?:from|import)[ \t]+launch", re.MULTILINE)
_SPREAD = "write * before it to put its items there"
_INSTEAD = {
    "a list": _SPREAD,
    "a tuple": _SPREAD,
    "a tuple of one item": "remove the comma behind the item, which is what makes it a tuple",
}
_ENTRY = "generate_launch_description"


def tell(problem: NoDescription | NotAnAction, view: object) -> Iterator[Finding]:
    """Say what launch gets instead."""
    if isinstance(problem, NotAnAction):
        yield RULE.at(
            problem.origin,
            f"{problem.found} is no action, and stands among those of {problem.holder}",
            severity=level(problem),
            label="no action",
            notes=stops("an AttributeError when it comes to it"),
            help=_INSTEAD.get(problem.found, "take it out, or make it an action"),
        )
        return
    message, advice, note = _said(problem)
    # A program that calls the function itself, as tests do, is not made for ros2 launch.
    if problem.form == "missing" and _is_empty(problem.place.source.text):
        yield RULE.at(
            problem.origin,
            "the launch file is empty",
            severity=Severity.INFO,  # left to be written, and started by nobody
            notes=stops(note),
            help="write it, or remove it",
            cause=f"empty {problem.place.source.path.rpartition('/')[0]}",
        )
        return
    text = problem.place.source.text
    own = "__main__" in text and (problem.form == "arguments" or (problem.form == "missing" and not _LAUNCH.search(text)))
    yield RULE.at(problem.origin, message, severity=Severity.INFO if own else level(problem), notes=stops(note), help=advice)


def _is_empty(text: str) -> bool:
    """Whether there is nothing in a launch file but what says what it is to become."""
    return all(not line or line.startswith("#") for line in map(str.strip, text.splitlines()))


def _said(problem: NoDescription) -> tuple[str, str, str]:
    what = problem.what
    if problem.form == "syntax":
        return f"Python cannot read this launch file: {what}", "", "a SyntaxError"
    if problem.form == "missing":
        return f"this launch file has no function {_ENTRY}", f"define {_ENTRY}() to return a LaunchDescription", "an error that names it"
    if problem.form == "arguments":
        message = f"{_ENTRY} wants arguments ({what}), and launch gives none"
        return message, "use an OpaqueFunction for what needs the context, or give them defaults", "a TypeError"
    advice = f"return LaunchDescription({'[…]' if problem.form != 'list' else '…'})"
    gives = "returns nothing" if problem.form == "nothing" else f"returns {what}"
    return f"{_ENTRY} {gives}, where launch wants a LaunchDescription", advice, "an AttributeError"

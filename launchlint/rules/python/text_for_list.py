"""A text, a dict or one pair stands where launch takes a list, or a list where it takes a pair.

`arguments='--rate 5'` gives the program each letter as an argument of its own. `parameters` takes a list of files and dicts, and
`remappings` one of tuples of two texts.

## Why it matters

Of a text for `arguments` or `cmd` launch says nothing, and the program gets single letters. For all others it stops with a `TypeError`.

## Example

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo_nodes_cpp', executable='talker', remappings=('chatter', 'talk')),
    ])
```

## Use instead

```python launch/robot.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo_nodes_cpp', executable='talker', remappings=[('chatter', 'talk')]),
    ])
```

## Fix

`--fix` writes the brackets where the value is written out; a text for `arguments` is split at its blanks.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS2, fix
from launchlint.rules.judging.python_text import around, behind, is_one_operand, level, literal, stops, write
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.python.problems import TextForList

RULE = Rule("LL927", "text-for-list", Severity.ERROR, roslaunch="refuses", fixable="safe")
_IS = {
    "letters": "is a text, of which the program gets each letter as an argument",
    "text": "is a text, not a list",
    "dict": "is a dict, not a list",
    "tuple": "is a tuple, not a list",
    "one": "is one thing, not a list",
    "list-for-pair": "has a list in it where a tuple of two texts is wanted",
    "flat-pair": "is one pair, not a list of pairs",
    "not-pair": "has something else in it than tuples of two texts",
    "not-two": "has a tuple in it that does not hold two texts",
}
_ADVICE = {
    "letters": "write a list with one text for each word",
    "list-for-pair": "write ('from', 'to') with round brackets",
    "flat-pair": "put it in brackets: [('from', 'to')]",
    "not-pair": "write [('from', 'to'), …]",
    "not-two": "write ('from', 'to')",
}


def tell(problem: TextForList, view: object) -> Iterator[Finding]:
    """Say what stands there, and how it is written."""
    form = problem.form
    yield RULE.at(
        problem.origin,
        f"{problem.argument} of {problem.callee} {_IS[form]}",
        severity=level(problem),
        notes=stops("a TypeError") if problem.refused else ("launch goes on with the letters",),
        help=_ADVICE.get(form, "put it in brackets: […]"),
        fix=_fix(problem),
    )


def _fix(problem: TextForList) -> Fix | None:
    place, form = problem.place, problem.form
    text = place.text
    if form == "letters":
        value = literal(place)
        if not isinstance(value, str) or any(each in value for each in "'\"\\$"):
            return None
        words = ", ".join(repr(word) for word in value.split())
        return fix(f"write [{words}]", write(place, f"[{words}]"), safe=True, changes="the program gets words instead of letters")
    if form == "list-for-pair" and text.startswith("[") and text.endswith("]"):
        return fix("write a tuple", write(place, f"({text[1:-1]})"), safe=True, changes=LOADS2)
    if form == "tuple" and text.startswith("(") and text.endswith(")"):
        return fix("write a list", write(place, f"[{text[1:-1].rstrip().removesuffix(',')}]"), safe=True, changes=LOADS2)
    if form == "dict" and problem.argument == "remappings":
        return fix("write .items()", behind(place, ".items()"), safe=True, changes=LOADS2) if is_one_operand(place) else None
    if form in ("dict", "one", "flat-pair") or (form == "text" and problem.argument != "remappings"):
        return fix("put it in brackets", around(place, "[", "]"), safe=True, changes=LOADS2)
    return None

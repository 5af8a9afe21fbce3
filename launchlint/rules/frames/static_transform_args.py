"""The arguments of a `static_transform_publisher` are not what it reads.

What it does: it reads `args` as the program does. That of tf takes `x y z yaw pitch roll parent child period` or `x y z qx qy qz qw parent
child period` (the period in milliseconds), that of tf2_ros the same without the period, or the name of a param. It is an error where the
program exits with its usage text, where a frame is read as a number or a number as a frame, where parent and child are the same frame, and
where the listeners drop the transform because its quaternion has not the length 1. It is a warning where a word is no number and is read
as 0, or as the digits it begins with, and where tf's program brings the quaternion to the length 1 itself; an info where only one of the
four numbers is not 0, since that changes nothing then.

A `/` before a frame is no mistake here: who receives the transform takes it off. It looks at launch files of ROS 1: the program of ROS 2
takes its arguments by name (`--x 1 --frame-id map`) and says itself what it cannot read.

## Why it matters

The node exits at once, or it runs and nobody gets the transform. What needs it waits, or drops its data with a message about a frame
that does not exist.

## Example

```xml
<launch>
  <node pkg="tf2_ros" type="static_transform_publisher" name="laser" args="0.2 0 0.1 0 0 0 base_link laser 100"/>
  <node pkg="tf" type="static_transform_publisher" name="camera" args="0.2 0 0.1 0 0 0 base_link camera"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="tf2_ros" type="static_transform_publisher" name="laser" args="0.2 0 0.1 0 0 0 base_link laser"/>
  <node pkg="tf" type="static_transform_publisher" name="camera" args="0.2 0 0.1 0 0 0 base_link camera 100"/>
</launch>
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import inf, isfinite

from launchlint.finding import Finding, Severity
from launchlint.graph.command_line import command_line
from launchlint.late import late
from launchlint.model import Launch, Node
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin
from launchlint.syntax.parts import Literal, Malformed, Part
from launchlint.syntax.ros1.substitutions import parse

RULE = Rule("LL621", "static-transform-args", Severity.ERROR)

PROGRAM = "static_transform_publisher"
FORMS = {
    "tf": "x y z yaw pitch roll parent child period_in_ms, or x y z qx qy qz qw parent child period_in_ms",
    "tf2_ros": "x y z yaw pitch roll parent child, or x y z qx qy qz qw parent child",
}
_PERIOD = {"tf": 1, "tf2_ros": 0}
_POSE, _QUATERNION = 6, 7
_TOLERANCE = 10e-3
"""How far the square of a quaternion's length may be from 1 (tf2's QUATERNION_NORMALIZATION_TOLERANCE)."""
_PLAINLY_OFF = 0.1
_NUMBER = late(r"[-+]?(?:0[xX][0-9a-fA-F]+|(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?|inf(?:inity)?|nan)", re.IGNORECASE)
"""What C's atof reads, after blanks."""
_WORD = late(r"\w+")


def check(view: LaunchView) -> Iterator[Finding]:
    """Read the arguments as the programs do (main in static_transform_publisher.cpp, static_transform_broadcaster_program.cpp)."""
    for node in (*view.launch.nodes, *view.launch.tests):
        if node.executable != PROGRAM or node.package not in FORMS or not node.knows("package", "executable", "arguments"):
            continue
        line = command_line(node)
        if line.known and not _lacks_a_value(node, view.launch):
            yield from _judge(node, tuple(word for word in line.words if isinstance(word, str)))


def _lacks_a_value(node: Node, launch: Launch) -> bool:
    """Whether a word is missing because an arg is empty: whoever starts the file gives it."""
    place = node.places.get("arguments")
    if place is None:
        return False
    parts = parse(place.text)
    if not parts.computed:
        return False
    empty = {argument.name for argument in launch.declared if (argument.default if argument.value is None else argument.value) == ""}

    def filled(part: Part) -> str:
        if isinstance(part, (Literal, Malformed)):
            return part.text
        command, *words = _WORD.findall(part.text) or [""]
        return "" if not empty.isdisjoint(words) or (command == "optenv" and len(words) == 1) else "x"

    return len("".join(map(filled, parts.parts)).split()) < len(parts.beside("x").split())


def _judge(node: Node, words: tuple[str, ...]) -> Iterator[Finding]:
    period = _PERIOD[node.package]
    numbers = len(words) - 2 - period
    if node.package == "tf2_ros" and len(words) == 1:
        return  # the name of a param that holds the transform
    if numbers not in (_POSE, _QUATERNION):
        yield _told(node, _count(node.package, words), "not the right number of words", ("it prints its usage text and exits",))
        return
    shifted = _shifted(node.package, words)
    if shifted:
        parent, child = words[numbers : numbers + 2]
        notes = (f"so its parent frame is {parent or 'empty'}, and its child frame {child or 'empty'}",)
        yield _told(node, f"{node.package}/{PROGRAM} {shifted}", "read in another way", notes)
        return
    yield from _frames(node, words[numbers], words[numbers + 1])
    values = [_value(word) for word in words[:numbers]]
    odd = [
        word
        for word, (_, whole) in zip((*words[:numbers], *words[numbers + 2 :]), (*values, *map(_value, words[numbers + 2 :])), strict=True)
        if not whole
    ]
    if odd:
        read = ", ".join(f'"{word}" as {_value(word)[0]:g}' for word in odd)
        yield _told(node, f"{node.package}/{PROGRAM} reads {read}", "no number", help="write plain numbers", severity=Severity.WARNING)
    elif numbers == _QUATERNION:
        yield from _quaternion(node, [value for value, _ in values[3:]])


def _count(package: str, words: tuple[str, ...]) -> str:
    fewest = _POSE + 2 + _PERIOD[package]
    given = "no arguments" if not words else f"{len(words)} argument{'s' if len(words) > 1 else ''}"
    return f"{package}/{PROGRAM} takes {fewest} or {fewest + 1} arguments, and gets {given}"


def _shifted(package: str, words: tuple[str, ...]) -> str:
    """How the words are meant where they are plainly those of another form; else empty."""
    if package == "tf2_ros" and len(words) == 9 and not _is_number(words[6]) and _is_number(words[8]):
        return f'has no period: with 9 arguments it reads "{words[6]}" as the last part of a quaternion'
    if package == "tf" and len(words) == 9 and _is_number(words[6]) and not _is_number(words[8]):
        return f'needs a period: without one it reads "{words[6]}" as a frame and "{words[8]}" as the period'
    if package == "tf" and len(words) == 10 and not _is_number(words[6]) and not _is_number(words[7]):
        return f'takes 10 arguments only with a quaternion, and reads "{words[6]}" as the last part of it'
    return ""


def _frames(node: Node, parent: str, child: str) -> Iterator[Finding]:
    if parent.removeprefix("/") == child.removeprefix("/"):
        yield _told(
            node,
            f'the transform leads from the frame "{parent}" to itself',
            "parent and child are the same",
            ("the program exits",) if node.package == "tf2_ros" and parent == child else ("who receives the transform drops it",),
            "write two different frames: parent first, then child",
            cause=f"{node.package} {parent} to {child}",
        )


def _quaternion(node: Node, parts: list[float]) -> Iterator[Finding]:
    square = sum(part * part for part in parts)
    if abs(square - 1) < _TOLERANCE:
        return
    off = f"the quaternion {' '.join(f'{part:g}' for part in parts)} has the length {square**0.5:.4g}, not 1"
    help_ = "the four numbers are qx qy qz qw; no rotation is 0 0 0 1"
    if node.package == "tf2_ros" or square == 0 or not isfinite(square):
        yield _told(node, off, "no rotation", ("who receives the transform drops it (TF_DENORMALIZED_QUATERNION)",), help_)
    elif abs(square - 1) >= _PLAINLY_OFF:
        one = sum(part != 0 for part in parts) == 1  # half a turn, or none, whatever the length
        level = Severity.INFO if one else Severity.WARNING
        yield _told(node, off, "no rotation as it stands", ("tf brings it to the length 1",), help_, level)


def _told(
    node: Node, message: str, label: str, notes: tuple[str, ...] = (), help: str = "", severity: Severity | None = None, cause: str = ""
) -> Finding:
    return RULE.at(
        Origin(node.places.get("arguments", node.origin.place), node.origin.step),
        message,
        severity=severity,
        label=label,
        notes=notes,
        help=help or f"it reads {FORMS[node.package]}",
        cause=cause or f"{node.package} {message}",
    )


def _is_number(word: str) -> bool:
    return _value(word)[1]


def _value(word: str) -> tuple[float, bool]:
    """What C's atof makes of a word, and whether that is all of it; a comma at the end does no harm."""
    text = word.strip()
    match = _NUMBER.match(text)
    if match is None:
        return 0.0, False
    number = match[0]
    try:
        value = float(int(number, 16)) if "x" in number.lower() else float(number)
    except OverflowError:
        value = inf
    return value, text[match.end() :] in ("", ",")

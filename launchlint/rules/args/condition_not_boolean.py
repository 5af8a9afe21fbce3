"""The value of an `if` or `unless` is no boolean.

It must be `true`, `false`, `1` or `0` (in any letter case) once all substitutions are resolved: `yes`, `2`, an empty
text and a comparison without `$(eval …)` are refused. All configurations are tried; the command that shows the
mistake is printed.

In ROS 2 the same four words are taken. What `$(not …)`, `$(and …)`, `$(or …)` and `$(if …)` look at may also be `yes`, `no`, `on` or `off`.

## Why it matters

roslaunch refuses the file with `Value error`, and does not say which line.

## Example

```xml
<launch>
  <arg name="sim" default="yes"/>
  <node pkg="gazebo_ros" type="gzserver" name="gazebo" if="$(arg sim)"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <arg name="mode" default="fast"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker" if="$(var mode) == 'fast'"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="sim" default="true"/>
  <node pkg="gazebo_ros" type="gzserver" name="gazebo" if="$(arg sim)"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <arg name="mode" default="fast"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker" if="$(eval &quot;'$(var mode)' == 'fast'&quot;)"/>
</launch>
```

## Fix

`--fix` writes `true` or `false` for a literal word that means it, or is one slip away. roslaunch loads the file then.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import ConditionNotBoolean
from launchlint.evaluate.ros2.problems import NotABoolean
from launchlint.finding import Finding, Fix, Severity
from launchlint.model import ROS2
from launchlint.rules.edits import LOADS, LOADS2, fix, is_literal, set_value, spot, write_over
from launchlint.rules.judging.joined import led_by
from launchlint.rules.judging.left_over import left_over_in
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.rules.wording import words_at
from launchlint.spelling import closest, surely
from launchlint.syntax.problems import InvalidValue
from launchlint.syntax.ros1.substitutions import parse

RULE = Rule("LL214", "condition-not-boolean", Severity.ERROR, roslaunch="refuses", fixable="safe")
WORDS = {"yes": "true", "on": "true", "enabled": "true", "y": "true", "no": "false", "off": "false", "disabled": "false", "n": "false"}
COMPUTED = re.compile(r"[=!<>]=|[<>]|\b(?:and|or|not|in)\b")


def tell(problem: ConditionNotBoolean | InvalidValue | NotABoolean, view: object) -> Iterator[Finding]:
    """Show the value. What is told of the file alone comes as :class:`InvalidValue`."""
    if isinstance(problem, NotABoolean):
        yield _in_substitution(problem)
        return
    if isinstance(problem, ConditionNotBoolean) and isinstance(view, LaunchView) and view.dialect.name == ROS2:
        yield _ros2(problem)
        return
    name, value = problem.attribute, problem.value
    if isinstance(problem, InvalidValue) and (name not in ("if", "unless") or "$" in value):
        return
    text = value if isinstance(problem, InvalidValue) else problem.text
    made = f" (from {text[:60]})" if text != value else ""
    shown = "is empty" if not value.strip() else f"comes to {value[:60]!r}{made}" if made else f"is {value[:60]!r}"
    note = f"roslaunch stops with: Value error: {value.lower().strip()[:60]} is not a 'bool' type".replace(":  is", ": is")
    if parse(value).computed:  # nobody knows what it stands for, but what is written beside it is enough
        shown, note = (
            f"is {value[:60]!r}",
            "whatever the substitution stands for, the text beside it stays, and roslaunch stops with: Value error",
        )
    yield RULE.at(
        problem.origin,
        f"{name} {shown}, which is no boolean",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label="must be true, false, 1 or 0",
        notes=(note,),
        help=_advice(name, value, text),
        fix=_fix(problem, view, value),
        cause=f"{problem.place.source.path} {text} {value}",
        shared_cause=left_over_in(value, view) if isinstance(view, LaunchView) else "",
    )


def together(findings: Sequence[Finding]) -> Finding:
    """Conditions that ask for one value; a substitution in it that is none is told before them."""
    return led_by(findings, "LL215")


def _fix(problem: ConditionNotBoolean | InvalidValue, view: object, value: str) -> Fix | None:
    word = value.strip().lower()
    meant = WORDS.get(word) or surely(word, ("true", "false"))
    if meant is None or not is_literal(problem.place, value):
        return None
    return fix(f"write {meant}", set_value(spot(view, problem.place), meant), safe=True, changes=LOADS)


def _advice(name: str, value: str, text: str) -> str:
    word = WORDS.get(value.strip().lower()) or closest(value.strip().lower(), ("true", "false"))
    parts = parse(text)
    if parts.expression is not None:
        return "make the expression a comparison, so that it gives True or False"
    if text == value and word is not None:
        return f'write {name}="{word}"'
    if parts.computed and COMPUTED.search(parts.beside()):
        return "comparisons need $(eval …), as in $(eval arg('mode') == 'fast')"
    if COMPUTED.search(text):
        return f'write {name}="$(eval …)" to compute something'
    if word is not None:
        return f"make the arg {word}"
    return "to compare with a text, write $(eval arg('mode') == 'fast')" if any(parts.substitutions("arg")) else "write true or false"


def _ros2(problem: ConditionNotBoolean) -> Finding:
    name, value, text = problem.attribute, problem.value, problem.text
    word = value.strip().lower()
    meant = WORDS.get(word) or surely(word, ("true", "false"))
    made = f" (from {text[:60]})" if text != value else ""
    shown = "is empty" if not word else f"comes to {value[:60]!r}{made}" if made else f"is {value[:60]!r}"
    words = words_at(problem.origin)
    if COMPUTED.search(value):
        advice = f"comparisons need {words.call('eval', '…')}, as in {words.equals('mode', 'fast')}"
    elif made:
        advice = f"make what it comes from {meant}" if meant else f"compare it, as in {words.equals('mode', 'fast')}"
    else:
        advice = f"write {words.set_to(name, meant)}" if meant else "write true or false"
    return RULE.at(
        problem.origin,
        f"{name} {shown}, which is no boolean",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label="must be true, false, 1 or 0",
        notes=("ros2 launch stops with: invalid condition expression error",),
        help=advice,
        fix=None if meant is None or made else fix(f"write {meant}", write_over(problem.place, value, meant), safe=True, changes=LOADS2),
    )


def _in_substitution(problem: NotABoolean) -> Finding:
    words = words_at(problem.origin)
    return RULE.at(
        problem.origin,
        f"{words.call(problem.substitution, '…')} looks at {problem.value[:60]!r}, which is no boolean",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        label="must be true or false",
        notes=("ros2 launch stops when it gets here",),
        help=f"write true or false, or a comparison: {words.call('eval', '…')}",
    )

"""Something looks like a substitution and is none.

`$(arg x` without its closing parenthesis, `${arg x}`, `$ (arg x)` and `(arg x)` are plain text for roslaunch, and so
is every `$(…)` in a `<rosparam>` without `subst_value="true"`. A parenthesis too many behind a substitution stays in
the value as well.

## Why it matters

roslaunch loads the file and says nothing. The node gets the text as it stands, as a file name, a topic or a number.

## Example

```xml
<launch>
  <arg name="frame" default="map"/>
  <param name="global_frame" value="${arg frame}"/>
  <param name="odom_frame" value="$(arg frame)_odom"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="frame" default="map"/>
  <param name="global_frame" value="$(arg frame)"/>
  <param name="odom_frame" value="$(arg frame)_odom"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule

RULE = Rule("LL215", "unexpanded-substitution", Severity.WARNING)


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Say what it lacks; facts: ``text``, ``extra`` (a parenthesis too many), maybe ``rosparam``."""
    text: str = problem.facts["text"]
    if problem.facts["extra"]:
        message, advice = "a ) too many: it stays in the value", "remove it"
    elif problem.facts.get("rosparam"):
        message = f"{text[:60]} is not replaced in this <rosparam>"
        advice = 'add subst_value="true"'
    else:
        message = f"{text.strip()[:60]} is no substitution: it stays in the value as it is"
        advice = _advice(text)
    yield RULE.at(problem.origin, message, label="plain text", help=advice)


def _advice(text: str) -> str:
    words = text.strip("$ ({[)}]").split()
    meant = f"$({' '.join(words)})"
    if text.startswith("$(") and ")" not in text:
        return "close it with )" if len(words) < 2 else f"close it with ): {meant}"
    return f"write {meant}"

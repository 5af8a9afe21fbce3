"""Something looks like a substitution and is none.

`$(arg x` without its closing parenthesis, `$arg x)`, `$arg(x)`, `${arg x}`, `$ (arg x)` and `(arg x)` are plain text for
roslaunch, and so is every `$(…)` in a `<rosparam>` without `subst_value="true"`. A parenthesis too many behind a substitution
stays in the value as well. What comes of it is told with it: files that are not found for that reason. The same text in several places is
told once. It looks at launch files of ROS 1: launch of ROS 2 refuses most of these, which LL207 tells.

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

## Fix

`--unsafe-fixes` writes `$(arg a)` for `$(arg a`, `$(arg a}`, `$arg a)`, `$arg(a)`, `${arg a}`, `$[arg a]` and `$ (arg a)`, likewise
with `find`, `env` and `anon`, and removes a parenthesis too many. The value is another one then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import UnexpandedSubstitution
from launchlint.finding import Finding, Fix, Severity
from launchlint.late import late
from launchlint.rules.edits import fix, replace, spot
from launchlint.rules.judging.left_over import cause_at
from launchlint.rules.rule import Rule

_MENDED = ("arg", "find", "env", "anon")
_NAME = late(r"[\w.-]+")

RULE = Rule("LL215", "unexpanded-substitution", Severity.WARNING, fixable="unsafe")


def tell(problem: UnexpandedSubstitution, view: object) -> Iterator[Finding]:
    """Say what it lacks."""
    text = problem.text
    if problem.extra:
        message, advice = "a ) too many: it stays in the value", "remove it"
    elif problem.rosparam:
        message = f"{text[:60]} is not replaced in this <rosparam>"
        advice = 'add subst_value="true"'
    else:
        message = f"{text.strip()[:60]} is no substitution: it stays in the value as it is"
        advice = _advice(text, problem.words)
    yield RULE.at(problem.origin, message, label="plain text", help=advice, fix=_fix(problem, view), shared_cause=cause_at(problem))


def _fix(problem: UnexpandedSubstitution, view: object) -> Fix | None:
    """What is nearly a substitution of an arg, a package or a variable becomes one; a parenthesis too many goes."""
    place, at = problem.place, spot(view, problem.place)
    if problem.rosparam:
        return None
    if problem.extra:
        return fix("remove it", replace(at, place, ""), safe=False, changes="the ) is no longer part of the value")
    words = problem.words
    if len(words) != 2 or words[0] not in _MENDED or _NAME.fullmatch(words[1]) is None or not place.text.startswith("$"):
        return None
    text = f"$({' '.join(words)})"
    return fix(f"write {text}", replace(at, place, text), safe=False, changes="it is replaced by what it stands for")


def _advice(text: str, words: tuple[str, ...]) -> str:
    meant = f"$({' '.join(words)})"
    if text.startswith("$(") and ")" not in text:
        return "close it with )" if len(words) < 2 else f"close it with ): {meant}"
    return f"write {meant}"

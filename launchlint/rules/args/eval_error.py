"""A `$(eval …)` fails.

The expression is computed as roslaunch would, with the args as they are in each configuration: it has a syntax error,
uses a name that does not exist, or does something that its values do not allow, such as adding a number to a text. A
comparison like `count == '5'` is a warning: an arg that reads 5 is a number there, and never equal to a text. It is
told once for a file, with all places.
Expressions that use parts of Python which launchlint does not compute are named as information.

## Why it matters

roslaunch refuses the file; its message is Python's, without the line.

## Example

```xml
<launch>
  <arg name="speed" default="fast"/>
  <arg name="limit" value="$(eval speed * 1.5)"/>
  <param name="limit" value="$(arg limit)"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="speed" default="2"/>
  <arg name="limit" value="$(eval speed * 1.5)"/>
  <param name="limit" value="$(arg limit)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import EvalError, EvalNeverEqual, EvalNotCovered
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView, of_ros2
from launchlint.spelling import closest

RULE = Rule("LL208", "eval-error", Severity.ERROR, roslaunch="refuses")


def tell(problem: EvalError | EvalNotCovered | EvalNeverEqual, view: LaunchView) -> Iterator[Finding]:
    """Say why."""
    if of_ros2(view) and not isinstance(problem, EvalNeverEqual):
        from launchlint.rules.judging import ros2_args as ros2_words

        if ros2_words.takes_text_for_name(problem):
            return  # LL923 has more to say
        yield from ros2_words.expression(problem, RULE)
        return
    if isinstance(problem, EvalNeverEqual):
        yield _never_equal(problem)
        return
    reason = problem.reason
    if isinstance(problem, EvalNotCovered):
        yield RULE.at(
            problem.origin,
            f"launchlint does not compute this $(eval …): {reason}",
            severity=Severity.INFO,
            notes=("what depends on it is not checked any further",),
        )
        return
    advice = _advice(reason, problem.expression, problem.place.text, problem.known)
    yield RULE.at(
        problem.origin,
        f"$(eval …) fails: {reason}",
        severity=Severity.ERROR if problem.refused else Severity.WARNING,
        notes=("roslaunch stops with the same error of Python's",),
        help=advice,
        cause=f"{problem.place.source.path} {reason} {advice}",
    )


def _never_equal(problem: EvalNeverEqual) -> Finding:
    name, literal = problem.name, problem.literal
    truth = literal.lower() in ("true", "false")
    value = literal.capitalize() if truth else literal
    outcome = "true" if problem.negated else "false"
    return RULE.at(
        problem.origin,
        f"this comparison is always {outcome}: {name} can never be the text {literal!r}",
        severity=Severity.WARNING,
        notes=(f"roslaunch makes a {'boolean' if truth else 'number'} of an arg that reads {literal}",),
        help=f"compare with {value}, without quotes" if truth else f"compare with {value} without quotes, or write str({name})",
        cause=f"{problem.place.source.path} compares with {'a truth value' if truth else 'a number'} as text",
    )


def _advice(reason: str, expression: str, at: str, known: tuple[str, ...]) -> str:
    if "$(" in expression:
        return "inside $(eval …) write arg('name') or just name, and find('package'): no $(…)"
    if "__" in expression:
        return "roslaunch refuses two underscores in a row in any $(eval …): pass the value as an arg"
    if "not defined" in reason or "no arg" in reason:
        near = closest(at, known)
        return f"did you mean {near}?" if near is not None else f"put quotes around {at} if it is a text" if at.isidentifier() else ""
    if "TypeError" in reason:
        return "args are numbers or booleans where they look like one, else texts: convert with str(…), int(…) or float(…)"
    if "SyntaxError" in reason:
        return "write it as one expression of Python"
    return ""

"""What is executed later, by a `<timer>` or when something ends, uses a value of the group around it, which is gone by then.

What it does: it looks at what waits in a group for a timer, or for the end of a process: at each `$(var x)` that reads what the group has
set, and at nodes and includes that are to be in the namespace that the group has pushed. Where the launch configuration does not exist any
more it is an error.

## Why it matters

The group ends at once, and the timer fires later: with what is set at the end of the launch. A node comes up without its namespace, or with
the value of somebody else, or `ros2 launch` stops seconds after everything seemed to work. (Versions after the first ones of 2025 keep it.)

## Example

```xml
<launch>
  <group>
    <push_ros_namespace namespace="front"/>
    <timer period="5.0">
      <node pkg="demo_nodes_cpp" exec="talker" name="talker"/>
    </timer>
  </group>
</launch>
```

## Use instead

```xml
<launch>
  <timer period="5.0">
    <group>
      <push_ros_namespace namespace="front"/>
      <node pkg="demo_nodes_cpp" exec="talker" name="talker"/>
    </group>
  </timer>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.problems import ScopeLost
from launchlint.finding import Finding, Severity
from launchlint.rules.judging.never_declared import never_declared
from launchlint.rules.rule import Rule
from launchlint.rules.wording import words_at

RULE = Rule("LL919", "deferred-loses-scope", Severity.WARNING)


def tell(problem: ScopeLost, view: object) -> Iterator[Finding]:
    """Say what it gets instead (launch.actions.TimerAction executes its actions in the context of the whole launch)."""
    name, value, instead = problem.name, problem.value, problem.instead
    words = words_at(problem.origin)
    timer = problem.later == "timer"
    when, waiting = ("the timer fires", f"the {words.tag('timer')}") if timer else (f"this is executed ({problem.later})", "what waits")
    if not name:
        message = f"this is not started in {value}: the group has ended when {when}"
        label, cause = f"in {instead or '/'} instead", f"{problem.place.source.path} {problem.later}"
    elif instead is None:
        message = f"{name} is not set any more when {when}: the group has ended by then"
        label, cause = "not set any more", ""
    else:
        message = f"{name} is not {value} when {when}, but {instead}: the group has ended by then"
        label, cause = f"{instead} by then", f"{problem.place.source.path} {problem.later}"
    gone = bool(name) and instead is None
    yield RULE.at(
        problem.origin,
        message,
        severity=Severity.ERROR if gone else None,
        label=label,
        related=problem.related,
        notes=(f"ros2 launch stops then with: launch configuration '{name}' does not exist",) if gone else (),
        help=f"put the {words.tag('group')} into {waiting}, with what is set in it",
        topic=name,
        cause=cause,
        shared_cause=never_declared(problem.place.source.path, name) if gone else "",
    )

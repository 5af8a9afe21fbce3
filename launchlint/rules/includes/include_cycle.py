"""A launch file includes itself, directly or through others.

What it does: it follows the includes as roslaunch does, with the same arguments. A file that includes itself only until some
argument says stop is fine.

## Why it matters

roslaunch goes round until Python gives up, and prints hundreds of lines that do not name the file that started it.

## Example

```xml
<launch>
  <include file="$(dirname)/base.launch"/>
</launch>
```

```xml base.launch
<launch>
  <include file="$(dirname)/example.launch"/>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/base.launch"/>
</launch>
```

```xml base.launch
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import IncludeCycle
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView, of_ros2

RULE = Rule("LL402", "include-cycle", Severity.ERROR, roslaunch="refuses")


def tell(problem: IncludeCycle, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``include-cycle``: the same file entered again in the same way, or includes too deep for roslaunch."""
    if of_ros2(view):
        from launchlint.rules.judging import ros2_args as ros2_words

        yield from ros2_words.cycle(problem, RULE)
        return
    cycle: tuple[str, ...] = problem.cycle
    stops = "roslaunch stops with: maximum recursion depth exceeded"
    way = " → ".join(cycle)
    if problem.endless:
        message = f"{cycle[-1]} includes itself" if len(cycle) < 3 else f"{cycle[-1]} includes itself through {cycle[-2]}"
        yield RULE.at(
            problem.origin, message, label="this closes the circle", notes=(f"the includes go {way}", stops),
            help="take one of these includes out, or give it a condition that ends",
        )  # fmt: skip
        return
    yield RULE.at(
        problem.origin, f"includes are nested {problem.depth} deep here", label="too deep",
        notes=(f"the includes go {way}", stops),
        help="does a file include itself with other args each time? Give that include a condition that ends",
    )  # fmt: skip

"""A node is to run on a machine that no `<machine>` tag defines.

What it does: it compares the `machine` of every node and test with the machines of the whole launch. A machine may be defined
after the node that uses it, and in any included file.

## Why it matters

roslaunch loads the file and then refuses to start anything.

## Example

```xml
<launch>
  <machine name="onboard" address="robot1.local" env-loader="/opt/robot/env.sh"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera" machine="on_board"/>
</launch>
```

## Use instead

```xml
<launch>
  <machine name="onboard" address="robot1.local" env-loader="/opt/robot/env.sh"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera" machine="onboard"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.spelling import did_you_mean

RULE = Rule("LL306", "unknown-machine", Severity.ERROR, roslaunch="reports")


def tell(problem: Problem, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``unknown-machine`` (roslaunch.config.ROSLaunchConfig._select_machine)."""
    name, known = problem.facts["name"], problem.facts["known"]
    if not view.launch.complete and name not in known:
        return
    defined = f"defined are: {', '.join(known)}" if known else "no machine is defined"
    yield RULE.at(
        problem.origin,
        f"there is no machine {name}",
        label="not defined",
        notes=(f"roslaunch stops with: ERROR: unknown machine [{name}]", defined),
        help=did_you_mean(name, known) or f'define it: <machine name="{name}" address="…"/>',
    )

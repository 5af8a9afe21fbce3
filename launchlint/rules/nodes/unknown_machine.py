"""A node is to run on a machine that no `<machine>` tag defines.

What it does: it compares the `machine` of every node and test with the machines of the whole launch. A machine may be defined
after the node that uses it, and in any included file. Where the launch defines no machine at all it is a warning: the file may be
made to be included.

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
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView
from launchlint.spelling import did_you_mean

RULE = Rule("LL306", "unknown-machine", Severity.ERROR, roslaunch="reports")


def check(view: LaunchView) -> Iterator[Fine]:
    """Say of each node whose machine is defined here that it is in order: its file may well be made to be included."""
    for node in (*view.launch.nodes, *view.launch.tests):
        if node.machine in view.launch.machines and "machine" in node.attributes:
            yield RULE.fine(node.attributes["machine"])


def tell(problem: Problem, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``unknown-machine`` (roslaunch.config.ROSLaunchConfig._select_machine)."""
    name, known = problem.facts["name"], problem.facts["known"]
    if not view.launch.complete:
        return
    certain = bool(known) or view.declared_entry
    yield RULE.at(
        problem.origin,
        f"there is no machine {name}",
        severity=None if certain else Severity.WARNING,
        label="not defined",
        notes=(
            f"roslaunch stops with: ERROR: unknown machine [{name}]",
            f"defined are: {', '.join(known)}" if known else "no machine is defined: this works only where the including file defines it",
        ),
        help=did_you_mean(name, known) or f'define it: <machine name="{name}" address="…"/>',
    )

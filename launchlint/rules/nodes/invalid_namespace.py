"""A namespace is none that ROS allows.

What it does: it looks at the resolved `ns` of groups, includes, nodes and tests. A private name (`~…`) is an error, because
roslaunch stops with a traceback. Other characters than letters, digits, `_` and `/`, or a digit at the start, are warnings:
roslaunch takes them and the nodes do not.

## Why it matters

C++ nodes end at start with an invalid-name exception. Python nodes end up under names that other tools refuse.

## Example

```xml
<launch>
  <group ns="~sensors">
    <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
  </group>
</launch>
```

## Use instead

```xml
<launch>
  <group ns="sensors">
    <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
  </group>
</launch>
```

## Fix

`--unsafe-fixes` writes the namespace that the help proposes.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.problem import Problem
from launchlint.rules.edits import LOADS, fix, is_literal, set_value, spot
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView

RULE = Rule("LL314", "invalid-namespace", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: Problem, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``invalid-namespace`` (rosgraph.names.make_global_ns, roscpp's names::validate)."""
    namespace = problem.facts["namespace"]
    if problem.facts["private"]:
        base = namespace.lstrip("~/")
        yield RULE.at(
            problem.origin, f"the namespace {namespace} is private", label="~ stands for a node's own namespace",
            notes=(f"roslaunch stops with: cannot turn [{namespace}] into a global name",),
            help=f'write ns="{base}"' if base else "write the namespace without ~",
            fix=_fix(problem, view, base, LOADS),
        )  # fmt: skip
        return
    good = re.sub(r"[^\w/]", "_", namespace.strip(), flags=re.ASCII)
    good = f"n_{good}" if good[:1].isdigit() else good
    yield RULE.at(
        problem.origin, f"the namespace {namespace!r} is not a valid ROS name", severity=Severity.WARNING, label="invalid",
        notes=("roslaunch takes it, but C++ nodes in it end at start with an invalid-name exception",),
        help=f"use letters, digits, _ and /, a letter first: {good}",
        fix=_fix(problem, view, good, f"the namespace is {good}"),
    )  # fmt: skip


def _fix(problem: Problem, view: LaunchView, namespace: str, changes: str) -> Fix | None:
    if not namespace or not is_literal(problem.place, problem.facts["namespace"]):
        return None
    return fix(f'write ns="{namespace}"', set_value(spot(view, problem.place), namespace), safe=False, changes=changes)

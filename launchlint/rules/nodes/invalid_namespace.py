"""A namespace is none that ROS allows.

What it does: it looks at the resolved `ns` of groups, includes, nodes and tests. A private name (`~…`) is an error, because
roslaunch stops with a traceback. Other characters than letters, digits, `_` and `/` are warnings: roslaunch takes them and C++ nodes do
not. They are an info where no node is started in the namespace, or only Python nodes are (executables that end in `.py`), which run. A
digit at the start is an info, told once for all files: nodes run there, but a name such as `1st/scan` that one of them is given is refused.

## Why it matters

C++ nodes end with an invalid-name exception. Python nodes end up under names that other nodes and tools refuse.

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

from launchlint.evaluate.problems import InvalidNamespace
from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS, fix, is_literal, set_value, spot
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView, of_ros2

RULE = Rule("LL314", "invalid-namespace", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: InvalidNamespace, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``invalid-namespace`` (rosgraph.names.make_global_ns, roscpp's names::validate)."""
    if of_ros2(view):
        from launchlint.rules.judging import ros2_names as ros2_words

        yield from ros2_words.namespace(problem, RULE)
        return
    namespace = problem.namespace
    if problem.private:
        base = namespace.lstrip("~/")
        yield RULE.at(
            problem.origin, f"the namespace {namespace} is private", label="~ stands for a node's own namespace",
            notes=(f"roslaunch stops with: cannot turn [{namespace}] into a global name",),
            help=f'write ns="{base}"' if base else "write the namespace without ~",
            fix=_fix(problem, view, base, LOADS),
        )  # fmt: skip
        return
    good = re.sub(r"[^\w/]", "_", namespace.strip(), flags=re.ASCII)
    bare = good.lstrip("/")
    digit = good == namespace and bare[:1].isdigit()
    good = f"n_{good}" if good[:1].isdigit() else good
    sufferers = _started_in(problem, view)
    if digit and namespace.startswith("/"):
        return  # a global name may go on with a digit
    if digit:
        note = f"nodes start in it, but C++ nodes end with an invalid-name exception when they are given a name such as {namespace}/scan"
    elif sufferers:
        note = "roslaunch takes it, but C++ nodes in it end at start with an invalid-name exception"
    elif sufferers is None:
        note = "roslaunch takes it, and no node is started in it; a C++ node that asks for a name in it ends with an invalid-name exception"
    else:
        note = (
            "roslaunch and the Python nodes in it take it, but a C++ node that uses one of their names ends with an invalid-name exception"
        )
    yield RULE.at(
        problem.origin, f"the namespace {namespace!r} is not a valid ROS name",
        severity=Severity.WARNING if sufferers and not digit else Severity.INFO, label="invalid",
        notes=(note,),
        help=f"use letters, digits, _ and /, a letter first: {good}",
        fix=_fix(problem, view, good, f"the namespace is {good}"),
        cause="digit" if digit else "",
    )  # fmt: skip


def _started_in(problem: InvalidNamespace, view: LaunchView) -> bool | None:
    """Whether anything but Python nodes may be started in the namespace that ``problem`` is about; None where nothing is."""
    at = spot(view, problem.place)
    if at is None:
        return True
    return view.started_in.get((at.source.path, at.element.span.start))


def _fix(problem: InvalidNamespace, view: LaunchView, namespace: str, changes: str) -> Fix | None:
    if not namespace or not is_literal(problem.place, problem.namespace):
        return None
    return fix(f'write ns="{namespace}"', set_value(spot(view, problem.place), namespace), safe=False, changes=changes)

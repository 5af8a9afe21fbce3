"""Something that older versions of ROS knew and that has no place in a launch file any more.

The `<master>` tag (roslaunch starts a master by itself), the `ros-root`, `ros-package-path`, `ros-ip` and
`ros-hostname` attributes and the `<env>` children of a `<machine>`, the `ns` attribute of `<rosparam>` (it is called
`param` now), and the program `xacro.py`, which ROS Noetic does not have.

## Why it matters

Some are ignored, some still work, some make roslaunch refuse the file: none does what the author once relied on.

## Example

```xml
<launch>
  <master auto="start"/>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```

## Fix

`--fix` removes `<master>` and attributes that are empty, and writes `param` for the `ns` of a `<rosparam>`: nothing changes, which is
proved before it is done. It writes `xacro` for `xacro.py`: the command is another one then. `--unsafe-fixes` removes attributes of
`<machine>` that roslaunch refuses.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.problem import Problem
from launchlint.rules.edits import LOADS, fix, remove_attribute, remove_element, rename_attribute, replace, spot
from launchlint.rules.rule import Rule

RULE = Rule("LL111", "deprecated-construct", Severity.WARNING, fixable="safe")


STOPS = "roslaunch stops with: <machine>: {} not supported since ROS Fuerte."
SCRIPT = "set the environment in a script and name that in env-loader"

# Construct → message, note, help; the attributes of <machine> are all alike.
WORDS = {
    "<master>": (
        "<master> has no effect",
        "roslaunch ignores it since ROS Fuerte, and says so",
        "remove it: roslaunch starts a master by itself",
    ),
    "rosparam ns": (
        "ns on <rosparam> is the old name of param",
        "both still work, and are joined where both are given",
        "write param instead of ns",
    ),
    "xacro.py": (
        "ROS Noetic has no xacro.py",
        "the command is not found there, and the parameter that it fills cannot be set",
        "write xacro instead, which ROS Kinetic and Melodic have too",
    ),
    "machine env": ("<machine> takes no <env>", STOPS.format("<env> tag is"), SCRIPT),
}


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Say what has taken its place; facts: ``construct``, ``instead``."""
    construct: str = problem.facts["construct"]
    attribute = construct.partition(" ")[2]
    machine = (f"<machine> takes no {attribute} any more", STOPS.format("ros-* attributes are"), SCRIPT)
    message, note, advice = WORDS.get(construct, machine)
    if construct.startswith("machine") and not problem.refused:
        note = "not supported since ROS Fuerte"
    severity = Severity.ERROR if problem.refused else Severity.INFO if construct == "rosparam ns" else Severity.WARNING
    yield RULE.at(
        problem.origin, message, severity=severity, label="out of date", notes=(note,), help=advice, fix=_fix(construct, problem, view)
    )


def _fix(construct: str, problem: Problem, view: object) -> Fix | None:
    at = spot(view, problem.place)
    if construct == "<master>":
        return fix("remove it", remove_element(at), safe=True)
    if construct == "rosparam ns":
        return fix("write param", rename_attribute(at, "param"), safe=True)
    if construct == "xacro.py":
        return fix("write xacro", replace(at, problem.place, "xacro"), safe=True, changes="the command is xacro")
    if construct == "machine env" or at is None or at.attribute is None:
        return None
    if not at.attribute.value:
        return fix(f"remove {at.attribute.name}", remove_attribute(at), safe=True)
    return fix(f"remove {at.attribute.name}", remove_attribute(at), safe=False, changes=LOADS)

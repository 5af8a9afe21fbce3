"""A node is to run on a machine that no `<machine>` tag defines.

What it does: it compares the `machine` of every node and test with the machines of the whole launch. A machine may be defined
after the node that uses it, and in any included file. Where the launch defines no machine at all it is a warning. It is an info there
where the file may be made to be included: its name ends with `.xml`, it lies below a directory `include` or `includes`, or another launch
file of the workspace defines that machine. Where the launch is not known as a whole, because a file of it is
not here or a condition cannot be worked out, the machine may be defined there, and nothing is told.

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

## Fix

`--unsafe-fixes` writes the machine with the most similar name.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import UnknownMachine
from launchlint.finding import Finding, Fix, Severity
from launchlint.model import Launch
from launchlint.rules.edits import fix, is_literal, set_value, spot
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Place
from launchlint.spelling import closest, did_you_mean

RULE = Rule("LL306", "unknown-machine", Severity.ERROR, roslaunch="reports", fixable="unsafe")
_OF_PARTS = frozenset(("include", "includes"))
_DEFINE = frozenset(("machine", "group", "include"))


def check(view: LaunchView) -> Iterator[Fine]:
    """Say of each node whose machine is, or may be, defined here that it is in order: its file may well be made to be included."""
    launch = view.launch
    told: set[Place] = set()
    if not _may_be_elsewhere(launch):
        told.update(problem.place for problem in launch.noticed(UnknownMachine))
    for node in (*launch.nodes, *launch.tests):
        place = node.places.get("machine")
        if place is not None and place not in told:
            yield RULE.fine(place)


def tell(problem: UnknownMachine, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``unknown-machine`` (roslaunch.config.ROSLaunchConfig._select_machine)."""
    name, known = problem.name, problem.known
    if _may_be_elsewhere(view.launch):
        return
    entry = view.launch.entry
    fragment = entry.path.endswith(".xml") or not _OF_PARTS.isdisjoint(entry.path.split("/")[:-1])
    certain = bool(known) or view.declared_entry
    whole = None if certain else view.packages.machine_defined_in(name)
    yield RULE.at(
        problem.origin,
        f"there is no machine {name}",
        severity=None if certain else Severity.INFO if fragment or whole is not None else Severity.WARNING,
        label="not defined",
        notes=(
            f"roslaunch stops with: ERROR: unknown machine [{name}]",
            f"defined are: {', '.join(known)}" if known else "no machine is defined: this works only where the including file defines it",
            *(
                []
                if whole is None
                else [f"{shown(whole, root_of(entry))} defines one of that name: this may be a part of what starts there"]
            ),
        ),
        help=did_you_mean(name, known) or f'define it: <machine name="{name}" address="…"/>',
        fix=_fix(problem, view, name, closest(name, known)),
        cause="" if known else f"no machine {name}, {fragment or whole is not None}",
    )


def _fix(problem: UnknownMachine, view: LaunchView, name: str, near: str | None) -> Fix | None:
    if near is None or not is_literal(problem.place, name):
        return None
    return fix(f"write {near}", set_value(spot(view, problem.place), near), safe=False, changes=f"the node runs on {near}")


def _may_be_elsewhere(launch: Launch) -> bool:
    """Whether machines may be defined where nobody can look: in a file that is not here, or under a condition of unknown value."""
    unknown = (branch for branch in launch.branches if branch.taken is None and branch.attribute == "unless")
    return not launch.complete or any(branch.tag in _DEFINE for branch in unknown)

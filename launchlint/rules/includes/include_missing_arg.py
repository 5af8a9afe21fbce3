"""An `<include>` does not pass an arg that the included file needs.

What it does: it looks for args that the included file declares without a default, reads in this configuration, and does
not get. An arg with `default=""` counts as one without a default where roslaunch refuses the included file with the empty
value: that is told once, at the include, and not at each place that breaks. With `pass_all_args` all the way it is an
info: the arg may be given on the command line. What several includes of one file leave out alike is told once.

## Why it matters

roslaunch refuses the whole launch.

## Example

```xml
<launch>
  <include file="$(dirname)/camera.launch"/>
</launch>
```

```xml camera.launch
<launch>
  <arg name="device"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera">
    <param name="video_device" value="$(arg device)"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/camera.launch">
    <arg name="device" value="/dev/video0"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <arg name="device"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera">
    <param name="video_device" value="$(arg device)"/>
  </node>
</launch>
```

## Fix

`--unsafe-fixes` passes the arg on where the including file has one of that name.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import IncludeMissingArg
from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS, append_child, fix, spot
from launchlint.rules.judging.broken_call import lacking_call
from launchlint.rules.judging.joined import alike, joined
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView, of_ros2
from launchlint.source import Origin
from launchlint.spelling import closest

RULE = Rule("LL404", "include-missing-arg", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: IncludeMissingArg, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``include-missing-arg`` (roslaunch.xmlloader._include_tag)."""
    if of_ros2(view):
        from launchlint.rules.judging import ros2_args as ros2_words

        yield from ros2_words.missing(problem, RULE, view)
        return
    file, passed = problem.file, problem.passed
    together = view.beside(problem)
    names = list(dict.fromkeys(each.name for each in together)) or [problem.name]
    if problem.name != names[0]:
        return  # told with the first
    if len(names) > 1:
        yield _several(names, together, view)
        return
    name = names[0]
    near = closest(name, passed)
    help = f'add <arg name="{name}" value="…"/> inside the include, or give it a default in {file}'
    notes = [f"roslaunch stops with: included file [{file}] requires the '{name}' arg to be set"]
    if problem.empty:
        notes = [f"roslaunch refuses {file} with the empty default of {name}"]
    given = problem.pass_all and not view.declared_entry and _all_pass_on(problem.origin, view)
    if given:
        notes.append(f"pass_all_args passes it on where it is given on the command line: {name}:=…")
    yield RULE.at(
        problem.origin,
        f"{file} needs the arg {name}, which is not passed",
        severity=Severity.INFO if given and near is None else None,
        label="included without it",
        related=problem.related,
        notes=tuple(notes),
        help=f"is {near}, which is passed, meant to be {name}? Else {help}" if near is not None else help,
        topic=name,
        shared_cause=lacking_call(file),
        fix=_fix(problem, view, name) if near is None and not given else None,
    )


def _several(names: list[str], problems: list[IncludeMissingArg], view: LaunchView) -> Finding:
    """All that one include leaves out."""
    first = problems[0]
    file, passed = first.file, first.passed
    listed = ", ".join(names)
    slips = [f"{near} to be {name}" for name in names if (near := closest(name, passed)) is not None]
    given = first.pass_all and not view.declared_entry and _all_pass_on(first.origin, view)
    add = f'add <arg name="…" value="…"/> for each inside the include, or give them defaults in {file}'
    return RULE.at(
        first.origin,
        f"{file} needs the args {listed}, which are not passed",
        severity=Severity.INFO if given and not slips else None,
        label="included without them",
        related=tuple(dict.fromkeys(each for problem in problems for each in problem.related)),
        notes=(f"roslaunch stops at one of them with: included file [{file}] requires the '…' arg to be set",),
        help=f"is {', and '.join(slips)} meant? Else {add}" if slips else add,
        topic=listed,
        shared_cause=lacking_call(file),
    )


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for the includes of one file that leave out the same: whoever wrote it did not know of the arg."""
    for several in alike(findings, lambda each: (each.location.path, each.topic)):
        yield joined(several) if len(several) > 1 else several[0]


def _fix(problem: IncludeMissingArg, view: LaunchView, name: str) -> Fix | None:
    """An arg of the same name in the including file is passed on."""
    source, step = problem.place.source, problem.origin.step
    own = (each for each in view.launch.declared if each.name == name and not each.passed and not each.in_group)
    if not any(each.origin.place.source is source and each.origin.step == step for each in own):
        return None
    child = f'<arg name="{name}" value="$(arg {name})"/>'
    return fix(f"pass {name} on", append_child(spot(view, problem.place), child), safe=False, changes=LOADS)


def _all_pass_on(origin: Origin, view: LaunchView) -> bool:
    """Whether what is given on the command line gets as far as the include at ``origin``."""
    passing = {include.origin.place for include in view.launch.includes if include.pass_all_args}
    return all(place in passing for place in origin.chain)

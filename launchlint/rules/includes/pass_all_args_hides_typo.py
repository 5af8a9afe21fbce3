"""An include with `pass_all_args` gives an arg that nothing below it knows.

What it does: with `pass_all_args="true"` roslaunch no longer checks the args of an include. It speaks where an explicit `<arg>`
is neither declared nor mentioned in the included file and all that it includes. What is given one included file for nothing
is told once, but for each arg that is nearly one that it takes, and so is what one file gives several.

## Why it matters

A mistyped arg is taken without a word, and the included file goes on with its default.

## Example

```xml
<launch>
  <include file="$(dirname)/camera.launch" pass_all_args="true">
    <arg name="frame_rat" value="15"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <arg name="frame_rate" default="30"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera">
    <param name="framerate" value="$(arg frame_rate)"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/camera.launch" pass_all_args="true">
    <arg name="frame_rate" value="15"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <arg name="frame_rate" default="30"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera">
    <param name="framerate" value="$(arg frame_rate)"/>
  </node>
</launch>
```

## Fix

`--unsafe-fixes` passes the most similar arg that is known there, where it is not passed yet.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import PassAllHidesTypo
from launchlint.finding import Finding, Severity
from launchlint.model import Include
from launchlint.rules.edits import passed_under
from launchlint.rules.judging.passed_for_nothing import about, of_one_file, of_several_files, said
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin
from launchlint.spelling import closest

RULE = Rule("LL405", "pass-all-args-hides-typo", Severity.WARNING, fixable="unsafe")


def tell(problem: PassAllHidesTypo, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``pass-all-hides-typo`` (roslaunch.loader.LoaderContext.include_child, ``pass_all_args``)."""
    name, file, known = problem.name, problem.file, problem.known
    include = _include_around(problem.origin, view)
    if include is None:
        return
    below = [each for each in view.launch.includes if _is_below(each, include)]
    if any(each.source is None for each in below):
        return
    word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    if any(word.search(each.source.text) for each in (include, *below) if each.source is not None):
        return
    near = closest(name, known)
    yield RULE.at(
        problem.origin,
        said([file], [name]),
        label="passed for nothing",
        notes=("pass_all_args turns off roslaunch's check of the args that are passed",),
        help=f"did you mean {near}?" if near is not None else "remove it, or declare it there",
        fix=passed_under(view, problem.place, name, near),
        cause=file if near is None else f"{file} {name}",
        about=about(name, file, near),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """All that is passed to one file for nothing, by the names of the args."""
    return of_one_file(findings)


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for what one file passes to several for nothing."""
    return of_several_files(findings)


def _include_around(origin: Origin, view: LaunchView) -> Include | None:
    """The include whose ``<arg>`` stands at ``origin``: the last one of the same file and way in that begins before it."""
    at, source = origin.place.span.start, origin.place.source
    same = [each for each in view.launch.includes if each.origin.place.source is source and each.origin.step == origin.step]
    above = [each for each in same if each.origin.place.span.start < at]
    return max(above, key=lambda each: each.origin.place.span.start, default=None)


def _is_below(include: Include, above: Include) -> bool:
    chain = (*above.origin.chain, above.origin.place)
    return include.origin.chain[: len(chain)] == chain

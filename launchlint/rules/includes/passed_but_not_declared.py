"""An `<include>` passes an arg that the included file neither declares nor reads, nor anything that is executed after it.

What it does: it looks for the name in the included file, in all that this one includes, and in all that comes after the include, since
what is passed stays set. Where a launch file in Python is among what is included, it may read anything, and nothing is said.
What one file passes to several others, none of which knows it, is told once.

## Why it matters

`ros2 launch` takes any name without a word: the included file goes on with its default.

## Example

```xml main.launch.xml
<launch>
  <push_ros_namespace namespace="front"/>
  <include file="$(dirname)/camera.launch.xml">
    <arg name="frame_rat" value="15"/>
  </include>
</launch>
```

```xml camera.launch.xml
<launch>
  <arg name="frame_rate" default="30.0"/>
  <node pkg="usb_cam" exec="usb_cam_node_exe" name="camera">
    <param name="framerate" value="$(var frame_rate)"/>
  </node>
</launch>
```

## Use instead

```xml main.launch.xml
<launch>
  <push_ros_namespace namespace="front"/>
  <include file="$(dirname)/camera.launch.xml">
    <arg name="frame_rate" value="15.0"/>
  </include>
</launch>
```

```xml camera.launch.xml
<launch>
  <arg name="frame_rate" default="30.0"/>
  <node pkg="usb_cam" exec="usb_cam_node_exe" name="camera">
    <param name="framerate" value="$(var frame_rate)"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from launchlint.evaluate.ros2.problems import PassedForNothing
from launchlint.finding import Finding, Severity
from launchlint.plural import listed
from launchlint.rules.judging.joined import alike, joined
from launchlint.rules.rule import Rule
from launchlint.spelling import closest

RULE = Rule("LL913", "passed-but-not-declared", Severity.WARNING)
_MOST_NAMED = 6
_MOST_FILES = 3


def tell(problem: PassedForNothing, view: object) -> Iterator[Finding]:
    """Say which arg is passed for nothing (launch.actions.IncludeLaunchDescription sets whatever it is given)."""
    name, file = problem.name, problem.file
    near = closest(name, problem.known)
    if near is None and not problem.certain:
        return
    yield RULE.at(
        problem.origin,
        _said([file], [name]),
        label="passed for nothing",
        notes=("ros2 launch sets whatever an include passes, and does not ask whether the file declares it",),
        help=f"did you mean {near}?" if near is not None else "remove it, or declare it there",
        topic=name,
        cause=file if near is None else f"{file} {name}",
        about=(near or "", file, name),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """All that is passed to one file for nothing, by the names of the args."""
    told = joined(findings)
    near, file, *_ = told.about
    names = list(dict.fromkeys(name for each in findings for name in each.about[2:]))
    if len(names) < 2:
        return told
    return told._replace(message=_said([file], names), help="remove them, or declare them there", about=(near, file, *names))


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for what one file passes to several for nothing: of each of these, the arg that most of them are given."""
    given = Counter((each.location.path, each.about[0], name) for each in findings for name in each.about[2:])

    def common(finding: Finding) -> tuple[str, str, str]:
        path, (near, _, *names) = finding.location.path, finding.about
        return max(((path, near, name) for name in names), key=lambda each: (given[each], each))

    for several in alike(findings, common):
        told = joined(several) if len(several) > 1 else several[0]
        files = list(dict.fromkeys(each.about[1] for each in several))
        if len(files) > 1:
            differ = len({frozenset(each.about[2:]) for each in several}) > 1
            said = _said(files, [common(told)[2]] if differ else told.about[2:])
            told = told._replace(message=f"{said}, or others that it is given" if differ else said)
        yield told


def _said(files: Sequence[str], names: Sequence[str]) -> str:
    """What is wrong: none of ``files`` has anything that knows the args ``names``."""
    *most, last = files
    where = f"{', '.join(most)} or {last}" if most and len(files) <= _MOST_FILES else listed(files, _MOST_FILES)
    return f"nothing in {where} knows the arg{'s' if len(names) > 1 else ''} {listed(names, _MOST_NAMED)}"

"""A tag, attribute or substitution of ROS 2 stands in a ROS 1 launch file, or the other way round.

`exec` and `namespace` of a `<node>`, `<let>`, `<push-ros-namespace>`, `$(var …)` and `$(find-pkg-share …)` belong to
the launch files of ROS 2, which look much the same.

In a ROS 2 launch file, these are `type`, `ns`, `required` and `doc`, `<rosparam>` and `<machine>`, `$(arg …)`, `$(find …)` and
`$(optenv …)`: launch refuses the file.

Where a launch file of ROS 1 includes one that is for ROS 2, by its words and by how its package is built, that is told at the include, and
nothing of what roslaunch makes of the included file.

## Why it matters

roslaunch skips the tags and attributes that it does not know, with a warning: so does launchlint. It refuses the substitutions, and a
node with `exec` in place of `type`: these are errors.

## Example

```xml
<launch>
  <arg name="map" default="office"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(var map).yaml"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <arg name="rate" default="10"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker" ns="robot">
    <param name="rate" value="$(arg rate)"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="map" default="office"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <arg name="rate" default="10"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker" namespace="robot">
    <param name="rate" value="$(var rate)"/>
  </node>
</launch>
```

## Fix

In ROS 2, `--fix` writes `exec` for `type`, `namespace` for `ns`, `description` for `doc`, `$(var …)` for `$(arg …)`, `$(find-pkg-share …)`
for `$(find …)` and `$(env …)` for `$(optenv …)`.

In ROS 1, `--unsafe-fixes` writes `type` for `exec`, `ns` for `namespace`, `args` for `ros_args`, `doc` for `description`, `$(arg …)` for
`$(var …)` and `$(find …)` for `$(find-pkg-share …)`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Fix, Related, Severity
from launchlint.plural import listed
from launchlint.rules.edits import LOADS, LOADS2, Edits, fix, rename_attribute, replace, spot, write_over
from launchlint.rules.judging.joined import joined
from launchlint.rules.rule import Rule
from launchlint.source import Origin, Place, Span
from launchlint.syntax.parts import Substitution
from launchlint.syntax.problems import WrongDialect
from launchlint.syntax.ros1.substitutions import parse
from launchlint.syntax.ros2.problems import OfRos1

MOST_NAMED = 5
_SAME = {"var": "arg", "find-pkg-share": "find"}

RULE = Rule("LL112", "wrong-dialect", Severity.ERROR, roslaunch="refuses", fixable="safe")


def tell(problem: WrongDialect | OfRos1, view: object) -> Iterator[Finding]:
    """Give the way of ROS 1, or that of ROS 2."""
    if isinstance(problem, OfRos1):
        yield _ros2(problem)
        return
    what, construct, instead = problem.what, problem.construct, problem.instead
    if what == "tag":
        message, note = f"<{construct}> is a tag of ROS 2", "roslaunch (ROS 1) prints a warning and skips it, with all that it contains"
    elif what == "attribute":
        message = f"{construct} is an attribute of ROS 2"
        dropped = "roslaunch (ROS 1) prints a warning and drops it"
        note = f"{dropped}, and then misses the attribute it needs instead" if problem.refused else dropped
    else:
        message, note = f"{construct} is a substitution of ROS 2", "roslaunch (ROS 1) stops with: Unknown substitution command"
    yield RULE.at(
        problem.origin,
        message,
        severity=None if problem.refused else Severity.WARNING,
        label="ROS 2",
        notes=(note,),
        help=f"in ROS 1: {instead}" if instead else "ROS 1 has nothing like it: remove it",
        fix=_fix(problem, view),
    )


def included(include: Origin, file: str, finding: Finding) -> Finding:
    """That an include of a launch file of ROS 1 leads to ``file``, which is for ROS 2, so that roslaunch comes upon ``finding`` in it."""
    return RULE.at(
        include,
        f"{file} is a launch file of ROS 2",
        severity=finding.severity,
        label="includes it in ROS 1",
        notes=(*(note for note in finding.notes if note.startswith("roslaunch ")), "nothing else is said of what roslaunch makes of it"),
        help="include a launch file of ROS 1, or write this one for ros2 launch",
        topic=file,
    )


def _fix(problem: WrongDialect, view: object) -> Fix | None:
    """What has another name in ROS 1 and means the same gets that."""
    what, instead, place = problem.what, problem.instead, problem.place
    at = spot(view, place)
    if what == "attribute" and instead.isidentifier():
        return fix(f"write {instead}", rename_attribute(at, instead), safe=False, changes=LOADS)
    written = parse(place.text).alone if what == "substitution" else None
    if isinstance(written, Substitution) and written.command in _SAME and written.only:
        text = f"$({_SAME[written.command]} {written.only})"
        return fix(f"write {text}", replace(at, place, text), safe=False, changes=LOADS)
    return None


def _ros2(problem: OfRos1) -> Finding:
    what, construct, instead = problem.what, problem.construct, problem.instead
    shown = {"tag": f"<{construct}>", "attribute": construct, "substitution": f"$({construct} …)"}[what]
    word = {"tag": "a tag", "attribute": f"an attribute of <{problem.tag}>", "substitution": "a substitution"}[what]
    return RULE.at(
        problem.origin,
        f"{shown} is {word} in ROS 1",
        label="ROS 1",
        notes=("ros2 launch refuses the file",),
        help="in ROS 2: $(env NAME '')"
        if construct == "optenv" and " " not in problem.words
        else f"in ROS 2: {instead}"
        if instead
        else "ROS 2 has nothing like it: remove it",
        fix=fix(f"write {problem.renamed}", _renamed(problem), safe=True, changes=LOADS2) if problem.renamed else None,
        cause=problem.place.source.path,
        topic=shown,
    )


def together(findings: Sequence[Finding]) -> Finding:
    """All that is left of ROS 1 in one file."""
    told = joined(findings)
    shown = list(dict.fromkeys(each.topic for each in findings))
    if len(shown) == 1:
        return told
    elsewhere = {each.location: Related(each.location, f"{each.message}; {each.help}") for each in findings}
    return told._replace(
        message=f"{shown[0]} is of ROS 1, and so {'is' if len(shown) == 2 else 'are'} {listed(shown[1:], MOST_NAMED)} in this file",
        related=tuple(elsewhere.get(each.location, each) for each in told.related),
    )


def _renamed(problem: OfRos1) -> Edits:
    """The new name in place of the old one. ``$(optenv A)`` gives nothing where there is no such variable, and ``$(env A)`` refuses."""
    source, span = problem.place
    name, words = problem.construct, problem.words.split(" ")
    if problem.what != "substitution":
        return write_over(problem.place, name, problem.renamed)
    if not all(words) or len(words) != (2 if name == "optenv" else 1) or "$" in problem.words:
        return ()
    start = span.start + len("$(")
    return write_over(Place(source, Span(start, start + len(name))), name, problem.renamed)

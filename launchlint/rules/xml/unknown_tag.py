"""An element has a tag that roslaunch does not know.

The tags of roslaunch are few, and letter case matters: `<Node>` is not `<node>`. What stands inside an unknown
element is skipped with it.

## Why it matters

roslaunch starts everything else, and its warning scrolls by with the rest of the output (inside `<param>`, `<arg>`
and other tags that take no children there is not even a warning). The node or parameter that was meant is simply
missing on the robot.

A known tag with a letter, a mark or a word like `off` put to it (`<xnode>`, `<_node>`, `<DISABLED_node>`) has been
switched off by somebody: that is an info, without a fix. A tag that is like no other, holds none that roslaunch knows and stands in three
places or more is a custom of the house, for a program that reads it (rtmlaunch reads `<rtconnect>`): one info for all of them.
One with words in it and nothing else, without attributes, is a remark for readers or for a tool that makes documentation: an info, too.

In ROS 2, launch refuses the file, even where the tag stands under a condition that is false: that is an error. A tag that is like no
other may be one that an installed package brings (`<gz_server>`): where it stands among actions, that is an info. So is one that a package
of the workspace brings, by `@expose_action` and the entry point `launch.frontend.launch_extension`.

## Example

```xml
<launch>
  <nodes pkg="map_server" type="map_server" name="map_server"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <parm name="rate" value="10"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param name="rate" value="10"/>
  </node>
</launch>
```

## Fix

`--fix` writes the tag that the name is one slip away from (`<nodes>` becomes `<node>`), where there is only one; a name that is further
off takes `--unsafe-fixes`. What the element says takes effect then: the node is started, the parameter set.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.dialects.ros1 import DIALECT as ROS1_DIALECT
from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS2, Spot, fix, rename_tag, spot, write_over
from launchlint.rules.judging.joined import joined
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView, LaunchView
from launchlint.source import Place
from launchlint.spelling import closest, surely, switched_off
from launchlint.syntax.problems import UnknownTag
from launchlint.syntax.ros1.dialect import TAGS
from launchlint.syntax.ros2.problems import UnknownAction
from launchlint.syntax.tree import Element
from launchlint.workspace.ament.extensions import brought_by

RULE = Rule("LL103", "unknown-tag", Severity.WARNING, roslaunch="reports", fixable="safe")

_CUSTOM = 3
"""Places in which a tag of nobody's is no slip any more: nobody makes one slip of many letters three times."""


def tell(problem: UnknownTag | UnknownAction, view: object) -> Iterator[Finding]:
    """Name the tag that was meant."""
    if isinstance(problem, UnknownAction):
        yield _ros2(problem, view)
        return
    tag, parent, known = problem.tag, problem.parent, problem.known
    ignored: bool = problem.ignored
    off = switched_off(tag, known)
    if off is not None:
        yield RULE.at(
            problem.origin,
            f"there is no tag <{tag}>, so that this <{off}> is switched off",
            severity=Severity.INFO,
            label="skipped",
            help=f'if that is meant, put the <{off}> into a comment, or give it if="false"; else remove what stands around the name',
        )
        return
    near = closest(tag, known)
    at = spot(view, problem.place)
    remark = bool(known) and near is None and at is not None and _is_remark(at.element)
    if near is not None:
        advice = f"did you mean <{near}>?"
    elif known:
        advice = f"<{parent}> takes {', '.join(f'<{name}>' for name in known if name != 'master')}"
    else:
        advice = f"<{parent}> takes no elements: remove it"
    said = "roslaunch skips it without a word" if ignored else "roslaunch prints a warning and skips it, with all that it contains"
    yield RULE.at(
        problem.origin,
        f"there is no tag <{tag}>",
        severity=Severity.INFO if remark else None,
        label="skipped",
        notes=(said,),
        help="put it into a comment, which roslaunch skips silently" if remark else advice,
        fix=None if near is None else _fix(near, sure=surely(tag, known) == near, at=at),
        cause=f"tag {tag}" if near is None and at is not None and not _holds_known(at.element) else "",
    )


def together(findings: Sequence[Finding]) -> Finding:
    """What one tag without a meaning comes to in several places."""
    told = joined(findings)
    places = {finding.location for finding in findings}
    if len(places) < _CUSTOM or told.launcher != ROS1_DIALECT.launcher:
        return told
    note = f"it stands in {len(places)} places: a custom of the house, for a program that reads it"
    return told._replace(
        severity=Severity.INFO, notes=(*told.notes, note), help="put such words into a comment, which roslaunch skips silently"
    )


def _is_remark(element: Element) -> bool:
    """Whether it holds words and nothing else: a tag for a tool that makes documentation of launch files."""
    return bool(element.text.strip()) and not element.children and not element.attributes


def _holds_known(element: Element) -> bool:
    """Whether anything in it would have had an effect."""
    waiting = list(element.children)
    while waiting:
        each = waiting.pop()
        if each.tag in TAGS:
            return True
        waiting += each.children
    return False


def _fix(near: str, *, sure: bool, at: Spot | None) -> Fix | None:
    changes = f"what the <{near}> says takes effect"
    return fix(f"make it <{near}>", rename_tag(at, near), safe=sure, changes=changes)


def _ros2(problem: UnknownAction, view: object) -> Finding:
    tag, parent, known, place = problem.tag, problem.parent, problem.known, problem.place
    brings = None if problem.child or not isinstance(view, (FileView, LaunchView)) else brought_by(view.packages).get(tag)
    if brings is not None:
        return RULE.at(
            problem.origin,
            f"the action {tag} of the package {brings} is not understood",
            severity=Severity.INFO,
            label="not looked into",
            notes=("ros2 launch knows it where that package is installed; what it starts or sets is not known here",),
            help=f"see to it that {brings} is installed where this is launched",
            topic=tag,
            cause=f"tag {tag}",
        )
    near = closest(tag, known)
    foreign = near is None and not problem.child
    if near is not None:
        advice = f"did you mean {near}?"
    elif foreign:
        advice = "install the package that brings it where this is launched; else remove it"
    else:
        advice = f"{parent} takes {', '.join(known)}" if known else f"{parent} takes nothing inside: remove it"
    edits = () if near is None else rename_tag(spot(view, place), near) or (write_over(place, tag, near) if _is_key(place) else ())
    return RULE.at(
        problem.origin,
        f"there is no action {tag}" if not problem.child else f"{parent} has nothing inside that is called {tag}",
        severity=Severity.INFO if foreign else Severity.ERROR,
        label="unknown to launch",
        notes=("ros2 launch refuses the file, unless an installed package adds this tag" if foreign else "ros2 launch refuses the file",),
        help=advice,
        fix=None if near is None else fix(f"make it {near}", edits, safe=surely(tag, known) == near, changes=LOADS2),
        cause=f"tag {tag}" if foreign else "",
    )


def _is_key(place: Place) -> bool:
    """Whether a key of YAML stands there, and no tag of XML."""
    return not place.source.text.endswith("<", 0, place.span.start)

"""An element stands inside one that does not take it.

A `<remap>` in an `<include>`, a `<node>` in a `<node>`, an `<arg>` in a `<node>`: the tag exists, and roslaunch skips
it there, with all that it contains. What stands wrongly in one element is told at once, and so is what does in all includes of a file.

## Why it matters

The setting looks as if it worked. Inside nodes and includes roslaunch prints a warning among its other output; inside
`<param>`, `<arg>`, `<remap>`, `<env>` and `<rosparam>` it says nothing.

In ROS 2, launch refuses the file: that is an error.

## Example

```xml
<launch>
  <include file="$(dirname)/camera.launch">
    <remap from="image" to="image_raw"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <remap from="chatter" to="talk"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker"/>
</launch>
```

## Use instead

```xml
<launch>
  <group>
    <remap from="image" to="image_raw"/>
    <include file="$(dirname)/camera.launch"/>
  </group>
</launch>
```

```xml camera.launch
<launch>
  <node pkg="usb_cam" type="usb_cam_node" name="camera"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <set_remap from="chatter" to="talk"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker"/>
</launch>
```

"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.joined import joined
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView
from launchlint.syntax.problems import MisplacedTag
from launchlint.syntax.ros1.dialect import TAGS
from launchlint.syntax.ros2.problems import MisplacedEntity

RULE = Rule("LL106", "misplaced-tag", Severity.WARNING, roslaunch="reports")
SKIPPED = "skipped"
MOST_NAMED = 6
_MOST_ALIKE = 20
"""Elements by which a copy is recognised; each finding carries them."""


def tell(problem: MisplacedTag | MisplacedEntity, view: object) -> Iterator[Finding]:
    """Say where the tag belongs."""
    if isinstance(problem, MisplacedEntity):
        yield _ros2(problem)
        return
    tag, parent = problem.tag, problem.parent
    reported: bool = problem.reported
    said = "roslaunch prints a warning and skips it, with all that it contains" if reported else "roslaunch skips it without a word"
    yield RULE.at(
        problem.origin,
        f"<{tag}> has no effect inside <{parent}>",
        severity=Severity.ERROR if problem.refused else None,
        label=f"<{tag}> {problem.name} is {SKIPPED}" if problem.name else SKIPPED,
        notes=(said,),
        help=_advice(tag, parent),
        cause=_cause(problem, view),
        about=(parent, f"<{tag}> {problem.name}" if problem.name else ""),
    )


def _cause(problem: MisplacedTag, view: object) -> str:
    """One for all that stands wrongly in one element, and in its copies in other files, in which the same stands.

    All includes of a file count as one element: who believes that one takes a param believes it of the next.
    """
    place = problem.place
    around = view.document.element_from(problem.within) if isinstance(view, FileView) and problem.within >= 0 else None
    if around is None or around.span.start != problem.within or len(around.children) > _MOST_ALIKE:
        return f"{place.source.path}:{problem.within} {problem.refused}"
    rule = TAGS.get(around.tag)
    alike = [around]
    if around.tag == "include" and isinstance(view, FileView):
        alike = list(islice((each for each in view.document.elements if each.tag == "include"), _MOST_ALIKE))
    inside = (f"{each.tag} {each.get('name') or each.get('from') or ''}" for one in alike for each in one.children[:_MOST_ALIKE])
    wrong = [each for each in inside if rule is None or each.partition(" ")[0] not in rule.children]
    return f"{problem.parent} {problem.refused} {'; '.join(wrong)}"


def together(findings: Sequence[Finding]) -> Finding:
    """All that stands wrongly in one element: how much, what, and what to do about each kind."""
    if not all(finding.about for finding in findings):  # of ROS 2
        return joined(findings)
    findings = sorted(findings, key=lambda finding: (finding.location.path, finding.location.start))
    first = joined(findings)
    own = [finding for finding in findings if finding.location.path == first.location.path]
    files = {finding.location.path for finding in findings}
    named = [finding.about[1] or f"<{finding.element}>" for finding in own]
    parent = f"<{first.about[0]}>"
    more = f" and {len(named) - MOST_NAMED} more" if len(named) > MOST_NAMED else ""
    what = f"{len(own)} elements have no effect inside {parent}: {', '.join(named[:MOST_NAMED])}{more}"
    if len(own) == 1:
        what = f"{named[0]} has no effect inside {parent}"
    copies = "" if len(files) == 1 else f" (and in {len(files) - 1} more file{'s' if len(files) > 2 else ''})"
    return first._replace(
        message=f"{what}{copies}",
        label=own[0].label,
        help="; ".join(dict.fromkeys(finding.help for finding in findings)),
    )


def _advice(tag: str, parent: str) -> str:
    rule = TAGS.get(tag) or TAGS.get(tag.lower())
    if parent == "include" and tag.lower() == "param":
        return (
            "write <arg> if the included file declares one of that name; else put a <group> around the <include>, and the <param> before it"
        )
    if parent == "include" and tag.lower() in ("remap", "param", "rosparam"):
        return f"put the <include> into a <group>, and the <{tag}> into that group before it"
    parents = () if rule is None else rule.parents
    if parents == ("launch", "group"):
        return f"move it out of <{parent}>: it stands in <launch> or <group>"
    return f"move it out of <{parent}>: it stands in {', '.join(f'<{name}>' for name in parents)}" if parents else "remove it"


def _ros2(problem: MisplacedEntity) -> Finding:
    tag, parent, holders = problem.tag, problem.parent, problem.holders
    if tag in _INSTEAD and parent in ("include", "group", "launch", "timer"):
        advice = _INSTEAD[tag]
    elif problem.action:
        advice = f"move it out of {parent}: it stands in launch or group"
    else:
        advice = f"move it: it stands in {', '.join(holders)}"
    if parent == "include" and tag == "let":
        advice = "write arg: it passes a value to the included file"
    elif parent == "include" and tag == "param":
        advice = "write <arg> if the included file declares one of that name; else <set_parameter>, in a <group> around the <include>"
    return RULE.at(
        problem.origin,
        f"{tag} cannot stand inside {parent}",
        severity=Severity.ERROR,
        label=f"not in {parent}",
        notes=("ros2 launch refuses the file",),
        help=advice,
        cause=f"{problem.place.source.path} {tag} {parent}",
    )


_INSTEAD = {
    "remap": "write <set_remap>, in a <group> around the <include> or before the nodes; a <remap> stands in its <node>",
    "param": "write <set_parameter>, in a <group> around it or before the nodes; a <param> stands in its <node>",
    "env": "write <set_env> before the nodes; an <env> stands in its <node>",
    "composable_node": "put it into a <node_container>, or into a <load_composable_node>",
}

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

## Example

```xml
<launch>
  <nodes pkg="map_server" type="map_server" name="map_server"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server"/>
</launch>
```

## Fix

`--fix` writes the tag that the name is one slip away from (`<nodes>` becomes `<node>`), where there is only one; a name that is further
off takes `--unsafe-fixes`. What the element says takes effect then: the node is started, the parameter set.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import Spot, fix, rename_tag, spot
from launchlint.rules.judging.joined import joined
from launchlint.rules.rule import Rule
from launchlint.spelling import closest, surely, switched_off
from launchlint.syntax.problems import UnknownTag
from launchlint.syntax.ros1.dialect import TAGS
from launchlint.syntax.tree import Element

RULE = Rule("LL103", "unknown-tag", Severity.WARNING, roslaunch="reports", fixable="safe")

_CUSTOM = 3
"""Places in which a tag of nobody's is no slip any more: nobody makes one slip of many letters three times."""


def tell(problem: UnknownTag, view: object) -> Iterator[Finding]:
    """Name the tag that was meant."""
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
        label="skipped",
        notes=(said,),
        help=advice,
        fix=None if near is None else _fix(near, sure=surely(tag, known) == near, at=at),
        cause=f"tag {tag}" if near is None and at is not None and not _holds_known(at.element) else "",
    )


def together(findings: Sequence[Finding]) -> Finding:
    """What one tag without a meaning comes to in several places."""
    told = joined(findings)
    places = {finding.location for finding in findings}
    if len(places) < _CUSTOM:
        return told
    note = f"it stands in {len(places)} places: a custom of the house, for a program that reads it"
    return told._replace(
        severity=Severity.INFO, notes=(*told.notes, note), help="put such words into a comment, which roslaunch skips silently"
    )


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
